// SPDX-License-Identifier: Apache-2.0
#include "channels/event_name.h"

#include <variant>

#include "channels/event.h"

namespace syncline {
namespace {

using Name = std::string_view;

/// Without a form for any other: a new kind of event needs its name. What belongs together for whoever filters has one.
struct Names {
  Name operator()(const events::ScanProgress&) const { return "scan_progress"; }
  Name operator()(const events::ScanTouchesRunning&) const { return "scan_touches_running"; }
  Name operator()(const events::Online&) const { return "online"; }
  Name operator()(const events::Offline&) const { return "offline"; }
  Name operator()(const events::StateChanged&) const { return "state"; }
  Name operator()(const events::AlStatusError&) const { return "al_status_error"; }
  Name operator()(const events::SlaveLost&) const { return "slave_lost"; }
  Name operator()(const events::LeftUnasked&) const { return "left_unasked"; }
  Name operator()(const events::BusWasRunning&) const { return "bus_was_running"; }
  Name operator()(const events::SlaveFound&) const { return "slave_found"; }
  Name operator()(const events::HotConnect&) const { return "hot_connect"; }
  Name operator()(const events::RecoveryStep&) const { return "recovery"; }
  Name operator()(const events::DcInitialised&) const { return "dc_initialised"; }
  Name operator()(const events::ReferenceClockChanged&) const { return "reference_clock"; }
  Name operator()(const events::SlavesInSync&) const { return "slave_sync"; }
  Name operator()(const events::SlavesOutOfSync&) const { return "slave_sync"; }
  Name operator()(const events::SlavesNotMonitored&) const { return "slave_sync"; }
  Name operator()(const events::SlavesSyncUnknown&) const { return "slave_sync"; }
  Name operator()(const events::MasterInSync&) const { return "master_sync"; }
  Name operator()(const events::MasterOutOfSync&) const { return "master_sync"; }
  Name operator()(const events::DcmError&) const { return "dcm_error"; }
  Name operator()(const events::DelayFinding&) const { return "delay_finding"; }
  Name operator()(const events::FramesWayChanged&) const { return "frames_way_changed"; }
  Name operator()(const events::DelaysMeasured&) const { return "delays_measured"; }
  Name operator()(const events::WkcError&) const { return "wkc_error"; }
  Name operator()(const events::WkcExpected&) const { return "wkc_expected"; }
  Name operator()(const events::FramesLost&) const { return "frames_lost"; }
  Name operator()(const events::FramesLate&) const { return "frames_late"; }
  Name operator()(const events::CyclesLeftOut&) const { return "overruns"; }
  Name operator()(const events::LinkDown&) const { return "link"; }
  Name operator()(const events::LinkUp&) const { return "link"; }
  Name operator()(const events::BringUpAgain&) const { return "link"; }
  Name operator()(const events::Emergency&) const { return "emergency"; }
  Name operator()(const events::DiagnosisTold&) const { return "diagnosis"; }
  Name operator()(const events::PortErrors&) const { return "port_errors"; }
  Name operator()(const events::WatchdogExpired&) const { return "watchdog"; }
  Name operator()(const events::LongCycles&) const { return "firmware_slow"; }
  Name operator()(const events::StaleProcessData&) const { return "firmware_slow"; }
  Name operator()(const events::CableChanged&) const { return "cable"; }
  Name operator()(const events::UnknownSlave&) const { return "unknown_slave"; }
  Name operator()(const events::RealTimeRefused&) const { return "real_time"; }
  Name operator()(const events::OutputsForced&) const { return "outputs_forced"; }
  Name operator()(const events::Failure&) const { return "error"; }
  Name operator()(const events::MasterStopped&) const { return "error"; }
  Name operator()(const events::EventsLost&) const { return "events_lost"; }
};

}  // namespace

std::string_view event_name(const Event& event) { return std::visit(Names{}, event.what); }

}  // namespace syncline
