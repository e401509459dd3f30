// SPDX-License-Identifier: Apache-2.0
#include "ui/machine_building.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QStatusBar>
#include <utility>

#include "ui/dialogs/slave_commands.h"
#include "ui/panels/catalogue_panel.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/topology_view.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"

namespace syncline::ui {
namespace {

PreviousPort portOf(int position, int port) {
  return {static_cast<std::uint16_t>(position), static_cast<std::uint8_t>(port)};
}

}  // namespace

MachineBuilding::MachineBuilding(Workspace& workspace, QMainWindow& window, std::function<bool()> commit)
    : QObject(&window), workspace_(workspace), window_(window) {
  auto& catalogue = workspace.catalogue();
  commands_ = new SlaveCommands(workspace, catalogue, window, std::move(commit));
  panel_ = new CataloguePanel(catalogue);
  dock_ = new QDockWidget(tr("Device Catalogue"));
  dock_->setObjectName(QStringLiteral("catalogueDock"));
  dock_->setWidget(panel_);
  connect(panel_, &CataloguePanel::deviceWanted, commands_, &SlaveCommands::addDevice);
  connect(commands_, &SlaveCommands::catalogueWanted, this, [this] {
    dock_->show();
    dock_->raise();
    panel_->begin();
  });
  connect(commands_, &SlaveCommands::told, this, &MachineBuilding::report);
  connect(&catalogue, &DeviceCatalogue::added, this, [this](int devices) {
    if (devices > 0) workspace_.inform(tr("Catalogue"), tr("%n new device(s) are in the catalogue.", nullptr, devices));
  });
  connect(&catalogue, &DeviceCatalogue::failed, this,
          [this](const Error& error) { workspace_.report(error, Severity::kWarning, tr("Catalogue")); });
  const auto tell = [this](Severity severity) {
    return [this, severity](const eni::FileWarning& warning) {
      workspace_.messages().append(
          {QDateTime::currentDateTime(), severity, tr("Catalogue"), warningText(warning), -1, {}});
    };
  };
  connect(&catalogue, &DeviceCatalogue::warned, this, tell(Severity::kWarning));
  connect(&catalogue, &DeviceCatalogue::noted, this, tell(Severity::kNote));
  connect(&workspace, &Workspace::mayEditSlavesChanged, this, &MachineBuilding::showWhetherSlavesStay);
  showWhetherSlavesStay();
}

void MachineBuilding::report(const QString& text) { window_.statusBar()->showMessage(text, 10'000); }

void MachineBuilding::showWhetherSlavesStay() { panel_->setObstacle(workspace_.whySlavesStay()); }

/// The explorer says what is wanted, the commands do it.
void MachineBuilding::tieTo(ExplorerPanel& explorer) {
  explorer.setCommands(commands_->all());
  connect(&explorer, &ExplorerPanel::nodeSelected, commands_, &SlaveCommands::setNode);
  connect(commands_, &SlaveCommands::nodeWanted, &explorer, &ExplorerPanel::select);
  const auto drop = [this](qint64 device, DropPlace place) {
    if (const auto* entry = panel_->dragged(device)) commands_->addDeviceTo(*entry, place);
  };
  auto& network = workspace_.network();
  connect(&network, &NetworkModel::slaveDropped, commands_, &SlaveCommands::move);
  connect(&network, &NetworkModel::deviceDropped, this, drop);
  auto& topology = explorer.topology();
  connect(&topology, &TopologyView::deviceDropped, this, drop);
  connect(&topology, &TopologyView::deviceDroppedAt, this, [this](qint64 device, int position, int port) {
    if (const auto* entry = panel_->dragged(device)) commands_->addDeviceAt(*entry, portOf(position, port));
  });
  connect(&topology, &TopologyView::rewireWanted, commands_,
          [this](int slave, int position, int port) { commands_->rewire(slave, portOf(position, port)); });
}

}  // namespace syncline::ui
