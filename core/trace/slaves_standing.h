// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace syncline {

struct NetworkConfig;
class SampleStore;
struct SyncOverview;

/// Who of the slaves works: beside a verdict that speaks only of those who answer.
struct SlavesStanding {
  std::size_t slaves = 0;            // all of the configuration
  std::size_t in_op = 0;             // without an error
  std::size_t silent = 0;            // do not answer, and are of no hot-connect group
  std::size_t followers = 0;         // have followed the reference clock since the run began
  std::size_t silent_followers = 0;  // of them: do not answer, and are no part of the verdict any more
};

/// At the end of the overview; nothing where the run tells no states of slaves.
[[nodiscard]] std::optional<SlavesStanding> slaves_standing(const NetworkConfig& config, const SampleStore& samples,
                                                            const SyncOverview& overview);

}  // namespace syncline
