// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/import_commands.h"

#include <QFileInfo>
#include <QWidget>

#include "eni/catalogue/usual_sources.h"
#include "eni/format/eni_file.h"
#include "recover/recover_project.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/event_text.h"

namespace syncline::ui {
namespace {

/// The ESI's device for an identity, where the catalogue has that revision.
DeviceLookup lookupIn(const eni::EsiCatalogue& catalogue) {
  return [&catalogue](const Identity& identity) -> const DeviceDescription* {
    const auto match = catalogue.find(identity);
    return match && match->exact_revision ? match->device : nullptr;
  };
}

}  // namespace

ImportCommands::ImportCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window) {}

void ImportCommands::importEni(const QString& path, const std::function<bool()>& may) {
  const auto config = eni::read_eni(path.toStdString());
  if (!config) {
    workspace_.report(config.error(), Severity::kError, tr("Open"));
    return showError(&window_, tr("The ENI could not be read."), config.error());
  }
  if (!may()) return;
  auto catalogue = eni::EsiCatalogue::open_default();
  std::vector<std::string> folders;
  for (const auto& folder : workspace_.environment().esi_folders) folders.push_back(folder.toStdString());
  for (const auto& error : eni::add_usual_sources(catalogue, std::move(folders)))
    workspace_.report(error, Severity::kWarning, tr("Catalogue"));
  auto recovered = recover_project(*config, lookupIn(catalogue));
  workspace_.live().shutDown();
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
