// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_general_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/dialogs/cycle_dialog.h"
#include "ui/editors/cycle_field.h"
#include "ui/editors/field_binder.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

/// Payload of the cyclic frames in bytes: datagram headers, data and working counters.
std::size_t cyclicBytes(const NetworkConfig& config) {
  std::size_t bytes = 0;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      bytes += 16;  // Ethernet header and EtherCAT header
      for (const auto& command : frame.commands) bytes += 12U + command.length();
    }
  }
  return bytes;
}

}  // namespace

MasterGeneralPage::MasterGeneralPage(Workspace& workspace) : Page(workspace, "masterGeneralPage", tr("General")) {
  auto* columns = new CardColumns;
  buildSettings(*columns->add(0, tr("Settings")));
  auto* information = columns->add(0, tr("Configuration"));
  slaves_ = information->addValue("masterSlaves", tr("Slaves"), tr("Configured slaves"));
  dc_slaves_ = information->addValue("masterDcSlaves", tr("Slaves with DC"),
                                     tr("Slaves whose distributed clock is set up (ENI Slave/DC)"));
  inputs_ = information->addValue("masterInputs", tr("Inputs"), tr("Input process image (ENI ProcessImage/Inputs)"));
  outputs_ =
      information->addValue("masterOutputs", tr("Outputs"), tr("Output process image (ENI ProcessImage/Outputs)"));
  frame_ = information->addValue("masterFrame", tr("Cyclic frames"),
                                 tr("Bytes and time on the wire at 100 Mbit/s, each cycle"));
  buildStateMachine(*columns->add(1, tr("State Machine")));
  buildRecovery(*columns->add(1, tr("Recovery")));
  buildCounters(*columns->add(1, tr("Bus")));
  fields().keys(*columns->add(0, tr("Frame Addresses")), {"master.destination_mac", "master.source_mac"});
  fields().keys(*columns->add(2, tr("Process Image")),
                {"master.image.logical_start", "master.image.alignment", "master.image.bit_packing"});
  fields().keys(*columns->add(2, tr("Real Time")), {"master.real_time.spin_us", "master.real_time.cpu"});
  columns->addStretch();
  setWidget(columns);
}

void MasterGeneralPage::buildSettings(Card& card) {
  fields().text(card, "masterName", "master.name");
  auto* cycles = named(new QPushButton(tr("Accepted…")), "masterCycles", tr("Cycles that the slaves accept"));
  cycles->setToolTip(tr("Cycle times that all slaves accept, who refuses the others, and why"));
  connect(cycles, &QPushButton::clicked, this, [this] {
    CycleDialog dialog(project(), this);
    dialog.exec();
    if (dialog.taken() > 0) fields().set("master.cycle_time_us", dialog.taken());
  });
  addCycleField(*this, card, cycles);
  fields().text(card, "networkName", "network.name");
  fields().toggle(card, "masterOverlap", "master.overlap_process_data");
}

void MasterGeneralPage::buildRecovery(Card& card) {
  fields().toggle(card, "recoveryAutomatic", "master.recovery.automatic");
  fields().toggle(card, "recoveryIncomplete", "master.recovery.start_incomplete");
  fields().number(card, "recoveryErrorTries", "master.recovery.error_tries");
}

void MasterGeneralPage::buildStateMachine(Card& card) {
  state_ = named(new Pill, "masterState", tr("Current state"));
  card.addRow(tr("Current state"), state_, tr("Lowest state of all slaves (register 0x0130)"));
  requested_ =
      card.addValue("masterRequestedState", tr("Requested state"), tr("State asked for last (register 0x0120)"));
  auto* buttons = new QWidget;
  auto* layout = new QHBoxLayout(buttons);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(6);
  for (const auto state : {AlState::kInit, AlState::kPreop, AlState::kSafeop, AlState::kOp}) {
    auto* button = new QPushButton(stateName(state));
    button->setObjectName(QStringLiteral("masterRequest%1").arg(stateName(state)));
    button->setAccessibleName(tr("Request state %1").arg(stateName(state)));
    button->setToolTip(tr("Request %1 for all slaves (register 0x0120)").arg(stateName(state)));
    connect(button, &QPushButton::clicked, this, [this, state] { workspace().live().requestState(state); });
    layout->addWidget(button, 1);
    state_buttons_.append(button);
  }
  card.addWide(buttons);
}

void MasterGeneralPage::buildCounters(Card& card) {
  found_ = card.addValue("masterFound", tr("Slaves answering"), tr("Slaves that answered the last state reading"));
  cycles_ = card.addValue("masterCycles", tr("Cycles"), tr("Bus cycles since going online"));
  lost_ = card.addValue("masterLost", tr("Lost frames"), tr("Frames that did not come back"));
  late_ = card.addValue("masterLate", tr("Late frames"), tr("Frames that came back after their cycle"));
  wkc_ = card.addValue("masterWkc", tr("Working counter errors"),
                       tr("Cycles whose working counter was not the expected one"));
  overruns_ = card.addValue("masterOverruns", tr("Cycles left out"),
                            tr("Cycles without a frame: the host came too late for them"));
}

void MasterGeneralPage::refresh() {
  fields().refresh();
  slaves_->setText(countText(project().slaves.size()));
  const auto* config = workspace().configuration().config();
  const auto none = QStringLiteral("\u2013");
  dc_slaves_->setText(config != nullptr
                          ? countText(static_cast<std::uint64_t>(std::ranges::count_if(
                                config->slaves, [](const SlaveConfig& slave) { return slave.dc.has_value(); })))
                          : none);
  inputs_->setText(config != nullptr ? bitsText(config->image.input_bytes * 8) : none);
  outputs_->setText(config != nullptr ? bitsText(config->image.output_bytes * 8) : none);
  if (config == nullptr) return frame_->setText(none);
  const auto bytes = cyclicBytes(*config);
  frame_->setText(
      tr("%1, %2 on the wire")
          .arg(bitsText(static_cast<std::uint32_t>(bytes * 8)), timeText(static_cast<Nanoseconds>((bytes + 24) * 80))));
}

void MasterGeneralPage::showLive(const Snapshot& snapshot) {
  const bool online = workspace().live().phase() == LiveSession::Phase::kOnline;
  const auto none = QStringLiteral("\u2013");
  state_->setState(snapshot.online ? theme::stateTone(snapshot.state) : theme::Tone::kNeutral,
                   snapshot.online ? masterStateName(snapshot.state) : tr("Offline"));
  requested_->setText(snapshot.online ? stateName(snapshot.requested) : none);
  for (auto* button : state_buttons_) button->setEnabled(online);
  const auto present = std::ranges::count_if(snapshot.slaves, &SlaveStatus::present);
  found_->setText(snapshot.online ? tr("%1 of %2").arg(present).arg(snapshot.slaves.size()) : none);
  cycles_->setText(snapshot.online ? countText(snapshot.cycles) : none);
  lost_->setText(snapshot.online ? countText(snapshot.lost_frames) : none);
  wkc_->setText(snapshot.online ? countText(snapshot.wkc_errors) : none);
  late_->setText(snapshot.online ? countText(snapshot.late_frames) : none);
  overruns_->setText(snapshot.online ? countText(snapshot.skipped_cycles) : none);
}

}  // namespace syncline::ui
