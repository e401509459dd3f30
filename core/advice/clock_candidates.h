// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace syncline {

struct Project;

/// What speaks against a slave as reference clock.
enum class ClockConcern : std::uint8_t {
  kNone,
  kNoClock,         // its description has no distributed clocks: it cannot lead
  kMayBeMissing,    // optional or hot connect: while it is absent, nobody leads
  kBehindFollower,  // a slave before it uses DC: the time of the frame that passes comes too late for that one
};

struct ClockCandidate {
  ClockConcern concern = ClockConcern::kNone;
  /// The first slave that would not follow; of kBehindFollower.
  std::size_t follower = 0;
  /// It can be chosen, wise or not.
  [[nodiscard]] bool capable() const { return concern != ClockConcern::kNoClock; }
  bool operator==(const ClockCandidate&) const = default;
};

/// One for each slave, in the order of the frame; the gravest concern of each. Pure.
[[nodiscard]] std::vector<ClockCandidate> clock_candidates(const Project& project);

}  // namespace syncline
