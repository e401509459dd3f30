// SPDX-License-Identifier: Apache-2.0
#include "app/gui/picture_run.h"

#include <QAction>
#include <QApplication>

#include "ui/dialogs/bus_commands.h"
#include "ui/main_window.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/session/workspace.h"
#include "ui/widgets/wait_until.h"

namespace syncline {
namespace {

constexpr qint64 kTimeoutMs = 60'000;

}  // namespace

bool waitUntil(const std::function<bool()>& done) { return ui::waitUntil(done, kTimeoutMs); }

bool runForPictures(ui::MainWindow& window, ui::Workspace& workspace, const QString& link, Nanoseconds duration) {
  using Phase = ui::LiveSession::Phase;
  auto& live = workspace.live();
  live.setAutoAdvance(false);
  window.bus().startDemo(link);
  if (!waitUntil([&live] { return live.phase() != Phase::kOffline; })) return false;
  for (Nanoseconds run = 0; run < duration; run += 100 * kMillisecond) {
    live.advance(100 * kMillisecond);
    QApplication::processEvents();
  }
  return live.phase() == Phase::kOnline;
}

void showOverview(ui::MainWindow& window) {
  window.selectNode(-1);
  window.findChild<QAction*>(QStringLiteral("actionOverview"))->trigger();
  window.findChild<ui::OverviewPanel*>()->refresh();
  window.findChild<ui::LiveStrip*>()->refresh();
  for (int round = 0; round < 3; ++round) QApplication::processEvents();  // layouts ask for another one
}

}  // namespace syncline
