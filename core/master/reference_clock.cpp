// SPDX-License-Identifier: Apache-2.0
#include "master/reference_clock.h"

namespace syncline {
namespace {

using Who = CyclicFrameSet::Leader::Who;

/// Below SAFEOP a slave's clock may be in the middle of being set up.
bool can_lead(const SlaveStatus& slave) {
  const auto state = al_state_of(slave.al_status);
  return slave.present && slave.dc_enabled && (state == AlState::kSafeop || state == AlState::kOp);
}

}  // namespace

void ReferenceClock::start(std::uint16_t configured, std::uint16_t leader, bool by_place) {
  configured_ = configured;
  leader_ = leader;
  if (by_place) {
    frames_.follow({});
  } else {
    frames_.follow({Who::kOther, run_.config().slaves[leader].station_address});
  }
}

void ReferenceClock::look(Nanoseconds time) {
  if (!configured_) return;
  auto& slaves = run_.snapshot.slaves;
  if (leader_ && slaves[*leader_].present) return;
  if (leader_) {
    run_.event(EventKind::kReferenceClock, time, *leader_, 0);
    slaves[*leader_].is_reference_clock = false;
    leader_.reset();
    sync_.leader_lost(time);
    frames_.follow({Who::kNobody, 0});
  }
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (i == *configured_ || !can_lead(slaves[i])) continue;
    frames_.follow({Who::kOther, run_.config().slaves[i].station_address});
    lead(static_cast<std::uint16_t>(i), time);
    run_.event(EventKind::kReferenceClock, time, static_cast<int>(i), 2);
    return;
  }
}

void ReferenceClock::take_back(Nanoseconds time) {
  if (!configured_ || leader_ == configured_) return;
  if (leader_) run_.snapshot.slaves[*leader_].is_reference_clock = false;
  frames_.follow({Who::kOther, run_.config().slaves[*configured_].station_address});
  lead(*configured_, time);
  run_.event(EventKind::kReferenceClock, time, *configured_, 1);
}

void ReferenceClock::lead(std::uint16_t position, Nanoseconds time) {
  leader_ = position;
  run_.snapshot.slaves[position].is_reference_clock = true;
  sync_.leader_found(position, time);
}

}  // namespace syncline
