// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/link_presence.h"
#include "master/exchange/slave_mailbox.h"
#include "master/exchange/slave_states.h"

namespace syncline {

struct MasterChannels;
struct NetworkConfig;

/// What those who take part in running a bus share, put together: owned by the operation, seen whole by the few that
/// build others or lead slaves (tests/house says who). The others get those of its parts that they need. Lives in the
/// thread that runs the cycle.
class RunState {
 public:
  /// `adapter`: name of the link, for what is told of it.
  RunState(const NetworkConfig& config, MasterChannels& channels, SharedText adapter = {});
  RunState(const RunState&) = delete;
  RunState& operator=(const RunState&) = delete;

  [[nodiscard]] const NetworkConfig& config() const { return config_; }
  [[nodiscard]] MasterChannels& channels() { return channels_; }

  EventTeller teller;
  Snapshot snapshot;                    // latest status of everything
  std::vector<SlaveMailbox> mailboxes;  // per slave; stays where it is
  SlaveStates states;
  LinkPresence link;

 private:
  const NetworkConfig& config_;
  MasterChannels& channels_;
};

}  // namespace syncline
