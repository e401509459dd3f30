// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_dc_page.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "ui/session/setting_keys.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/time_edit.h"

namespace syncline::ui {
namespace {

QString onOff(bool on) { return on ? QStringLiteral("on") : QStringLiteral("off"); }

QSpinBox* spinBox(const char* object_name, const QString& accessible, int minimum, int maximum, const QString& suffix) {
  auto* box = named(new QSpinBox, object_name, accessible);
  box->setRange(minimum, maximum);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  box->setAlignment(Qt::AlignRight);
  return box;
}

}  // namespace

MasterDcPage::MasterDcPage(Workspace& workspace) : Page(workspace, "masterDcPage", tr("Distributed Clocks")) {
  auto* columns = new CardColumns;
  buildClocks(*columns->add(0, tr("Clock Adjustment")));
  buildShift(*columns->add(1, tr("Master Synchronisation (DCM)")));
  buildWindow(*columns->add(0, tr("Sync Window Monitoring")));
  auto* slaves = columns->add(2, tr("Slaves, live"));
  buildLive(*slaves, *columns->add(2, tr("Master, live")));
  columns->addStretch();
  setWidget(columns);
}

bool MasterDcPage::appliesTo(int slave) const {
  return slave < 0 && !workspace().document().project().slaves.empty();
}

QCheckBox* MasterDcPage::addSwitch(Card& card, const char* object_name, const QString& text, const char* key,
                                   const QString& tip) {
  auto* box = named(new QCheckBox(text), object_name, text);
  connect(box, &QCheckBox::clicked, this,
          [this, text, key](bool on) { edit(tr("Switch %1").arg(text), keys::master(key), onOff(on)); });
  card.addWide(box, tip);
  return box;
}

void MasterDcPage::buildClocks(Card& card) {
  enabled_ = addSwitch(card, "dcEnabled", tr("Distributed clocks"), keys::kDcEnabled,
                       tr("Off: no distributed-clocks commands are configured"));
  reference_ = named(new QComboBox, "referenceClock", tr("Reference clock"));
  connect(reference_, &QComboBox::activated, this, [this] {
    edit(tr("Change reference clock"), keys::master(keys::kReferenceClock), reference_->currentData().toString());
  });
  card.addRow(tr("Reference clock"), reference_,
              tr("The slave whose system time leads (register 0x0910, ENI DC/ReferenceClock). Only slaves behind it "
                 "can be synchronised."));
  wide_time_ = addSwitch(card, "systemTime64", tr("Show 64-bit system time"), keys::k64Bit,
                         tr("Reads 8 instead of 4 bytes of register 0x0910 each cycle"));
}

void MasterDcPage::buildShift(Card& card) {
  mode_ = new QButtonGroup(this);
  const struct {
    DcmMode mode;
    const char* name;
    QString tip;
  } rows[] = {
      {DcmMode::kBusShift, "dcmBusShift",
       tr("The master's clock leads: the reference clock is steered by a cyclic write to register 0x0910")},
      {DcmMode::kMasterShift, "dcmMasterShift",
       tr("The reference clock leads: the master moves its send time. No extra cyclic command.")},
      {DcmMode::kOff, "dcmOff", tr("Master and slaves run on clocks of their own; the frame drifts through the SYNC grid")},
      {DcmMode::kMasterRefClock, "dcmMasterRefClock",
       tr("As bus shift, without a control loop: the reference clock is written the nominal time. Needs an accurate cycle.")},
      {DcmMode::kLinkLayerRefClock, "dcmLinkLayerRefClock",
       tr("As bus shift, with the time that the network adapter puts into each frame while sending it")},
      {DcmMode::kDcx, "dcmDcx",
       tr("An external clock leads through a bridge device: the reference clock follows it, the master follows the "
          "reference clock")},
      {DcmMode::kMasterShiftByApp, "dcmMasterShiftByApp",
       tr("The reference clock leads, and the application moves the send time by the reported adjustment")},
  };
  constexpr int kModesPerRow = 2;
  auto* modes = new QWidget;
  auto* layout = new QGridLayout(modes);
  layout->setContentsMargins(0, 0, 0, 0);
  int count = 0;
  for (const auto& row : rows) {
    auto* button = named(new QRadioButton(dcmModeText(row.mode)), row.name, dcmModeText(row.mode));
    button->setToolTip(row.tip);
    mode_->addButton(button, static_cast<int>(row.mode));
    layout->addWidget(button, count / kModesPerRow, count % kModesPerRow);
    ++count;
  }
  layout->setColumnStretch(kModesPerRow, 1);
  connect(mode_, &QButtonGroup::idClicked, this, [this](int id) {
    const auto name = dcm_mode_name(static_cast<DcmMode>(id));
    edit(tr("Change master synchronisation"), keys::master(keys::kDcmMode),
         QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
  });
  card.addWide(modes);
  set_value_auto_ = named(new QCheckBox(tr("Set value automatic")), "setValueAuto", tr("Set value automatic"));
  connect(set_value_auto_, &QCheckBox::clicked, this, [this](bool automatic) {
    edit(tr("Change set value"), keys::master(keys::kSetValue),
         automatic ? QStringLiteral("auto") : microsecondsSetting(set_value_->valueNs()));
  });
  card.addWide(set_value_auto_, tr("Two thirds of the cycle"));
  set_value_ = named(new TimeEdit, "setValue", tr("Set value: send to SYNC0"));
  connect(set_value_, &TimeEdit::editedNs, this, [this](Nanoseconds value) {
    edit(tr("Change set value"), keys::master(keys::kSetValue), microsecondsSetting(value));
  });
  card.addRow(tr("Send to SYNC0"), set_value_, tr("Distance from sending the cyclic frame to SYNC0 (EC-Master nCtlSetVal)"));
  dcm_limit_ = spinBox("dcmLimit", tr("In-sync limit"), 1, 1'000'000, QStringLiteral(" ns"));
  connect(dcm_limit_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("Change in-sync limit"), keys::master(keys::kDcmLimit), QString::number(value));
  });
  card.addRow(tr("In-sync limit"), dcm_limit_, tr("Controller error up to which the master counts as in sync (dwInSyncLimit)"));
  dcm_settle_ = spinBox("dcmSettle", tr("Settle time of the master"), 0, 60'000, QStringLiteral(" ms"));
  connect(dcm_settle_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("Change settle time"), keys::master(keys::kDcmSettle), QString::number(value));
  });
  card.addRow(tr("Settle time"), dcm_settle_, tr("How long the error must stay within the limit (dwInSyncSettleTime)"));
}

void MasterDcPage::buildWindow(Card& card) {
  monitoring_ = addSwitch(card, "syncWindow", tr("Monitor the sync window"), keys::kSyncWindow,
                          tr("Adds a BRD of register 0x092C to the cyclic frame. Without it slaves are not monitored."));
  exponent_ = spinBox("syncWindowExponent", tr("Limit exponent n"), 1, 30, {});
  connect(exponent_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("Change sync window"), keys::master(keys::kSyncWindowExponent), QString::number(value));
  });
  auto* field = new QWidget;
  auto* layout = new QHBoxLayout(field);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(exponent_);
  limit_ = named(new QLabel, "syncWindowLimit", tr("Limit"));
  layout->addWidget(limit_, 1);
  card.addRow(tr("Limit 2ⁿ − 1"), field, tr("Wire-ored SystemTimeDifference (register 0x092C) of all slaves, dwDevLimit"));
  settle_ = spinBox("syncWindowSettle", tr("Settle time of the slaves"), 0, 60'000, QStringLiteral(" ms"));
  connect(settle_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("Change settle time"), keys::master(keys::kSyncWindowSettle), QString::number(value));
  });
  card.addRow(tr("Settle time"), settle_, tr("How long the deviation must stay within the limit"));
}

void MasterDcPage::buildLive(Card& slaves, Card& master) {
  dc_state_ = named(new Pill, "dcState", tr("Slaves in sync"));
  slaves.addRow(tr("State"), dc_state_, tr("Sync window of register 0x092C"));
  deviation_ = slaves.addValue("dcDeviation", tr("Deviation"), tr("Register 0x092C: largest latest reading of the slaves that follow the reference clock"));
  reading_ = slaves.addValue("dcReading", tr("Last heard of"), tr("How long ago something was last heard of each slave that follows"));
  settled_ = slaves.addValue("dcSettledAfter", tr("Settled after"), tr("From the first cyclic frame"));
  leader_ = slaves.addValue("dcReference", tr("Reference clock"), tr("The slave that leads on the bus"));
  dcm_state_ = named(new Pill, "dcmState", tr("Master in sync"));
  master.addRow(tr("State"), dcm_state_, tr("Error of the controller, frames later than the set value allows, cycles left out: none of them within the settle time"));
  error_ = master.addValue("dcmError", tr("Error"), tr("Frame late in the SYNC grid > 0, filtered"));
  error_statistics_ = master.addValue("dcmErrorStatistics", tr("RMS / max"), tr("Since in sync"));
  frame_error_ = master.addValue("dcmFrameError", tr("Frame, max / allowed"),
                                 tr("Error of the schedule and how late frames were sent, together: largest since in sync, and at "
                                    "which a frame meets SYNC0"));
  drift_ = master.addValue("dcmDrift", tr("Drift"), tr("Reference clock's rate against the host's; the ceiling is about 600 ppm"));
  locked_after_ = master.addValue("dcmInSyncAfter", tr("In sync after"), tr("From the first cyclic frame"));
}

void MasterDcPage::refreshReferenceClocks() {
  const auto& project = workspace().document().project();
  const QSignalBlocker quiet(reference_);
  reference_->clear();
  reference_->addItem(tr("First with DC"), QStringLiteral("auto"));
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const auto& slave = project.slaves[i];
    if (!slave.device.dc) continue;
    reference_->addItem(QStringLiteral("%1  %2").arg(i).arg(QString::fromStdString(slave.name)), QString::number(i));
  }
  const auto chosen = project.master.dc.reference_clock;
  reference_->setCurrentIndex(std::max(0, reference_->findData(chosen ? QString::number(*chosen) : QStringLiteral("auto"))));
}

void MasterDcPage::refresh() {
  const auto& master = workspace().document().project().master;
  const auto& dc = master.dc;
  refreshReferenceClocks();
  enabled_->setChecked(dc.enabled);
  wide_time_->setChecked(dc.show_64bit_system_time);
  if (auto* button = mode_->button(static_cast<int>(dc.dcm.mode))) button->setChecked(true);
  set_value_auto_->setChecked(!dc.dcm.set_value);
  set_value_->setRangeNs(0, master.cycle_time);
  set_value_->showNs(dc.dcm.set_value.value_or(master.cycle_time * 2 / 3));
  const auto show = [](QSpinBox* box, std::int64_t value) {
    const QSignalBlocker quiet(box);
    box->setValue(static_cast<int>(value));
  };
  show(dcm_limit_, dc.dcm.in_sync_limit);
  show(dcm_settle_, dc.dcm.in_sync_settle_time_ms);
  show(exponent_, dc.sync_window.exponent);
  show(settle_, dc.sync_window.settle_time_ms);
  monitoring_->setChecked(dc.sync_window.enabled);
  limit_->setText(QStringLiteral("= ") + timeText((Nanoseconds{1} << dc.sync_window.exponent) - 1));

  for (auto* widget : {static_cast<QWidget*>(reference_), static_cast<QWidget*>(wide_time_),
                       static_cast<QWidget*>(monitoring_)}) {
    widget->setEnabled(dc.enabled);
  }
  for (auto* button : mode_->buttons()) button->setEnabled(dc.enabled);
  const bool controlled = dc.enabled && dc.dcm.mode != DcmMode::kOff;
  set_value_auto_->setEnabled(controlled);
  set_value_->setEnabled(controlled && dc.dcm.set_value.has_value());
  dcm_limit_->setEnabled(controlled);
  dcm_settle_->setEnabled(controlled);
  const bool watched = dc.enabled && dc.sync_window.enabled;
  exponent_->setEnabled(watched);
  settle_->setEnabled(watched);
}

void MasterDcPage::showLive(const Snapshot& snapshot) {
  const auto none = QStringLiteral("\u2013");
  const auto afterText = [&none](const std::optional<double>& ms) -> QString {
    if (!ms) return none;
    return *ms < 1 ? tr("at once") : timeText(static_cast<Nanoseconds>(*ms * 1e6));
  };
  const auto slaves = slavesSync(snapshot);
  dc_state_->setState(slaves.tone, slaves.text);
  const auto master = masterSync(snapshot);
  dcm_state_->setState(master.tone, master.text);
  const bool dc = snapshot.online && snapshot.dc.enabled;
  const auto deviation = snapshot.dc.deviation_ns ? timeText(*snapshot.dc.deviation_ns) : none;
  deviation_->setText(dc && snapshot.dc.monitored ? tr("%1 (limit %2)").arg(deviation, timeText(snapshot.dc.limit_ns))
                                                  : dc ? deviation : none);
  const auto age = snapshot.dc.oldest_age_ns;
  reading_->setText(!dc || age < 0 ? none : age == 0 ? tr("in this cycle") : tr("%1 ago").arg(timeText(age)));
  settled_->setText(dc ? afterText(snapshot.dc.settled_after_ms) : none);
  leader_->setText(dc && snapshot.dc.reference_clock >= 0
                       ? nodeName(workspace().document().project(), snapshot.dc.reference_clock)
                       : none);
  const bool dcm = snapshot.online && snapshot.dcm.mode != DcmMode::kOff;
  error_->setText(dcm ? signedTimeText(snapshot.dcm.error_filtered_ns) : none);
  error_statistics_->setText(dcm ? tr("%1 / %2").arg(timeText(static_cast<Nanoseconds>(snapshot.dcm.error_rms_ns)),
                                                     timeText(snapshot.dcm.error_max_ns))
                                 : none);
  frame_error_->setText(dcm ? tr("%1 / %2").arg(timeText(snapshot.dcm.frame_error_max_ns), timeText(snapshot.dcm.late_allowed_ns))
                            : none);
  drift_->setText(dcm ? ppmText(snapshot.dcm.drift_ppm) : none);
  locked_after_->setText(dcm ? afterText(snapshot.dcm.in_sync_after_ms) : none);
}

}  // namespace syncline::ui
