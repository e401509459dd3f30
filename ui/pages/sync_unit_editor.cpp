// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/sync_unit_editor.h"

#include "config/sync0_cycle.h"
#include "protocol/assign_activate.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/session/project_document.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kFactors[] = {1, 2, 3, 4, 5, 8, 10, 16, 32, 64, -2, -3, -4, -5, -8, -10, -16, -32, -64};
// Data of the choices that are no factor; a factor of 0 does not exist.
const QString kMode = QStringLiteral("mode");
const QString kUser = QStringLiteral("user");

struct Names {
  const char *factor, *cycle, *shift;                 // keys
  const char *factor_name, *cycle_name, *shift_name;  // of the fields
};
constexpr Names kNames[] = {{"slave.N.dc.sync0.factor", "slave.N.dc.sync0.cycle_us", "slave.N.dc.sync0.shift_us",
                             "sync0Factor", "sync0Cycle", "sync0Shift"},
                            {"slave.N.dc.sync1.factor", "slave.N.dc.sync1.cycle_us", "slave.N.dc.sync1.shift_us",
                             "sync1Factor", "sync1Cycle", "sync1Shift"}};

constexpr Nanoseconds kUsualCycle = 125 * kMicrosecond;  // as long as they are written

QString asModeText(Nanoseconds proposed) {
  return SyncUnitEditor::tr("As operation mode (%1)").arg(cycleText(proposed));
}

/// So many of the characters that a combo box counts its room in.
int charactersOf(const QWidget& box, const QString& text) {
  const auto metrics = box.fontMetrics();
  return metrics.horizontalAdvance(text) / metrics.horizontalAdvance(u'X') + 1;
}

}  // namespace

SyncUnitEditor::SyncUnitEditor(int unit, Card& card, Page& page) : QObject(&page), page_(page), unit_(unit) {
  const auto& names = kNames[unit];
  const auto title = QStringLiteral("SYNC%1").arg(unit);
  choice_ = named(new ChoiceEdit, names.factor_name, tr("Sync Unit Cycle of %1").arg(title));
  choice_->setMinimumContentsLength(charactersOf(*choice_, asModeText(kUsualCycle)));
  connect(choice_, &QComboBox::activated, this, &SyncUnitEditor::takeChoice);
  page.fields().bind(*choice_, names.factor);
  card.addRow(tr("Sync Unit Cycle"), choice_, choice_->toolTip());
  cycle_ = page.fields().number(card, names.cycle_name, names.cycle, tr("Cycle"));
  cycle_->setAccessibleName(tr("Cycle of %1").arg(title));
  cycle_tip_ = cycle_->toolTip();
  shift_ = page.fields().number(card, names.shift_name, names.shift, tr("Shift"));
  shift_->setAccessibleName(tr("Shift of %1").arg(title));
}

void SyncUnitEditor::fillChoices(Nanoseconds proposed, Nanoseconds bus_cycle) {
  choice_->clear();
  choice_->addItem(asModeText(proposed), kMode);
  for (const int factor : kFactors) {
    const auto text = factor > 0 ? QStringLiteral("\u00D7 %1").arg(factor) : QStringLiteral("/ %1").arg(-factor);
    choice_->addItem(QStringLiteral("%1  (%2)").arg(text, cycleText(compiler::scaled_cycle(bus_cycle, factor))),
                     QString::number(factor));
  }
  choice_->addItem(tr("User defined"), kUser);
}

void SyncUnitEditor::showSlave(const SlaveSettings& slave, const DcOpMode* mode, Nanoseconds bus_cycle) {
  const AssignActivate activate{mode != nullptr ? mode->assign_activate : std::uint16_t{0}};
  const bool enabled = unit_ == 0 ? activate.sync0() : activate.sync1();
  choice_->setEnabled(enabled);
  shift_->setEnabled(enabled);
  if (!enabled) {
    choice_->clear();
    choice_->addItem(tr("Off in this operation mode"));
    cycle_->setEnabled(false);
    return;
  }
  auto proposed = slave.dc;
  (unit_ == 0 ? proposed.sync0 : proposed.sync1) = {};
  fillChoices(compiler::sync_cycle(*mode, proposed, unit_, bus_cycle), bus_cycle);
  const auto& settings = unit_ == 0 ? slave.dc.sync0 : slave.dc.sync1;
  auto choice = kMode;
  if (settings.cycle_factor) choice = QString::number(*settings.cycle_factor);
  if (settings.user_cycle) choice = kUser;
  auto row = choice_->findData(choice);
  if (row < 0) {  // a factor that the list does not offer, from the command line
    choice_->insertItem(1, tr("Factor %1").arg(choice), choice);
    row = 1;
  }
  choice_->setCurrentIndex(row);
  cycle_->setEnabled(choice == kUser);
  cycle_->setToolTip(choice == kUser
                         ? cycle_tip_
                         : tr("Choose \"User defined\" above to set it.") + QStringLiteral("\n\n") + cycle_tip_);
}

void SyncUnitEditor::takeChoice() {
  const auto choice = choice_->currentData().toString();
  const auto& names = kNames[unit_];
  settings::Value factor, cycle;
  if (choice == kUser) {
    cycle = std::int64_t{cycle_->value()};
  } else if (choice != kMode) {
    factor = std::int64_t{choice.toInt()};
  }
  const auto place = page_.fields().place();
  page_.set(tr("Change Sync Unit Cycle of SYNC%1").arg(unit_),
            {{&settings::row(names.factor), place, factor}, {&settings::row(names.cycle), place, cycle}});
}

}  // namespace syncline::ui
