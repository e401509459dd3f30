// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/reference_clock.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/clocks/dc_loop_values.h"
#include "master/clocks/loop_tuning.h"
#include "master/exchange/event_teller.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

using What = events::ReferenceClockChanged::What;

using Leader = CyclicFrameSet::Leader;

constexpr int kLeadReadings = 16;
constexpr std::int64_t kLeadNear = 50;      // ns: what the others do not notice
constexpr std::int64_t kLeadBorne = 1'000;  // ns: at the most, where they are out of sync
constexpr std::int64_t kLimitShare = 4;     // nor this part of the sync window
constexpr int kNearInARow = 4;
/// A clock that is not near by then steps the others when it leads again; they bear it.
constexpr Nanoseconds kLeadPatience = 10 * kSecond;

/// What it is told is where it will be by itself, and a push. One that is told a time to be at would swing, who learns
/// as quickly as a follower and averages.
bool is_pushed(DcmMode mode, bool substitute) {
  return mode == DcmMode::kBusShift || mode == DcmMode::kDcx || (substitute && mode == DcmMode::kMasterRefClock);
}

}  // namespace

/// Below SAFEOP a slave's clock may be in the middle of being set up.
bool ReferenceClock::can_lead(std::size_t slave) const {
  const auto& status = snapshot_.slaves[slave];
  return status.present && status.dc_enabled && has_process_data_communication(al_state_of(status.al_status));
}

void ReferenceClock::start(std::uint16_t home, std::uint16_t leader, bool by_place) {
  home_ = home;
  leader_ = leader;
  by_place_ = places_right_ = by_place;
  on_way_ = on_way();
  approach_.reset();
  address(true);
}

void ReferenceClock::address(bool settled) {
  if (!home_) return;
  Leader wanted{Leader::Who::kNobody, 0};
  if (leader_) wanted = {Leader::Who::kOther, config_.slaves[*leader_].station_address};
  // The frames of a file mean the clock that leads in that file; who leads here may have been chosen otherwise.
  const bool configured = leader_ == home_ && frames_.configured_for(*home_, config_.slaves[*home_].station_address);
  if (config_.frmw_unknown && configured && by_place_ && places_right_ && settled) wanted = {};
  if (frames_.leader() != wanted) frames_.follow(wanted);
}

std::optional<std::uint16_t> ReferenceClock::station() const {
  if (!leader_) return std::nullopt;
  return config_.slaves[*leader_].station_address;
}

void ReferenceClock::look(Nanoseconds time) {
  if (!home_) return;
  auto& slaves = snapshot_.slaves;
  places_right_ = std::all_of(slaves.begin(), slaves.begin() + *home_, [](const SlaveStatus& s) { return s.present; });
  if (leader_ && slaves[*leader_].present) {
    const auto there = on_way();
    if (std::exchange(on_way_, there) == there) return;
    sync_.way_changed();
    // Its place was another's until that was seen, and it was told the time as one that follows.
    if (!steers_reference_clock(config_.dc.dcm.mode)) tune(*leader_);
    return;
  }
  if (leader_) {
    teller_.tell(time, *leader_, events::ReferenceClockChanged{What::kLost});
    lose_lead();
    sync_.leader_lost(time);
  }
  // Not set up anew, so it has gone on by itself with what it had learned.
  if (can_lead(*home_)) return lead(*home_, time);
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (can_lead(i)) return lead(static_cast<std::uint16_t>(i), time);
  }
}

std::ptrdiff_t ReferenceClock::on_way() const {
  const auto& slaves = snapshot_.slaves;
  return std::count_if(slaves.begin(), slaves.begin() + *leader_, [](const SlaveStatus& s) { return s.present; });
}

std::optional<std::uint16_t> ReferenceClock::candidate(std::span<const std::size_t> slaves) const {
  std::optional<std::uint16_t> first;
  for (const auto slave : slaves) {
    if (!snapshot_.slaves[slave].dc_enabled) continue;
    if (slave == home_) return home_;
    if (!first) first = static_cast<std::uint16_t>(slave);
  }
  return first;
}

void ReferenceClock::lead(std::uint16_t position, Nanoseconds time) {
  hand_over(position);
  sync_.leader_found(position, time, position != home_);
  teller_.tell(time, position, events::ReferenceClockChanged{position == home_ ? What::kPresent : What::kTookOver});
}

/// The last message to a clock that follows was what the master believed, with the noise of a send stamp: in front of
/// the leader always, and of anybody where the leader was gone already. Where the master steers the clock that leads,
/// it goes on telling it the time, with the host's jitter: the one that has come home learned quickly
/// (DcLoopRole::kReturning) and averages as a leader now. So does a substitute, or all who follow it would run after
/// each stamp.
void ReferenceClock::tune(std::uint16_t position) {
  const auto mode = config_.dc.dcm.mode;
  if (config_.dc.dcm.standard_loop_values) return;
  if (!steers_reference_clock(mode)) {
    tuning_.settle(position);
  } else if (is_pushed(mode, position != home_)) {
    tuning_.settle(position, difference_depth(config_, DcLoopRole::kLeader));
  } else if (position == home_) {
    tuning_.set_depth(position, difference_depth(config_, DcLoopRole::kLeader));
  }
}

void ReferenceClock::lose_lead() {
  if (!leader_) return;
  snapshot_.slaves[*leader_].is_reference_clock = false;
  const auto& settings = config_.dc.dcm;
  if (is_pushed(settings.mode, true) && leader_ != home_ && !settings.standard_loop_values)
    tuning_.set_depth(*leader_,
                      difference_depth(config_, *leader_ < *home_ ? DcLoopRole::kInFront : DcLoopRole::kFollower));
  leader_.reset();
}

void ReferenceClock::hand_over(std::uint16_t position) {
  lose_lead();
  tune(position);
  leader_ = position;
  on_way_ = on_way();
  snapshot_.slaves[position].is_reference_clock = true;
  approach_.reset();
}

void ReferenceClock::watch(Nanoseconds time) {
  if (!home_ || !leader_ || leader_ == home_) return;
  if (!can_lead(*home_)) return approach_.reset();
  if (!approach_) approach_ = Approach{time, time};
  if (!is_near() && time - approach_->begin < kLeadPatience) return;
  hand_over(*home_);
  sync_.leader_moved(*home_);
  teller_.tell(time, *home_, events::ReferenceClockChanged{What::kPresent});
}

void ReferenceClock::add_to(PendingFrame& frame) {
  comparison_.asked = false;
  if (!approach_ || !leader_ || *home_ >= *leader_) return;
  const auto& slaves = config_.slaves;
  const std::array stations{slaves[*home_].station_address, slaves[*leader_].station_address};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    comparison_.bytes[i].fill(0);
    comparison_.datagrams[i] = {Command::kFprd, device_address(stations[i], reg::kSystemTime), comparison_.bytes[i]};
  }
  comparison_.asked = frame.add(comparison_.datagrams[0]) && frame.add(comparison_.datagrams[1]);
}

/// Slaves that are further away from the substitute than the sync window allows have more to bear already: a substitute
/// that the host steers moves with its jitter, and they run after it.
std::int64_t ReferenceClock::near_enough() const {
  const auto& dc = snapshot_.dc;
  if (!dc.monitored) return kLeadNear;
  const std::int64_t borne = dc.over_limit > 0 ? dc.deviation_ns.value_or(0) : 0;
  return std::max({kLeadNear, dc.limit_ns / kLimitShare, std::min(borne, kLeadBorne)});
}

bool ReferenceClock::is_near() { return *home_ < *leader_ ? compares_near() : follows_near(); }

/// A clock in front of its substitute is told what the master believes: its 0x092C is the host's jitter, of a
/// microsecond and more. So the clocks themselves are compared; in a row, because one that passes by is not near.
bool ReferenceClock::compares_near() {
  const auto& [mine, leaders] = comparison_.datagrams;
  if (!std::exchange(comparison_.asked, false) || !mine.done() || !leaders.done()) return false;
  const auto ahead =
      static_cast<std::int32_t>(load_le<std::uint32_t>(mine.data) - load_le<std::uint32_t>(leaders.data));
  approach_->near = std::abs(std::int64_t{ahead}) <= near_enough() ? approach_->near + 1 : 0;
  return approach_->near >= kNearInARow;
}

/// Behind it, it follows its time; in the mean of some readings.
bool ReferenceClock::follows_near() {
  const auto& status = snapshot_.slaves[*home_];
  if (!status.deviation_valid || status.deviation_time <= approach_->last_reading) return false;
  approach_->last_reading = status.deviation_time;
  approach_->sum += status.deviation_ns;
  if (++approach_->readings < kLeadReadings) return false;
  const auto sum = approach_->sum;
  approach_->sum = approach_->readings = 0;
  return std::abs(sum) <= near_enough() * kLeadReadings;
}

}  // namespace syncline
