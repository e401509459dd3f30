// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/run_state.h"

#include <utility>

#include "channels/master_channels.h"
#include "config/network_config.h"

namespace syncline {

RunState::RunState(const NetworkConfig& config, MasterChannels& channels, SharedText adapter)
    : teller(config, channels.events),
      mailboxes(config.slaves.size()),
      states(config, snapshot, teller, mailboxes),
      link(snapshot, teller, std::move(adapter)),
      config_(config),
      channels_(channels) {
  for (std::size_t slave = 0; slave < mailboxes.size(); ++slave) {
    auto& mailbox = mailboxes[slave];
    mailbox.port = mailbox_port(config.slaves[slave]);
    mailbox.port.full = [&mailbox] { return mailbox.full; };
    mailbox.on_emergency = [this, slave](const coe::Emergency& what, Nanoseconds now) {
      teller.emergency(slave, what, now);
    };
  }
  snapshot.cycle_time = config.cycle_time();
  snapshot.slaves.resize(config.slaves.size());
}

}  // namespace syncline
