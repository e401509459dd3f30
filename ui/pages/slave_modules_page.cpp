// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_modules_page.h"

#include "config/module_slots.h"
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

}  // namespace

SlaveModulesPage::SlaveModulesPage(Workspace& workspace) : Page(workspace, "slaveModulesPage", tr("Modules")) {
  auto* columns = new CardColumns;
  fields().items(*columns->add(0, tr("Modules in Slots")), "slave.N.module.K", slotText, modulesOf);
  columns->addStretch();
  setWidget(columns);
}

bool SlaveModulesPage::appliesTo(int slave) const { return slave >= 0 && fields().wanted(slave); }

void SlaveModulesPage::refresh() { fields().refresh(); }

}  // namespace syncline::ui
