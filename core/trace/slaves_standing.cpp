// SPDX-License-Identifier: Apache-2.0
#include "trace/slaves_standing.h"

#include <algorithm>

#include "config/hot_connect_groups.h"
#include "config/network_config.h"
#include "protocol/al_state.h"
#include "trace/sample_store.h"
#include "trace/sync_overview.h"

namespace syncline {

std::optional<SlavesStanding> slaves_standing(const NetworkConfig& config, const SampleStore& samples,
                                              const SyncOverview& overview) {
  SlavesStanding standing{.slaves = samples.slave_count()};
  const auto heads = hot_connect_heads(config.slaves);
  bool told = false;
  for (std::size_t slave = 0; slave < standing.slaves; ++slave) {
    told = told || !samples.series(Signal::kAlState, slave).empty();
    // What holds last holds on: a slave that goes is heard of at once.
    const auto* states = samples.held(Signal::kAlState, slave);
    const auto state = states->at(std::min(overview.end, states->heard()));
    const bool followed = slave < overview.followed.size() && overview.followed[slave];
    standing.followers += followed ? 1 : 0;
    if (!state && slave < heads.size() && heads[slave]) continue;  // it may be away
    if (!state) {
      ++standing.silent;
      standing.silent_followers += followed ? 1 : 0;
    } else if (static_cast<std::uint16_t>(state->value) == static_cast<std::uint16_t>(AlState::kOp)) {
      ++standing.in_op;
    }
  }
  return told ? std::optional(standing) : std::nullopt;
}

}  // namespace syncline
