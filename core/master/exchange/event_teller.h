// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "channels/event.h"

namespace syncline::coe {
struct Emergency;
}  // namespace syncline::coe

namespace syncline {

class EventQueue;
struct NetworkConfig;

/// The way to the outside for what takes part in running a bus: whoever has something to tell tells it here. The thread
/// that runs the cycle.
class EventTeller {
 public:
  EventTeller(const NetworkConfig& config, EventQueue& events);
  EventTeller(const EventTeller&) = delete;
  EventTeller& operator=(const EventTeller&) = delete;

  /// `time` of the host clock; `slave` -1: the master, the bus. Notifications that the configuration switches off are
  /// left out.
  void tell(Nanoseconds time, int slave, EventDetails what);
  void error(const Error& error, Nanoseconds time);
  void emergency(std::size_t slave, const coe::Emergency& emergency, Nanoseconds time);
  /// Tells of a slave that comes and goes as it likes; false when it is none.
  bool hot_connect(std::size_t slave, events::HotConnect::What what, Nanoseconds time);

 private:
  [[nodiscard]] bool wanted(const EventDetails& what) const;

  const NetworkConfig& config_;
  EventQueue& events_;
  std::vector<SharedText> groups_;  // per slave, of the heads of hot-connect groups
};

}  // namespace syncline
