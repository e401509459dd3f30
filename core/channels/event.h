// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "channels/events/clock_events.h"
#include "channels/events/frame_events.h"
#include "channels/events/scan_events.h"
#include "channels/events/service_events.h"
#include "channels/events/slave_events.h"
#include "channels/events/state_events.h"
#include "support/types.h"

namespace syncline {

/// One struct a kind. A new one gets its words in core/channels/event_finding.cpp, which does not compile without.
using EventDetails = std::variant<
    events::ScanProgress, events::ScanTouchesRunning,  //
    events::Online, events::Offline, events::StateChanged, events::AlStatusError, events::LeftUnasked,
    events::BusWasRunning, events::SlaveLost, events::SlaveFound, events::HotConnect, events::RecoveryStep,  //
    events::DcInitialised, events::ReferenceClockChanged, events::SlavesInSync, events::SlavesOutOfSync,
    events::FramesWayChanged, events::SlavesNotMonitored, events::SlavesSyncUnknown, events::MasterInSync,
    events::MasterOutOfSync, events::DcmError, events::DelayFinding, events::DelaysMeasured,  //
    events::WkcError, events::WkcExpected, events::FramesLost, events::FramesLate, events::CyclesLeftOut,
    events::LinkDown, events::LinkUp, events::BringUpAgain,  //
    events::Emergency, events::DiagnosisTold, events::PortErrors, events::WatchdogExpired, events::LongCycles,
    events::StaleProcessData, events::CableChanged, events::UnknownSlave,  //
    events::RealTimeRefused, events::OutputsForced, events::Failure, events::MasterStopped, events::EventsLost>;

/// Which of the structs, for tables and comparisons: kind_of<events::SlaveLost>.
class EventKind {
 public:
  constexpr explicit EventKind(std::size_t index) : index_(index) {}
  constexpr bool operator==(const EventKind&) const = default;

 private:
  std::size_t index_;
};

namespace detail {
template <class What, class... All>
constexpr std::size_t index_in(std::in_place_type_t<std::variant<All...>>) {
  std::size_t index = 0;
  static_cast<void>((... || (std::is_same_v<What, All> ? true : (++index, false))));
  static_assert((... || std::is_same_v<What, All>), "no kind of event");
  return index;
}
}  // namespace detail
template <class What>
inline constexpr EventKind kind_of{detail::index_in<What>(std::in_place_type<EventDetails>)};

/// What happened, when, and to whom. Copied and moved without allocating by what a running cycle tells.
struct Event {
  Nanoseconds time = 0;  // host clock
  int slave = -1;        // position in frame order, -1: the master or the bus
  EventDetails what;

  [[nodiscard]] EventKind kind() const { return EventKind(what.index()); }
  template <class What>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<What>(what);
  }
  /// Null when it is another kind.
  template <class What>
  [[nodiscard]] const What* as() const {
    return std::get_if<What>(&what);
  }
};

}  // namespace syncline
