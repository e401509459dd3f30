// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_dc_page.h"

#include <QLabel>

#include "config/sync0_cycle.h"
#include "config/sync_unit_cycle.h"
#include "dc/sync_timeline.h"
#include "protocol/assign_activate.h"
#include "protocol/system_time_difference.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/pages/dc_read_back.h"
#include "ui/pages/sync_unit_editor.h"
#include "ui/plots/timing_diagram.h"
#include "ui/session/calc_and_copy.h"
#include "ui/session/running_slave.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

const SlaveSettings* slaveAt(const Project& project, int position) {
  return position >= 0 && static_cast<std::size_t>(position) < project.slaves.size()
             ? &project.slaves[static_cast<std::size_t>(position)]
             : nullptr;
}

}  // namespace

SlaveDcPage::SlaveDcPage(Workspace& workspace)
    : Page(workspace, "slaveDcPage", tr("Distributed Clocks")), read_back_(new DcReadBack(workspace, this)) {
  auto* columns = new CardColumns;
  buildMode(*columns->add(0, tr("Operation Mode")));
  auto* sync0 = columns->add(1, tr("SYNC0"));
  auto* sync1 = columns->add(1, tr("SYNC1"));
  units_ = {sync0, sync1};
  sync0_ = new SyncUnitEditor(0, *sync0, *this);
  fields().keys(*sync0, {"slave.N.dc.sync0.input_reference"});
  sync1_ = new SyncUnitEditor(1, *sync1, *this);
  buildRegisters(*columns->add(0, tr("Registers")));
  buildTiming(*columns->add(2, tr("One Cycle")));
  buildLive(*columns->add(2, tr("Live")));
  columns->addStretch();
  setWidget(columns);
}

bool SlaveDcPage::appliesTo(int slave) const {
  const auto* settings = slaveAt(workspace().document().project(), slave);
  return settings != nullptr && settings->device.dc.has_value();
}

void SlaveDcPage::buildMode(Card& card) {
  fields().choice(card, "operationMode", "slave.N.dc.op_mode")->setMinimumContentsLength(17);
  description_ = card.addValue("operationModeDescription", tr("Meaning"), tr("ESI OpMode/Desc"));
  description_->setWordWrap(true);
  assign_activate_ = card.addValue("assignActivate", tr("AssignActivate"),
                                   tr("ESI OpMode/AssignActivate, written to register 0x0980"));
  bus_cycle_ =
      card.addValue("syncBusCycle", tr("Bus cycle"),
                    tr("Cycle of the task that exchanges the slave's process data, base of the Sync Unit Cycle"));
  fields().toggle(card, "potentialReference", "slave.N.dc.potential_reference_clock");
}

void SlaveDcPage::buildRegisters(Card& card) {
  register_activation_ =
      card.addValue("register0980", tr("0x0980 activation"),
                    tr("Compiled value, as written in PREOP to SAFEOP; online also what the slave has"));
  register_cycle0_ = card.addValue("register09A0", tr("0x09A0 SYNC0 cycle"), tr("Compiled value (ENI DC/CycleTime0)"));
  register_cycle1_ = card.addValue("register09A4", tr("0x09A4 SYNC1"), tr("Compiled value (ENI DC/CycleTime1)"));
  register_shift_ =
      card.addValue("register0990", tr("0x0990 shift"), tr("Compiled part of the start time (ENI DC/ShiftTime)"));
  // What the slave has goes to a second line: a wider card would send the others elsewhere while somebody edits.
  for (auto* label : {register_activation_, register_cycle0_, register_cycle1_, register_shift_})
    label->setWordWrap(true);
}

void SlaveDcPage::buildTiming(Card& card) {
  timing_ = named(new TimingDiagram, "slaveTiming", tr("One cycle of the slave to scale"));
  card.addWide(timing_);
  margin_ = card.addValue("slaveMargin", tr("Before SYNC0"),
                          tr("From the end of the frame with the slave's outputs to the SYNC0 that uses them"));
  compute_ =
      card.addValue("slaveCompute", tr("Calc + copy"),
                    tr("What the slave needs of it: as it tells itself (0x1C32:06), else as its family is known"));
}

void SlaveDcPage::buildLive(Card& card) {
  role_ = named(new Pill, "slaveDcRole", tr("Role"));
  card.addRow(tr("Role"), role_, tr("What this slave's clock does on the bus"));
  deviation_ = card.addValue("slaveDeviation", tr("Deviation"), tr("SystemTimeDifference, register 0x092C"));
  delay_ = card.addValue("slaveDelay", tr("Propagation delay"), tr("Register 0x0928, measured at start-up"));
  missed_ = card.addValue("slaveMissed", tr("Missed SM2 events"), tr("Counter of the device (object 0x1C32)"));
}

void SlaveDcPage::refresh() {
  const auto& project = workspace().document().project();
  const auto* slave = slaveAt(project, node());
  if (slave == nullptr || !slave->device.dc) return;
  const auto* mode = compiler::selected_op_mode(*slave);
  description_->setText(mode != nullptr && !mode->description.empty() ? QString::fromStdString(mode->description)
                                                                      : noText());
  assign_activate_->setText(mode != nullptr ? hexText(mode->assign_activate, 4) : noText());
  const auto cycle = compiler::sync_unit_cycle(project.master, *slave);
  bus_cycle_->setText(cycleText(cycle));
  sync0_->showSlave(*slave, mode, cycle);
  sync1_->showSlave(*slave, mode, cycle);
  fields().refresh();
  alignLabels(units_);
  refreshRegisters();
  refreshTiming();
}

/// The value as it is compiled, and what the slave has where that is another.
void SlaveDcPage::showRegister(QLabel& label, const QString& compiled, const std::optional<QString>& read) {
  const bool differs = read && *read != compiled;
  label.setText(!read     ? compiled
                : differs ? tr("%1, the slave has %2").arg(compiled, *read)
                          : tr("%1, read back").arg(compiled));
  auto colors = palette();
  if (differs) colors.setColor(QPalette::WindowText, theme::toneColor(palette(), theme::Tone::kBad));
  if (label.palette() != colors) label.setPalette(colors);
}

void SlaveDcPage::refreshRegisters() {
  const auto* config = workspace().configuration().config();
  const auto at = static_cast<std::size_t>(node());
  const SlaveDcConfig* dc =
      config != nullptr && at < config->slaves.size() && config->slaves[at].dc ? &*config->slaves[at].dc : nullptr;
  std::optional<QString> activation, cycle0, cycle1, shift;
  const auto running = runningSlave(workspace(), node());
  // Before SAFEOP nobody has written them.
  const bool started = running && running->drives() && running->config->dc;
  if (const auto& read = read_back_->registers(); read && started) {
    activation = hexText(read->activation, 4);
    cycle0 = timeText(read->cycle0);
    cycle1 = timeText(read->cycle1);
  }
  if (started && running->status->evidence.sync0.time != 0) {
    const auto& start = running->status->evidence.sync0;
    shift = start.never ? tr("no SYNC0")
                        : timeText(running->config->dc->shift_time + (start.misplaced() ? start.off_ns : 0));
  }
  showRegister(*register_activation_, dc != nullptr ? hexText(dc->assign_activate, 4) : noText(), activation);
  showRegister(*register_cycle0_, dc != nullptr ? timeText(dc->cycle_time0) : noText(), cycle0);
  showRegister(*register_cycle1_, dc != nullptr ? timeText(dc->cycle_time1) : noText(), cycle1);
  showRegister(*register_shift_, dc != nullptr ? timeText(dc->shift_time) : noText(), shift);
}

/// Online with the delay that was measured and the time that the slave tells.
void SlaveDcPage::refreshTiming() {
  const auto* config = workspace().configuration().config();
  const auto at = static_cast<std::size_t>(node());
  auto timing = config != nullptr && node() >= 0 ? dc::slave_timing(*config, at) : std::nullopt;
  if (timing) {
    const auto running = runningSlave(workspace(), node());
    const auto* status = running ? running->status : nullptr;
    timing->compute = calcAndCopy(config->slaves[at].identity, status != nullptr ? &status->evidence : nullptr);
    if (status != nullptr) {
      if (status->dc_enabled) timing->delay = status->propagation_delay_ns;
      if (const auto set_value = workspace().live().snapshot().dcm.set_value_ns; set_value > 0)
        timing->set_value = set_value;
    }
  }
  timing_->setTiming(timing);
  const auto& line = timing_->timeline();
  margin_->setText(line.margin ? timeText(*line.margin) : noText());
  compute_->setText(timing && timing->compute ? timeText(*timing->compute) : noText());
}

void SlaveDcPage::showLive(const Snapshot& snapshot) {
  if (isVisible()) read_back_->tick(node(), snapshot.time);
  refreshRegisters();
  refreshTiming();
  const auto running = runningSlave(workspace(), node());
  const SlaveStatus* status = running ? running->status : nullptr;
  if (status == nullptr) {
    role_->setState(theme::Tone::kNeutral, tr("Offline"));
  } else if (status->is_reference_clock) {
    role_->setState(theme::Tone::kAccent, tr("Reference clock"));
  } else {
    role_->setState(status->follows ? theme::Tone::kGood : theme::Tone::kNeutral, status->follows ? tr("Follows")
                                                                                  : status->dc_enabled
                                                                                      ? tr("Does not follow")
                                                                                      : tr("DC off"));
  }
  deviation_->setText(status != nullptr && status->deviation_valid && status->follows
                          ? signedTimeText(status->deviation_ns)
                          : noText());
  delay_->setText(status != nullptr && status->dc_enabled ? timeText(status->propagation_delay_ns) : noText());
  missed_->setText(status == nullptr ? noText() : missedText(status->sm2_missed));
}

QString SlaveDcPage::missedText(const Sm2MissedStatus& missed) {
  if (missed.valid) {
    return tr("%1 (object %2:%3)")
        .arg(countText(missed.total()), hexText(missed.index, 4), hexText(missed.sub_index, 2).mid(2));
  }
  return missed.known ? tr("%1 (computed: it has no counter)").arg(countText(missed.missed)) : noText();
}

}  // namespace syncline::ui
