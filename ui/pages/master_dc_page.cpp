// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_dc_page.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>

#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/sync_window_fields.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

struct Mode {
  DcmMode mode;
  const char* object_name;
  QString tip;
};

QList<Mode> modes() {
  return {
      {DcmMode::kBusShift, "dcmBusShift",
       MasterDcPage::tr(
           "The master's clock leads: the reference clock is steered by a cyclic write to register 0x0910")},
      {DcmMode::kMasterShift, "dcmMasterShift",
       MasterDcPage::tr("The reference clock leads: the master moves its send time. No extra cyclic command.")},
      {DcmMode::kOff, "dcmOff",
       MasterDcPage::tr("Master and slaves run on clocks of their own; the frame drifts through the SYNC grid")},
      {DcmMode::kMasterRefClock, "dcmMasterRefClock",
       MasterDcPage::tr("As bus shift, without a control loop: the reference clock is written the nominal time, and "
                        "what a frame is far off it is made good. Needs an accurate cycle.")},
      {DcmMode::kLinkLayerRefClock, "dcmLinkLayerRefClock",
       MasterDcPage::tr("As bus shift, with the time that the network adapter puts into each frame while sending it")},
      {DcmMode::kDcx, "dcmDcx",
       MasterDcPage::tr(
           "An external clock leads through a bridge device: the reference clock follows it, the master follows the "
           "reference clock")},
      {DcmMode::kMasterShiftByApp, "dcmMasterShiftByApp",
       MasterDcPage::tr(
           "The reference clock leads, and the application moves the send time by the reported adjustment")},
  };
}

}  // namespace

MasterDcPage::~MasterDcPage() = default;

MasterDcPage::MasterDcPage(Workspace& workspace) : Page(workspace, "masterDcPage", tr("Distributed Clocks")) {
  auto* columns = new CardColumns;
  buildClocks(*columns->add(0, tr("Clock Adjustment")));
  buildShift(*columns->add(1, tr("Master Synchronisation (DCM)")));
  window_ = std::make_unique<SyncWindowFields>(*this, *columns->add(0, tr("Sync Window Monitoring")));
  auto* slaves = columns->add(2, tr("Slaves, live"));
  buildLive(*slaves, *columns->add(2, tr("Master, live")));
  columns->addStretch();
  setWidget(columns);
}

bool MasterDcPage::appliesTo(int slave) const { return slave < 0 && !workspace().document().project().slaves.empty(); }

void MasterDcPage::buildClocks(Card& card) {
  fields().toggle(card, "dcEnabled", "master.dc.enabled");
  reference_ = fields().choice(card, "referenceClock", "master.dc.reference_clock");
  wide_time_ = fields().toggle(card, "systemTime64", "master.dc.show_64bit_system_time");
}

void MasterDcPage::buildShift(Card& card) {
  constexpr int kModesPerRow = 2;
  QList<std::pair<std::int64_t, const char*>> names;
  for (const auto& mode : modes()) names.append({static_cast<std::int64_t>(mode.mode), mode.object_name});
  mode_ = fields().buttons(card, "master.dc.mode", names, kModesPerRow);
  for (const auto& mode : modes()) mode_->button(static_cast<int>(mode.mode))->setToolTip(mode.tip);
  set_value_auto_ = fields().automatic(card, "setValueAuto", "master.dc.set_value_us", tr("Set value automatic"),
                                       tr("Two thirds of the cycle, and later on long buses"));
  set_value_ = fields().number(card, "setValue", "master.dc.set_value_us");
  dcm_limit_ = fields().number(card, "dcmLimit", "master.dc.in_sync_limit_ns");
  dcm_settle_ = fields().number(card, "dcmSettle", "master.dc.in_sync_settle_ms");
}

void MasterDcPage::buildLive(Card& slaves, Card& master) {
  dc_state_ = named(new Pill, "dcState", tr("Slaves in sync"));
  slaves.addRow(tr("State"), dc_state_, tr("Sync window of register 0x092C"));
  deviation_ =
      slaves.addValue("dcDeviation", tr("Deviation"),
                      tr("Register 0x092C: largest latest reading of the slaves that follow the reference clock"));
  reading_ = slaves.addValue("dcReading", tr("Last heard of"),
                             tr("How long ago something was last heard of each slave that follows"));
  settled_ = slaves.addValue("dcSettledAfter", tr("Settled after"), tr("From the first cyclic frame"));
  leader_ = slaves.addValue("dcReference", tr("Reference clock"), tr("The slave that leads on the bus"));
  dcm_state_ = named(new Pill, "dcmState", tr("Master in sync"));
  master.addRow(tr("State"), dcm_state_,
                tr("Error of the controller, frames later than the set value allows, cycles left out: none of them "
                   "within the settle time"));
  error_ = master.addValue("dcmError", tr("Error"), tr("Frame late in the SYNC grid > 0, filtered"));
  error_statistics_ = master.addValue("dcmErrorStatistics", tr("RMS / max"), tr("Since in sync"));
  frame_error_ =
      master.addValue("dcmFrameError", tr("Frame, max / allowed"),
                      tr("Error of the schedule and how late frames were sent, together: largest since in sync, and at "
                         "which a frame meets SYNC0"));
  drift_ = master.addValue("dcmDrift", tr("Drift"),
                           tr("Reference clock's rate against the host's; the ceiling is about 600 ppm"));
  external_ = master.addValue("dcmExternal", tr("External clock"),
                              tr("Reference clock ahead of the external one > 0, within half a cycle"));
  master_ = &master;
  master_->form()->setRowVisible(external_, false);
  locked_after_ = master.addValue("dcmInSyncAfter", tr("In sync after"), tr("From the first cyclic frame"));
}

void MasterDcPage::refresh() {
  const auto& dc = project().master.dc;
  window_->show(dc);
  for (auto* widget : {static_cast<QWidget*>(reference_), static_cast<QWidget*>(wide_time_)})
    widget->setEnabled(dc.enabled);
  for (auto* button : mode_->buttons()) button->setEnabled(dc.enabled);
  const bool controlled = dc.enabled && dc.dcm.mode != DcmMode::kOff;
  set_value_auto_->setEnabled(controlled);
  set_value_->setEnabled(controlled);
  dcm_limit_->setEnabled(controlled);
  dcm_settle_->setEnabled(controlled);
  fields().refresh();
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
                      : dc                        ? deviation
                                                  : none);
  const auto age = snapshot.dc.oldest_age_ns;
  reading_->setText(!dc || age < 0 ? none : age == 0 ? tr("in this cycle") : tr("%1 ago").arg(timeText(age)));
  settled_->setText(dc ? afterText(snapshot.dc.settled_after_ms) : none);
  leader_->setText(dc && snapshot.dc.reference_clock >= 0
                       ? nodeName(workspace().live().record()->config(), snapshot.dc.reference_clock)
                       : none);
  const bool dcm = snapshot.online && snapshot.dcm.mode != DcmMode::kOff;
  error_->setText(dcm ? signedTimeText(snapshot.dcm.error_filtered_ns) : none);
  // Errors count from the moment on at which the master was in sync.
  const bool counted = dcm && snapshot.dcm.in_sync_after_ms;
  error_statistics_->setText(counted ? tr("%1 / %2").arg(timeText(static_cast<Nanoseconds>(snapshot.dcm.error_rms_ns)),
                                                         timeText(snapshot.dcm.error_max_ns))
                                     : none);
  frame_error_->setText(
      counted ? tr("%1 / %2").arg(timeText(snapshot.dcm.frame_error_max_ns), timeText(snapshot.dcm.late_allowed_ns))
              : none);
  drift_->setText(dcm ? withSpreadPpmText(snapshot.dcm.drift_ppm, snapshot.dcm.drift_half_width_ppm) : none);
  // Nobody else has one.
  master_->form()->setRowVisible(external_, dcm && snapshot.dcm.mode == DcmMode::kDcx);
  external_->setText(snapshot.dcm.external_error_ns ? signedTimeText(*snapshot.dcm.external_error_ns) : none);
  locked_after_->setText(dcm ? afterText(snapshot.dcm.in_sync_after_ms) : none);
}

}  // namespace syncline::ui
