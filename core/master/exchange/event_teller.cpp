// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/event_teller.h"

#include <utility>
#include <variant>

#include "channels/master_channels.h"
#include "config/network_config.h"
#include "master/exchange/slave_name.h"
#include "protocol/coe.h"
#include "support/overloaded.h"

namespace syncline {

EventTeller::EventTeller(const NetworkConfig& config, EventQueue& events) : config_(config), events_(events) {
  for (const auto& slave : config.slaves) {
    groups_.push_back(slave.hot_connect ? SharedText(slave.hot_connect->group) : SharedText());
  }
}

/// Notifications of the clocks can be switched off.
bool EventTeller::wanted(const EventDetails& what) const {
  const auto& notifications = config_.dc.notifications;
  return std::visit(Overloaded{[&](const events::ReferenceClockChanged&) { return notifications.reference_clock; },
                               [&](const events::SlavesInSync&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesOutOfSync&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesNotMonitored&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesSyncUnknown&) { return notifications.slaves_in_sync; },
                               [&](const events::DcInitialised&) { return notifications.dc_status; },
                               [&](const events::MasterInSync&) { return notifications.dcm_in_sync; },
                               [&](const events::MasterOutOfSync&) { return notifications.dcm_in_sync; },
                               [](const auto&) { return true; }},
                    what);
}

void EventTeller::tell(Nanoseconds time, int slave, EventDetails what) {
  if (wanted(what)) events_.push({time, slave, std::move(what)});
}

/// What is wrong with a slave is that slave's event: whoever looks at it finds it there.
void EventTeller::error(const Error& error, Nanoseconds time) {
  int of = -1;
  for (std::size_t slave = 0; of < 0 && slave < config_.slaves.size(); ++slave) {
    if (slave_name(config_, slave) == error.subject) of = static_cast<int>(slave);
  }
  tell(time, of, events::Failure{error});
}

void EventTeller::emergency(std::size_t slave, const coe::Emergency& emergency, Nanoseconds time) {
  tell(time, static_cast<int>(slave),
       events::Emergency{emergency.error_code, emergency.error_register, emergency.data,
                         config_.slaves[slave].identity});
}

bool EventTeller::hot_connect(std::size_t slave, events::HotConnect::What what, Nanoseconds time) {
  const auto head = config_.hot_connect_head(slave);
  if (!head) return false;
  tell(time, static_cast<int>(slave), events::HotConnect{what, groups_[*head]});
  return true;
}

}  // namespace syncline
