// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_general_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "advice/image_report.h"
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
MasterGeneralPage::MasterGeneralPage(Workspace& workspace) : Page(workspace, "masterGeneralPage", tr("General")) {
  auto* columns = new CardColumns;
  buildSettings(*columns->add(0, tr("Settings")));
  auto* information = columns->add(0, tr("Configuration"));
  slaves_ = information->addValue("masterSlaves", tr("Slaves"), tr("Configured slaves"));
  dc_slaves_ = information->addValue("masterDcSlaves", tr("Slaves with DC"),
                                     tr("Slaves whose distributed clock is set up (ENI Slave/DC)"));
  inputs_ = information->addValue("masterInputs", tr("Inputs"), tr("Process data of all slaves to the master"));
  outputs_ = information->addValue("masterOutputs", tr("Outputs"), tr("Process data of the master to all slaves"));
  frame_ = information->addValue(
      "masterFrame", tr("Cyclic frames"),
      tr("Bytes on the wire and time for them at 100 Mbit/s, in a cycle; the page Frames and Cost says more"));
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
  auto* cycles = named(new QPushButton(tr("Accepted…")), "masterAccepted", tr("Cycles that the slaves accept"));
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
  cycles_ = card.addValue("masterCycleCount", tr("Cycles"), tr("Bus cycles since going online"));
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
  showCost(config);
}

/// The same figures as on the page of the frames. Nobody pays for them who does not look.
void MasterGeneralPage::showCost(const NetworkConfig* config) {
  if (!isVisible()) return;
  const auto none = QStringLiteral("\u2013");
  if (config == nullptr || config->slaves.size() != project().slaves.size()) {
    for (auto* label : {inputs_, outputs_, frame_}) label->setText(none);
    return;
  }
  const auto report = image_report(project(), *config);
  inputs_->setText(bitsText(8 * report.input_bytes));
  outputs_->setText(bitsText(8 * report.output_bytes));
  double bytes = 0;
  for (const auto& frame : report.frames)
    bytes +=
        frame.bytes * static_cast<double>(report.cycle) / static_cast<double>(std::max<Nanoseconds>(frame.cycle, 1));
  frame_->setText(tr("%1, %2 on the wire")
                      .arg(bitsText(static_cast<std::uint32_t>(8 * std::llround(bytes))), timeText(report.wire_time)));
}

void MasterGeneralPage::showEvent(QShowEvent* event) {
  showCost(workspace().configuration().config());
  Page::showEvent(event);
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
