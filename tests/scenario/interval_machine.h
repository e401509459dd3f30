// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/confidence.h"
#include "trace/statistics.h"

/// Estimates that a run states with a 95 % interval, held against simulated machines whose truth is known.
namespace syncline::test {

/// What one machine said of itself, and what is true of it.
struct IntervalRun {
  double true_drift_ppm = 0, drift_ppm = 0;
  std::optional<Interval> drift;
  Statistics dcm_error, deviation;  // ns, of the master and of the last slave
};
/// Three terminals with clocks, led by a master that shifts itself, for `duration` (ns) of virtual time after OP. The
/// seed gives quartzes, jitter and stamps.
[[nodiscard]] IntervalRun run_interval_machine(std::uint64_t seed, std::int64_t duration);

/// Of many runs: how many stated an interval, and in which part of these the truth was inside.
struct Coverage {
  std::string what;
  std::size_t stated = 0, runs = 0;
  double held = 0, mean_width = 0;
};
/// Of seeds from `first_seed` on. The true mean is that of the machines over all runs together, of which each knows
/// next to nothing alone.
[[nodiscard]] std::vector<Coverage> interval_coverage(std::size_t runs, std::int64_t duration,
                                                      std::uint64_t first_seed);

}  // namespace syncline::test
