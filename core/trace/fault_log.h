// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "channels/event.h"

/// What went wrong in a run, in the order in which it happened: what came first, and what followed from it.
namespace syncline {

/// One disturbance, with its like of the same episode.
struct Fault {
  Nanoseconds first = 0, last = 0;  // host clock
  int slave = -1;                   // position; -1: the master or the bus
  std::optional<Event> event;       // the first of its kind; nothing: the slave has missed SM2 events
  std::uint64_t count = 1;          // events of the kind, or missed SM2 events
  /// It is a state that lasts (a slave away, a cable broken, out of sync), and no moment.
  [[nodiscard]] bool lasts() const;
  std::optional<Nanoseconds> over;  // when what lasts was in order again
};

/// Faults of which each came within FaultLog::kQuiet of another one, or of the end of one that lasted: what counters
/// tell once a slave answers again is of the episode in which it went.
struct FaultEpisode {
  static constexpr std::size_t kMostFaults = 32;

  Nanoseconds begin = 0, end = 0;  // host clock, of the first fault and of the last
  std::vector<Fault> faults;       // by time: the first is what the others may have followed from
  std::uint64_t left_out = 0;      // beyond kMostFaults

  /// What is told first: the first fault; where frames or clocks only showed it, what was found to be the cause within
  /// kSameMoment; of frames also the port that counted damaged ones between its readings about that moment.
  static constexpr Nanoseconds kSameMoment = 20 * kMillisecond;
  [[nodiscard]] std::size_t leading() const;
};

/// What an event says of the machine's order; a step that was asked for is news.
enum class EventMeaning : std::uint8_t { kFault, kReturnToOrder, kNews };
[[nodiscard]] EventMeaning meaning_of(const Event& event);

class FaultLog {
 public:
  static constexpr Nanoseconds kQuiet = 2 * kSecond;
  static constexpr std::size_t kMostEpisodes = 64;

  /// What is no fault is passed over, but that it ends one that lasts; so is what was before clear(). Times may come
  /// out of order within an episode.
  void add(const Event& event);
  /// The slave has missed so many more SM2 events, as read at `time`.
  void add_missed(Nanoseconds time, int slave, std::uint64_t missed);
  /// Forgets what was before `now`.
  void clear(Nanoseconds now);

  /// The latest kMostEpisodes, oldest first.
  [[nodiscard]] const std::vector<FaultEpisode>& episodes() const { return episodes_; }
  /// All, those that were forgotten included.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// What lasts and is not over, oldest first; valid until something is added.
  [[nodiscard]] std::vector<const Fault*> lasting() const;

 private:
  void add(Fault fault);
  static void add(Fault fault, FaultEpisode& episode);
  void end(const Event& news);
  FaultEpisode& episode_at(Nanoseconds time);
  void take_what_follows(std::size_t episode, Nanoseconds over);

  std::vector<FaultEpisode> episodes_;
  std::uint64_t count_ = 0;
  Nanoseconds since_ = 0;
};

}  // namespace syncline
