// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "support/types.h"

namespace syncline {
struct SyncWindowSettings;
}  // namespace syncline

/// Whether the slaves are in sync with their reference clock: decided here and nowhere else, from values
/// (docs/distributed-clocks.md, "How the verdict is made").
namespace syncline::dc {

/// What is known of one slave's clock: its own 0x092C, read one by one.
struct ClockReading {
  /// The slave follows the reference clock: it is there, has a clock, and stands behind it in frame order. The
  /// reference clock itself does not, and slaves in front of it get the master's time, not the reference clock's.
  bool follows = false;
  bool read = false;              // since it follows
  Nanoseconds time = 0;           // host clock of the reading; without one, since when it follows
  std::int32_t deviation_ns = 0;  // signed

  [[nodiscard]] std::uint32_t magnitude() const {
    return static_cast<std::uint32_t>(deviation_ns < 0 ? -std::int64_t{deviation_ns} : deviation_ns);
  }
};

/// The same register of many slaves at once, wire-ored by a BRD.
struct OredReading {
  std::uint32_t magnitude_ns = 0;  // no slave that answered is further away
  bool covers_all = false;         // every follower answered
  bool followers_only = false;  // and nobody else whose value may be something else: over the limit is a follower then
};

/// What the readings say together.
struct SlavesEvidence {
  std::size_t followers = 0;
  std::size_t unread = 0;  // of them: nothing is known yet
  std::size_t over = 0;    // of them: the own reading is over the limit, and nothing newer says otherwise
  std::size_t alike = 0;   // where one is over the limit: those to the same side, and at least half as far
  int worst = -1;          // position of the one with the largest reading; -1: none was read
  std::uint32_t worst_ns = 0;
  Nanoseconds newest = 0;  // reading of any of them
  Nanoseconds oldest = 0;  // of the one of which nothing has been heard for longest

  bool operator==(const SlavesEvidence&) const = default;
  /// All of them to the same side, and about as far: it is the reference clock that has moved, not they. Where not all
  /// are over the limit, they must be three: the second of two is often to the same side by chance.
  [[nodiscard]] bool all_alike() const {
    constexpr std::size_t kMany = 3;
    return followers >= 2 && over > 0 && alike == followers && (over == followers || followers >= kMany);
  }
};
/// `within`: when an or-ed value last showed all followers within the limit.
[[nodiscard]] SlavesEvidence weigh(std::span<const ClockReading> readings, std::uint32_t limit_ns,
                                   std::optional<Nanoseconds> within);

/// In sync when all followers have stayed within 2^n - 1 ns for the settle time; out of sync at once when one leaves.
/// Unknown while nobody leads, or when readings are older than `stale`: then nothing is claimed. States and
/// transitions only; one thread.
class SyncVerdict {
 public:
  enum class State : std::uint8_t { kNotMonitored, kSettling, kInSync, kOutOfSync, kUnknown };
  enum class Edge : std::uint8_t { kNone, kInSync, kOutOfSync, kUnknown };
  struct Input {
    Nanoseconds time = 0;
    bool led = true;  // there is a reference clock that hands out its time
    std::span<const ClockReading> readings;
    std::optional<OredReading> ored;  // of this cycle
    /// Positions of those whose readings may be others than in the cycle before, while who follows has stayed; without
    /// it everything may be, and all are looked at.
    std::optional<std::span<const std::uint16_t>> changed = std::nullopt;
  };

  SyncVerdict() = default;
  /// `monitored`: configured, and there is somebody to follow. `start`: settled_after() counts from here.
  SyncVerdict(const SyncWindowSettings& settings, bool monitored, Nanoseconds stale, Nanoseconds start);
  Edge observe(const Input& input);

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] Nanoseconds since() const { return since_; }
  [[nodiscard]] std::uint32_t limit_ns() const { return limit_ns_; }
  /// Of the latest cycle, monitored or not.
  [[nodiscard]] const SlavesEvidence& evidence() const { return evidence_; }
  /// The or-ed value is over the limit and says nothing by that: individual readings must tell, soon.
  [[nodiscard]] bool undecided() const { return undecided_; }
  /// Time from start to the beginning of the settle time that led to in sync for the first time.
  [[nodiscard]] std::optional<Nanoseconds> settled_after() const { return settled_after_; }

 private:
  [[nodiscard]] SlavesEvidence weighed(const Input& input) const;
  Edge enter(State state, Edge edge, Nanoseconds time);
  Edge judge(const Input& input, bool over);

  State state_ = State::kNotMonitored;
  bool monitored_ = false;
  std::uint32_t limit_ns_ = 0;
  Nanoseconds settle_ = 0, stale_ = 0, start_ = 0, since_ = 0;
  SlavesEvidence evidence_;
  bool undecided_ = false;
  bool was_in_sync_ = false;
  std::optional<Nanoseconds> within_, good_since_, settled_after_;
};

}  // namespace syncline::dc
