// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/sync_unit_editor.h"

#include <QComboBox>
#include <QSignalBlocker>

#include "config/dc_times.h"
#include "ui/session/setting_keys.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/time_edit.h"

namespace syncline::ui {
namespace {

constexpr int kFactors[] = {1, 2, 3, 4, 5, 8, 10, 16, 32, 64, -2, -3, -4, -5, -8, -10, -16, -32, -64};
// Data of the choices that are no factor; a factor of 0 does not exist.
const QString kMode = QStringLiteral("mode");
const QString kUser = QStringLiteral("user");

Nanoseconds timesFactor(Nanoseconds cycle, int factor) {
  if (factor == 0) return 0;
  return factor > 0 ? cycle * factor : cycle / -factor;
}

QString key(const char* name) { return QLatin1String(name); }

}  // namespace

SyncUnitView syncUnitView(int unit, const DcOpMode& mode, const DcSlaveSettings& settings, Nanoseconds bus_cycle) {
  SyncUnitView view;
  view.settings = unit == 0 ? settings.sync0 : settings.sync1;
  view.bus_cycle = bus_cycle;
  // The compiler's own rule decides. It gives SYNC1 as the distance from SYNC0, its shift included; with
  // a shift of 0 the cycle is the sum.
  const auto cycle = [&](const SyncUnitSettings& choice) {
    auto asked = settings;
    (unit == 0 ? asked.sync0 : asked.sync1) = choice;
    if (unit == 1) asked.sync1.shift = 0;
    const auto times = compiler::dc_times(mode, asked, bus_cycle);
    return unit == 0 ? times.cycle_time0 : times.cycle_time0 + times.cycle_time1;
  };
  view.proposed_cycle = cycle({});
  view.effective_cycle = cycle(view.settings);
  const auto& shift = unit == 0 ? mode.shift_time_sync0 : mode.shift_time_sync1;
  view.effective_shift = view.settings.shift.value_or(shift.value_ns + timesFactor(bus_cycle, shift.factor.value_or(0)));
  return view;
}

SyncUnitEditor::SyncUnitEditor(int unit, Card& card, QObject* parent) : QObject(parent), unit_(unit) {
  const auto title = QStringLiteral("SYNC%1").arg(unit);
  const auto object = [unit](const char* name) { return QStringLiteral("sync%1%2").arg(unit).arg(QLatin1String(name)); };
  choice_ = named(new QComboBox, "", tr("Sync Unit Cycle of %1").arg(title));
  choice_->setObjectName(object("Factor"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(16);
  connect(choice_, &QComboBox::activated, this, &SyncUnitEditor::takeChoice);
  card.addRow(tr("Sync Unit Cycle"), choice_,
              tr("Multiple or fraction of the bus cycle; the operation mode of the ESI proposes one"));
  cycle_ = named(new TimeEdit, "", tr("Cycle of %1").arg(title));
  cycle_->setObjectName(object("Cycle"));
  connect(cycle_, &TimeEdit::editedNs, this, [this, title](Nanoseconds value) {
    Q_EMIT edited(tr("Change cycle of %1").arg(title), {key(keys::kUserCycle), microsecondsSetting(value)});
  });
  card.addRow(tr("Cycle"), cycle_,
              unit == 0 ? tr("Register 0x09A0") : tr("Register 0x09A4 holds the delay from SYNC0 to SYNC1"));
  shift_ = named(new TimeEdit, "", tr("Shift of %1").arg(title));
  shift_->setObjectName(object("Shift"));
  shift_->setRangeNs(-100 * kMillisecond, 100 * kMillisecond);
  connect(shift_, &TimeEdit::editedNs, this, [this, title](Nanoseconds value) {
    Q_EMIT edited(tr("Change shift of %1").arg(title), {key(keys::kShift), microsecondsSetting(value)});
  });
  card.addRow(tr("Shift"), shift_,
              unit == 0 ? tr("Added to the start time, register 0x0990 (ENI DC/ShiftTime)")
                        : tr("Moves SYNC1 only (ENI DC/CycleTime1)"));
}

void SyncUnitEditor::fillChoices(const SyncUnitView& view) {
  choice_->clear();
  choice_->addItem(tr("As operation mode (%1)").arg(cycleText(view.proposed_cycle)), kMode);
  for (const int factor : kFactors) {
    const auto text = factor > 0 ? QStringLiteral("\u00D7 %1").arg(factor) : QStringLiteral("/ %1").arg(-factor);
    choice_->addItem(QStringLiteral("%1  (%2)").arg(text, cycleText(timesFactor(view.bus_cycle, factor))),
                     QString::number(factor));
  }
  choice_->addItem(tr("User defined"), kUser);
}

void SyncUnitEditor::show(const SyncUnitView& view, bool enabled) {
  const QSignalBlocker quiet(choice_);
  if (!enabled) return showOff();
  fillChoices(view);
  auto choice = kMode;
  if (view.settings.cycle_factor) choice = QString::number(*view.settings.cycle_factor);
  if (view.settings.user_cycle) choice = kUser;
  auto row = choice_->findData(choice);
  if (row < 0) {  // a factor that the list does not offer, from the command line
    choice_->insertItem(1, tr("Factor %1").arg(choice), choice);
    row = 1;
  }
  choice_->setCurrentIndex(row);
  cycle_->showNs(view.effective_cycle);
  shift_->showNs(view.effective_shift);
  choice_->setEnabled(true);
  cycle_->setEnabled(choice == kUser);
  shift_->setEnabled(true);
}

void SyncUnitEditor::showOff() {
  choice_->clear();
  choice_->addItem(tr("Off in this operation mode"));
  cycle_->showNs(0);
  shift_->showNs(0);
  choice_->setEnabled(false);
  cycle_->setEnabled(false);
  shift_->setEnabled(false);
}

void SyncUnitEditor::takeChoice() {
  const auto choice = choice_->currentData().toString();
  const auto text = tr("Change Sync Unit Cycle of SYNC%1").arg(unit_);
  if (choice == kMode) {
    Q_EMIT edited(text, {key(keys::kFactor), keys::unset(), key(keys::kUserCycle), keys::unset()});
  } else if (choice == kUser) {
    Q_EMIT edited(text, {key(keys::kFactor), keys::unset(), key(keys::kUserCycle), microsecondsSetting(cycle_->valueNs())});
  } else {
    Q_EMIT edited(text, {key(keys::kFactor), choice, key(keys::kUserCycle), keys::unset()});
  }
}

}  // namespace syncline::ui
