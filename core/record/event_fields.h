// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "channels/event.h"
#include "findings/value_bytes.h"
#include "protocol/al_state.h"

/// What of each kind of event is recorded: its number, which stays what it is, and its fields in their order; new ones
/// go behind them. A kind of event without a line here does not compile.
namespace syncline {

template <>
inline constexpr int kLargest<ErrorCode> = static_cast<int>(ErrorCode::kCatalogue);
template <>
inline constexpr int kLargest<AlState> = 15;
template <>
inline constexpr int kLargest<dc::SyncObstacle> = static_cast<int>(dc::SyncObstacle::kExternalClock);
template <>
inline constexpr int kLargest<dc::DelayWarning> = static_cast<int>(dc::DelayWarning::kUnmeasuredWay);
template <>
inline constexpr int kLargest<DiagnosisMessageType> = static_cast<int>(DiagnosisMessageType::kError);
template <>
inline constexpr int kLargest<events::ReferenceClockChanged::What> =
    static_cast<int>(events::ReferenceClockChanged::What::kNoSystemTime);
template <>
inline constexpr int kLargest<events::HotConnect::What> = static_cast<int>(events::HotConnect::What::kNotThereYet);
template <>
inline constexpr int kLargest<events::RecoveryStep::Stage> = static_cast<int>(events::RecoveryStep::Stage::kGivenUp);
template <>
inline constexpr int kLargest<events::WatchdogExpired::Which> = static_cast<int>(events::WatchdogExpired::Which::kPdi);

/// `use(number, fields...)` for each kind; E is the struct, const or not.
template <class Use>
struct EventFields {
  Use use;

  void operator()(events::ScanProgress& e) { use(1, e.done, e.found); }
  void operator()(events::ScanTouchesRunning& e) { use(2, e.running, e.eeproms); }
  void operator()(events::Online&) { use(3); }
  void operator()(events::Offline&) { use(4); }
  void operator()(events::StateChanged& e) { use(5, e.from, e.to); }
  void operator()(events::AlStatusError& e) { use(6, e.al_status, e.al_status_code); }
  void operator()(events::SlaveLost&) { use(7); }
  void operator()(events::SlaveFound&) { use(8); }
  void operator()(events::HotConnect& e) { use(9, e.what, e.group); }
  void operator()(events::RecoveryStep& e) { use(10, e.stage, e.tries); }
  void operator()(events::DcInitialised& e) { use(11, e.slaves, e.reference_clock); }
  void operator()(events::ReferenceClockChanged& e) { use(12, e.what); }
  void operator()(events::SlavesInSync& e) { use(13, e.deviation_ns); }
  void operator()(events::SlavesOutOfSync& e) { use(14, e.deviation_ns, e.over_limit); }
  void operator()(events::SlavesNotMonitored&) { use(15); }
  void operator()(events::SlavesSyncUnknown& e) { use(16, e.oldest_reading); }
  void operator()(events::MasterInSync& e) { use(17, e.error); }
  void operator()(events::MasterOutOfSync& e) { use(18, e.error, e.obstacle); }
  void operator()(events::DcmError& e) { use(19, e.code, e.drift_ppm); }
  void operator()(events::DelayFinding& e) { use(20, e.warning, e.value); }
  void operator()(events::DelaysMeasured& e) { use(21, e.corrected, e.largest_ns); }
  void operator()(events::WkcError& e) { use(22, e.expected, e.received, e.count); }
  void operator()(events::WkcExpected& e) { use(23, e.configured, e.now); }
  void operator()(events::FramesLost& e) { use(24, e.count); }
  void operator()(events::FramesLate& e) { use(25, e.count, e.late_by, e.told_as_lost); }
  void operator()(events::CyclesLeftOut& e) { use(26, e.count, e.standstill); }
  void operator()(events::LinkDown& e) { use(27, e.adapter); }
  void operator()(events::LinkUp& e) { use(28, e.adapter, e.away); }
  void operator()(events::BringUpAgain&) { use(29); }
  void operator()(events::Emergency& e) {
    use(30, e.error_code, e.error_register, e.data, e.identity.vendor_id, e.identity.product_code,
        e.identity.revision_no, e.identity.serial_no);
  }
  void operator()(events::DiagnosisTold& e) { use(31, e.code, e.type, e.text_id, e.time_stamp); }
  void operator()(events::PortErrors& e) { use(32, e.port, e.damaged_frames, e.lost_links, e.since); }
  void operator()(events::WatchdogExpired& e) { use(33, e.which, e.count); }
  void operator()(events::LongCycles& e) { use(34, e.begun, e.count); }
  void operator()(events::StaleProcessData& e) { use(35, e.begun, e.stale, e.of, e.outputs); }
  void operator()(events::CableChanged& e) { use(36, e.port, e.far_slave, e.healed); }
  void operator()(events::UnknownSlave& e) {
    use(37, e.identity.vendor_id, e.identity.product_code, e.identity.revision_no, e.identity.serial_no);
  }
  void operator()(events::RealTimeRefused& e) { use(38, e.what); }
  void operator()(events::Failure& e) {
    WordedReason worded{e.error.detail};
    use(39, e.error.code, e.error.subject, e.error.detail, e.error.file, e.error.line, e.error.expected,
        e.error.received, e.error.extra, worded);
  }
  void operator()(events::MasterStopped& e) { use(40, e.text); }
  void operator()(events::EventsLost& e) { use(41, e.count); }
  void operator()(events::OutputsForced& e) { use(42, e.bits); }
  void operator()(events::FramesWayChanged& e) { use(43, e.deviation_ns, e.slaves); }
  void operator()(events::LeftUnasked& e) { use(44, e.from, e.to); }
  void operator()(events::BusWasRunning&) { use(45); }
};

}  // namespace syncline
