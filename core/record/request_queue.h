// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "channels/request_desk.h"

namespace syncline {

/// Who waits for whom: what a person asked for goes before what fills a page.
enum class RequestUrgency : std::uint8_t { kPerson, kBackground };

/// How a request ended.
enum class RequestEnd : std::uint8_t {
  kAnswered,
  kFailed,     // the slave or the master refused it, or it is beyond its limits
  kCancelled,  // by who asked
  kGone,       // the bus went offline, or was
};

/// Any number of requests on the slaves of one bus, which wait here for their turn at its desk: as many are given to
/// the master at once that it is never idle, and no more than that a person's request does not wait behind a whole
/// dictionary. For the onlookers' thread.
class RequestQueue {
 public:
  /// Chosen by who asks, ascending: in this order they go to the master.
  using Id = std::uint64_t;
  /// With the master at once, of one slave and of all; no more than RequestDesk::kCapacity.
  struct Room {
    std::size_t per_slave = 16, total = 48;
  };
  struct Ended {
    Id id = 0;
    RequestEnd end = RequestEnd::kAnswered;
    SlaveAnswer answer{};  // data or information when kAnswered, else the error, if there is one
  };

  RequestQueue() = default;
  explicit RequestQueue(Room room) : room_(room) {}

  void post(Id id, SlaveRequest request, RequestUrgency urgency = RequestUrgency::kPerson);
  /// Gives the desk what there is room for.
  void submit(RequestDesk& desk);
  /// Its end will be kCancelled, unless it comes to another one before. `desk`: null when the bus is away.
  void cancel(Id id, RequestDesk* desk);
  /// Nobody wants to know of it any more. `desk`: as above.
  void forget(Id id, RequestDesk* desk);
  /// All that are under way end as kGone: the bus is away.
  void end_all();
  /// Bytes that have been transferred so far, of long ones.
  [[nodiscard]] std::uint32_t progress(Id id, const RequestDesk& desk) const;

  /// Those that have ended since, each once. `desk`: takes the answers, and gives the next ones; null when the bus is
  /// away.
  [[nodiscard]] std::vector<Ended> take_ended(RequestDesk* desk);
  /// Some have ended before they were given to the master.
  [[nodiscard]] bool has_ended() const { return !ended_.empty(); }
  /// Under way, and not ended.
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

 private:
  struct Waiting {
    SlaveRequest request;
    RequestUrgency urgency = RequestUrgency::kPerson;
    RequestId ticket = 0;  // 0: not yet with the master
    bool cancelled = false;
  };
  using Place = std::map<Id, Waiting>::iterator;

  [[nodiscard]] bool has_room(const Waiting& waiting) const;
  void give(Place at, RequestDesk& desk);
  void collect(RequestDesk& desk);
  /// Out of the list.
  Place remove(Place at);

  Room room_{};
  std::map<Id, Waiting> waiting_;
  std::map<std::uint16_t, std::size_t> of_slave_;  // with the master
  std::size_t with_master_ = 0;
  std::vector<Ended> ended_;
};

}  // namespace syncline
