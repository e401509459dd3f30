// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_data_page.h"

#include "config/module_slots.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

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
  fields().items(*columns->add(0, tr("Oversampling")), "slave.N.pdo.oversampling.0xIIII", pdoText);
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
