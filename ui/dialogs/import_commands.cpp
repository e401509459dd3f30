// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/import_commands.h"

#include <QFileInfo>
#include <QWidget>
#include <utility>

#include "recover/recover_project.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/session/eni_machine.h"
#include "ui/session/workspace.h"
#include "ui/text/event_text.h"

namespace syncline::ui {
ImportCommands::ImportCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window) {}

void ImportCommands::importEni(const QString& path, const std::function<bool()>& may) {
  const auto generation = workspace_.document().generation();
  const auto status =
      readEniMachine(path, workspace_.catalogue(), this, [this, path, may, generation](RecoveredProject recovered) {
        // Somebody opened something else since.
        if (workspace_.document().generation() == generation && may()) take(path, std::move(recovered));
      });
  if (status) return;
  workspace_.report(status.error(), Severity::kError, tr("Open"));
  showError(&window_, tr("The ENI could not be read."), status.error());
}

void ImportCommands::take(const QString& path, RecoveredProject recovered) {
  workspace_.runs().shutDown();
  workspace_.recording().close();
  workspace_.document().take(Machine{{}, {std::move(recovered.project)}}, {}, false);
  for (const auto& finding : recovered.findings)
    workspace_.messages().append(messageOf(finding, workspace_.document().project()));
  const auto differences = static_cast<int>(recovered.differences.size());
  workspace_.inform(
      tr("Open"),
      tr("A project was made of %1; exported again, %n command(s) would differ.", nullptr, differences).arg(path));
}

void ImportCommands::addEsiFolder(const QString& path) {
  const auto folder = QFileInfo(path).absolutePath();
  if (!ask(window_, "esiQuestion", tr("Add the folder of this device description to the catalogue?"),
           tr("All ESI files below %1 are read; scans then know their devices.").arg(folder), tr("Add Folder"))) {
    return;
  }
  workspace_.inform(tr("Catalogue"), tr("Reading the ESI files below %1 …").arg(folder));
  workspace_.catalogue().add({folder});
}

}  // namespace syncline::ui
