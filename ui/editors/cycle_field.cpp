// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/cycle_field.h"

#include <QHBoxLayout>
#include <QLabel>

#include "support/types.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"
#include "ui/editors/preset_edit.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

constexpr Nanoseconds kUsualCycles[] = {125'000,   250'000,   500'000,   1'000'000,
                                        2'000'000, 4'000'000, 8'000'000, 10'000'000};

}  // namespace

PresetEdit* addCycleField(Page& page, Card& card, QWidget* beside) {
  auto* cycle = page.fields().presetField("masterCycle", "master.cycle_time_us", kUsualCycles);
  auto* field = new QWidget;
  auto* layout = new QHBoxLayout(field);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(cycle, 1);
  field->setFocusProxy(cycle);
  layout->addWidget(new QLabel(QStringLiteral("\u00B5s")));
  if (beside != nullptr) layout->addWidget(beside);
  card.addRow(cycle->accessibleName(), field, cycle->toolTip());
  return cycle;
}

}  // namespace syncline::ui
