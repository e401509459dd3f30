// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_general_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "ui/session/setting_keys.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

constexpr Nanoseconds kCycles[] = {125'000, 250'000, 500'000, 1'000'000, 2'000'000, 4'000'000, 8'000'000, 10'000'000};

/// Microseconds as typed: no thousands separators, no needless zeros.
QString cycleNumber(Nanoseconds cycle) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(static_cast<double>(cycle) / 1e3, 'g', 9);
}

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
  dc_slaves_ = information->addValue("masterDcSlaves", tr("Slaves with DC"), tr("Slaves whose distributed clock is set up (ENI Slave/DC)"));
  inputs_ = information->addValue("masterInputs", tr("Inputs"), tr("Input process image (ENI ProcessImage/Inputs)"));
  outputs_ = information->addValue("masterOutputs", tr("Outputs"), tr("Output process image (ENI ProcessImage/Outputs)"));
  frame_ = information->addValue("masterFrame", tr("Cyclic frames"), tr("Bytes and time on the wire at 100 Mbit/s, each cycle"));
  buildStateMachine(*columns->add(1, tr("State Machine")));
  buildRecovery(*columns->add(1, tr("Recovery")));
  buildCounters(*columns->add(1, tr("Bus")));
  columns->addStretch();
  setWidget(columns);
}

void MasterGeneralPage::buildSettings(Card& card) {
  name_ = named(new QLineEdit, "masterName", tr("Name of the master"));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    edit(tr("Rename master"), keys::master(keys::kMasterName), name_->text());
  });
  card.addRow(tr("Name"), name_, tr("ENI Master/Info/Name"));
  cycle_ = named(new QComboBox, "masterCycle", tr("Cycle time"));
  cycle_->setEditable(true);
  cycle_->setInsertPolicy(QComboBox::NoInsert);
  for (const auto cycle : kCycles) cycle_->addItem(cycleNumber(cycle), QVariant::fromValue(cycle));
  connect(cycle_, &QComboBox::activated, this, &MasterGeneralPage::takeCycle);
  connect(cycle_->lineEdit(), &QLineEdit::editingFinished, this, &MasterGeneralPage::takeCycle);
  auto* field = new QWidget;
  auto* layout = new QHBoxLayout(field);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(cycle_, 1);
  layout->addWidget(new QLabel(QStringLiteral("\u00B5s")));
  card.addRow(tr("Cycle time"), field, tr("Bus cycle, base of every Sync Unit Cycle (ENI Cyclic/CycleTime); 31.25 µs to 100 ms"));
  overlap_ = addSwitch(card, "masterOverlap", tr("Overlap inputs and outputs"), keys::kOverlap,
                       tr("Inputs and outputs of a slave share logical addresses, which halves the cyclic frame"));
}

QCheckBox* MasterGeneralPage::addSwitch(Card& card, const char* object_name, const QString& text, const char* key,
                                        const QString& tip) {
  auto* box = named(new QCheckBox(text), object_name, text);
  connect(box, &QCheckBox::clicked, this, [this, text, key](bool on) {
    edit(tr("Switch %1").arg(text), keys::master(key), on ? QStringLiteral("on") : QStringLiteral("off"));
  });
  card.addWide(box, tip);
  return box;
}

void MasterGeneralPage::buildRecovery(Card& card) {
  automatic_ = addSwitch(card, "recoveryAutomatic", tr("Bring back lost slaves"), keys::kRecoverAutomatic,
                         tr("Slaves that come back (cable healed, power back) are set up again and led to the state of the bus"));
  incomplete_ = addSwitch(card, "recoveryIncomplete", tr("Start without missing slaves"), keys::kStartIncomplete,
                          tr("Goes online with the slaves that are there; the others join when they appear"));
  error_tries_ = named(new QSpinBox, "recoveryErrorTries", tr("Tries to leave an error state"));
  error_tries_->setRange(0, 1000);
  error_tries_->setKeyboardTracking(false);
  error_tries_->setAlignment(Qt::AlignRight);
  connect(error_tries_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("Change tries"), keys::master(keys::kErrorTries), QString::number(value));
  });
  card.addRow(tr("Tries to leave an error state"), error_tries_,
              tr("How often an error is acknowledged (register 0x0120) and the state requested again; 0 leaves it to you"));
}

void MasterGeneralPage::buildStateMachine(Card& card) {
  state_ = named(new Pill, "masterState", tr("Current state"));
  card.addRow(tr("Current state"), state_, tr("Lowest state of all slaves (register 0x0130)"));
  requested_ = card.addValue("masterRequestedState", tr("Requested state"), tr("State asked for last (register 0x0120)"));
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
  wkc_ = card.addValue("masterWkc", tr("Working counter errors"), tr("Cycles whose working counter was not the expected one"));
  overruns_ = card.addValue("masterOverruns", tr("Cycles left out"), tr("Cycles without a frame: the host came too late for them"));
}

void MasterGeneralPage::takeCycle() {
  const auto text = cycle_->currentText().trimmed();
  bool ok = false;
  double value = QLocale().toDouble(text, &ok);
  if (!ok) value = text.toDouble(&ok);
  const auto cycle = ok ? static_cast<Nanoseconds>(value * 1e3 + 0.5) : -1;
  if (cycle == workspace().document().project().master.cycle_time) return refresh();
  edit(tr("Change cycle time"), keys::master(keys::kCycleTime), ok ? microsecondsSetting(cycle) : text);
}

void MasterGeneralPage::refresh() {
  const auto& project = workspace().document().project();
  if (!name_->hasFocus() || !name_->isModified()) name_->setText(QString::fromStdString(project.master.name));
  {
    const QSignalBlocker quiet(cycle_);
    const auto known = cycle_->findData(QVariant::fromValue(project.master.cycle_time));
    cycle_->setCurrentIndex(known);
    if (known < 0) cycle_->setEditText(cycleNumber(project.master.cycle_time));
  }
  overlap_->setChecked(project.master.overlap_process_data);
  automatic_->setChecked(project.master.recovery.automatic);
  incomplete_->setChecked(project.master.recovery.start_incomplete);
  {
    const QSignalBlocker quiet(error_tries_);
    error_tries_->setValue(static_cast<int>(project.master.recovery.error_tries));
  }
  slaves_->setText(countText(project.slaves.size()));
  const auto* config = workspace().configuration().config();
  const auto none = QStringLiteral("\u2013");
  dc_slaves_->setText(config != nullptr ? countText(static_cast<std::uint64_t>(std::ranges::count_if(
                                              config->slaves, [](const SlaveConfig& slave) { return slave.dc.has_value(); })))
                                        : none);
  inputs_->setText(config != nullptr ? bitsText(config->image.input_bytes * 8) : none);
  outputs_->setText(config != nullptr ? bitsText(config->image.output_bytes * 8) : none);
  if (config == nullptr) return frame_->setText(none);
  const auto bytes = cyclicBytes(*config);
  frame_->setText(tr("%1, %2 on the wire").arg(bitsText(static_cast<std::uint32_t>(bytes * 8)),
                                               timeText(static_cast<Nanoseconds>((bytes + 24) * 80))));
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
