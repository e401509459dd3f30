// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_data_page.h"

#include "config/module_slots.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

QString slotText(const Project& project, const settings::Place& place) {
  const auto places = slot_places(project.slaves[place.slave].device);
  if (place.item >= places.size()) return {};
  return QStringLiteral("%1  %2").arg(place.item).arg(QString::fromStdString(places[place.item].slot->name)).trimmed();
}

/// The modules that fit into a place.
std::vector<settings::Option> modulesOf(const Project& project, const settings::Place& place) {
  std::vector<settings::Option> options{{settings::Value{}, "none", {}}};
  const auto& device = project.slaves[place.slave].device;
  const auto places = slot_places(device);
  if (!device.slots || place.item >= places.size()) return options;
  for (const auto& module : device.modules) {
    if (!accepts(*places[place.item].slot, module)) continue;
    const auto ident = hexText(module.ident, 8).toStdString();
    options.push_back({std::int64_t{module.ident}, ident, ident + "  " + module.type});
  }
  return options;
}

QString pdoText(const Project& project, const settings::Place& place) {
  const auto pdo = pdo_of(project.slaves[place.slave], place.item);
  return QStringLiteral("%1  %2").arg(hexText(place.item, 4), pdo ? QString::fromStdString(pdo->name) : QString());
}

std::vector<settings::Option> unitsOf(const Project& project, const settings::Place&) {
  std::vector<settings::Option> options{{std::string(), "", "None (base task)"}};
  for (const auto& unit : project.master.sync_units) options.push_back({unit.name, unit.name, unit.name});
  return options;
}

}  // namespace

SlaveDataPage::SlaveDataPage(Workspace& workspace) : Page(workspace, "slaveDataPage", tr("Data Options")) {
  auto* columns = new CardColumns;
  fields().items(*columns->add(0, tr("Modules")), "slave.N.module.K", slotText, modulesOf);
  fields().items(*columns->add(1, tr("Oversampling")), "slave.N.pdo.oversampling.0xIIII", pdoText);
  fields().chosen(*columns->add(1, tr("Sync Units")), {"slave.N.sync_unit.outputs", "slave.N.sync_unit.inputs"},
                  unitsOf, [this](const SlaveSettings& slave) {
                    return !project().master.sync_units.empty() || !slave.output_unit.empty() ||
                           !slave.input_unit.empty();
                  });
  columns->addStretch();
  setWidget(columns);
}

bool SlaveDataPage::appliesTo(int slave) const { return slave >= 0 && fields().wanted(slave); }

void SlaveDataPage::refresh() { fields().refresh(); }

}  // namespace syncline::ui
