// SPDX-License-Identifier: Apache-2.0
#include "ui/window_overlay.h"

#include <QFileDialog>
#include <QFileInfo>

#include "ui/dialogs/error_dialog.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overlay_bar.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

WindowOverlay::WindowOverlay(Workspace& workspace, LiveStrip& strip, OverlayBar& bar, QWidget& window)
    : QObject(&window), workspace_(workspace), strip_(strip), window_(window), progress_(window) {
  auto& overlay = workspace_.overlay();
  connect(&overlay, &RecordingOverlay::changed, this, &WindowOverlay::show);
  connect(&overlay, &RecordingOverlay::moved, this, &WindowOverlay::show);
  connect(&overlay, &RecordingOverlay::failed, this, &WindowOverlay::fail);
  connect(&overlay, &RecordingOverlay::progress, this, [this](int permille) { progress_.set(permille); });
  connect(&strip_, &LiveStrip::overlayMoved, &overlay,
          [&overlay](Nanoseconds by) { overlay.setOffset(overlay.offset() + by); });
  connect(&bar, &OverlayBar::refused, this, &WindowOverlay::refused);
}

void WindowOverlay::ask() {
  const auto folder = QFileInfo(workspace_.recording().path()).path();
  const auto path = QFileDialog::getOpenFileName(&window_, tr("Overlay Another Recording"), folder,
                                                 tr("Recordings and tables (*.slrec *.csv);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

void WindowOverlay::open(const QString& path) {
  auto& overlay = workspace_.overlay();
  if (overlay.isReading()) return;
  if (!workspace_.recording().isOpen()) return Q_EMIT refused(tr("No recording is shown that another could lie over."));
  progress_.begin(path, "overlayProgress", tr("Overlay Another Recording"), [&overlay] { overlay.cancel(); });
  overlay.read(path);
}

void WindowOverlay::fail(const QString& path, const Error& error) {
  progress_.end();
  if (error.code == ErrorCode::kCancelled) return;
  workspace_.report(error, Severity::kError, tr("Overlay"));
  showError(&window_, tr("The recording %1 could not be opened.").arg(QFileInfo(path).fileName()), error);
}

void WindowOverlay::show() {
  progress_.end();
  const auto& overlay = workspace_.overlay();
  if (!overlay.isOpen() || !workspace_.recording().isOpen()) return strip_.setOverlay({});
  strip_.setOverlay({overlay.run().record.get(), overlay.shift(), overlay.ownName(), overlay.name()});
  strip_.refresh();
}

}  // namespace syncline::ui
