// SPDX-License-Identifier: Apache-2.0
#include "ui/window_centre.h"

#include <QSplitter>
#include <QVBoxLayout>

#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overlay_bar.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/recording_bar.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/run_bar.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

constexpr int kPagesHeight = 385, kPlotsHeight = 215;  // of a new window, and their shares of another one

QVBoxLayout* closeColumn(QWidget& area) {
  auto* layout = new QVBoxLayout(&area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  return layout;
}

}  // namespace

WindowCentre::WindowCentre(Workspace& workspace, QWidget* welcome)
    : editor_(new DeviceEditor(workspace)),
      overview_(new OverviewPanel),
      strip_(new LiveStrip),
      bar_(new RunBar(workspace.runDifference())),
      replay_bar_(new ReplayBar(workspace.replay())),
      overlay_bar_(new OverlayBar(workspace.overlay(), workspace.trigger())),
      splitter_(new QSplitter(Qt::Vertical)),
      upper_(new QStackedWidget) {
  strip_->setObjectName(QStringLiteral("liveStrip"));
  strip_->setAccessibleName(MainWindow::tr("Live plots"));
  strip_->setMinimumWidth(600);
  strip_->setMaximumHeight(strip_->minimumHeight());
  upper_->addWidget(editor_);
  upper_->addWidget(overview_);
  // Below the pages: what comes and goes with an edit moves no field away from the pointer.
  auto* pages = new QWidget;
  auto* column = closeColumn(*pages);
  column->addWidget(upper_, 1);
  column->addWidget(bar_);
  splitter_->setObjectName(QStringLiteral("centreSplitter"));
  splitter_->addWidget(pages);
  splitter_->addWidget(strip_);
  splitter_->setChildrenCollapsible(false);
  splitter_->setStretchFactor(0, 3);
  splitter_->setStretchFactor(1, 2);
  auto* working = new QWidget;
  auto* layout = closeColumn(*working);
  layout->addWidget(new RecordingBar(workspace.recording(), replay_bar_));
  layout->addWidget(overlay_bar_);
  layout->addWidget(splitter_, 1);
  addWidget(welcome);
  addWidget(working);
}

bool WindowCentre::showsOverview() const { return upper_->currentWidget() == overview_; }

QByteArray WindowCentre::pageSizes() const {
  if (!plots_) return plot_sizes_;
  return showsOverview() ? page_sizes_ : splitter_->saveState();
}

void WindowCentre::setPageSizes(const QByteArray& sizes) {
  if (!plots_) {
    plot_sizes_ = sizes;
  } else if (showsOverview()) {
    page_sizes_ = sizes;
  } else if (sizes.isEmpty()) {
    splitter_->setSizes({kPagesHeight, kPlotsHeight});
  } else {
    splitter_->restoreState(sizes);
  }
}

void WindowCentre::resetSizes() {
  splitter_->setSizes({kPagesHeight, kPlotsHeight});
  if (!plots_) plot_sizes_.clear();
}

void WindowCentre::showStrip(bool something) {
  if (something == plots_) return;
  const auto sizes = pageSizes();
  plots_ = something;
  strip_->setMaximumHeight(something ? QWIDGETSIZE_MAX : strip_->minimumHeight());
  setPageSizes(sizes);
}

/// The overview needs less room than the pages; what it leaves is the plots'. The pages find theirs as they left it.
void WindowCentre::showOverview(bool overview) {
  if (overview == showsOverview()) return;
  const auto sizes = splitter_->sizes();
  const auto page_sizes = overview ? splitter_->saveState() : page_sizes_;
  upper_->setCurrentWidget(overview ? static_cast<QWidget*>(overview_) : editor_);
  page_sizes_ = page_sizes;
  if (!overview) {
    if (plots_) setPageSizes(page_sizes_);
    return;
  }
  const int height = overview_->sizeHint().height();
  splitter_->setSizes({height, sizes.front() + sizes.back() - height});
}

}  // namespace syncline::ui
