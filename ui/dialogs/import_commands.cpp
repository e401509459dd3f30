// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/import_commands.h"

#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "eni/format/eni_file.h"
#include "recover/recover_project.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/event_text.h"

namespace syncline::ui {
namespace {

std::vector<Identity> identitiesOf(const NetworkConfig& config) {
  std::vector<Identity> identities;
  for (const auto& slave : config.slaves) {
    if (std::ranges::find(identities, slave.identity) == identities.end()) identities.push_back(slave.identity);
  }
  return identities;
}

/// The device for an identity; their serial numbers are of slaves, not of devices.
DeviceLookup lookupIn(const std::vector<DeviceDescription>& devices) {
  return [&devices](const Identity& identity) -> const DeviceDescription* {
    const auto found = std::ranges::find_if(devices, [&](const DeviceDescription& device) {
      const auto& own = device.identity;
      return own.vendor_id == identity.vendor_id && own.product_code == identity.product_code &&
             own.revision_no == identity.revision_no;
    });
    return found == devices.end() ? nullptr : &*found;
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
  auto& document = workspace_.document();
  workspace_.catalogue().devices(identitiesOf(*config), this,
                                 [this, path, may, config = *config,
                                  generation = document.generation()](const std::vector<DeviceDescription>& devices) {
                                   // Somebody opened something else since.
                                   if (workspace_.document().generation() != generation || !may()) return;
                                   take(path, recover_project(config, lookupIn(devices)));
                                 });
}

void ImportCommands::take(const QString& path, RecoveredProject recovered) {
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
