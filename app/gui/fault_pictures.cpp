// SPDX-License-Identifier: Apache-2.0
#include "app/gui/fault_pictures.h"

#include <QDir>
#include <QPixmap>
#include <QTextStream>

#include "app/gui/picture_run.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline {
namespace {

constexpr Nanoseconds kShown = 11 * kSecond;  // of the machine, from the scan on

bool runScenario(ui::MainWindow& window, ui::Workspace& workspace, const QString& file) {
  workspace.live().shutDown();
  workspace.messages().clearLog();
  return runForPictures(window, workspace, QStringLiteral("sim:%1?virtual").arg(file), kShown);
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
