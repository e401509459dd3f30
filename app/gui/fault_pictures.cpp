// SPDX-License-Identifier: Apache-2.0
#include "app/gui/fault_pictures.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QPixmap>
#include <QTextStream>

#include "ui/dialogs/bus_commands.h"
#include "ui/main_window.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/session/workspace.h"

namespace syncline {
namespace {

constexpr qint64 kOnlineTimeoutMs = 60'000;
constexpr int kTenths = 110;  // of a second of the machine, from the scan on

bool runScenario(ui::MainWindow& window, ui::Workspace& workspace, const QString& file) {
  auto& live = workspace.live();
  live.shutDown();
  workspace.messages().clearLog();
  live.setAutoAdvance(false);
  window.bus().startDemo(QStringLiteral("sim:%1?virtual").arg(file));
  QElapsedTimer waiting;
  waiting.start();
  while (live.phase() == ui::LiveSession::Phase::kOffline && waiting.elapsed() < kOnlineTimeoutMs)
    QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
  if (live.phase() == ui::LiveSession::Phase::kOffline) return false;
  for (int i = 0; i < kTenths; ++i) {
    live.advance(100 * kMillisecond);
    QApplication::processEvents();
  }
  return live.phase() == ui::LiveSession::Phase::kOnline;
}

void showOverview(ui::MainWindow& window) {
  window.selectNode(-1);
  window.findChild<QAction*>(QStringLiteral("actionOverview"))->trigger();
  for (int round = 0; round < 3; ++round) QApplication::processEvents();  // layouts ask for another one
  window.findChild<ui::OverviewPanel*>()->refresh();
  window.findChild<ui::LiveStrip*>()->refresh();
  QApplication::processEvents();
}

}  // namespace

bool renderFaultPictures(ui::MainWindow& window, ui::Workspace& workspace, const QString& scenarios,
                         const QString& folder) {
  QTextStream err(stderr);
  const QDir source(scenarios), target(folder);
  const auto files = source.entryList({QStringLiteral("*.toml")}, QDir::Files, QDir::Name);
  if (files.isEmpty()) err << "no scenario (*.toml) in " << scenarios << '\n';
  bool good = !files.isEmpty() && target.mkpath(QStringLiteral("."));
  for (const auto& file : files) {
    const bool online = runScenario(window, workspace, source.absoluteFilePath(file));
    showOverview(window);
    const auto picture = target.filePath(QFileInfo(file).completeBaseName() + QStringLiteral(".png"));
    const bool saved = window.grab().save(picture);
    if (!online) err << file << " did not go online\n";
    if (!saved) err << "cannot write " << picture << '\n';
    good = good && online && saved;
  }
  workspace.live().shutDown();
  return good;
}

}  // namespace syncline
