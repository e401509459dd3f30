// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/slave_watch.h"

#include <algorithm>
#include <utility>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/snapshot.h"
#include "channels/values/absent_after.h"
#include "config/network_config.h"
#include "master/clocks/ored_deviation.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_states.h"
#include "protocol/datagram.h"
#include "protocol/dl_status.h"
#include "protocol/registers.h"
#include "protocol/system_time_difference.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kAlReadsPerCycle = 16;
/// In which every slave has its turn; a lost frame or two leave it below half a second.
constexpr Nanoseconds kRound = 400 * kMillisecond;
/// The master's own port counts as that of slave -1.
constexpr int kMaster = -1;

struct AlStatus {
  std::uint16_t status = 0, code = 0;
  explicit AlStatus(std::span<const std::uint8_t> bytes)
      : status(load_le<std::uint16_t>(bytes)), code(load_le<std::uint16_t>(bytes.subspan(4))) {}
};

}  // namespace

SlaveWatch::SlaveWatch(const NetworkConfig& config, Snapshot& snapshot, SlaveStates& states, EventTeller& teller)
    : config_(config),
      snapshot_(snapshot),
      states_(states),
      teller_(teller),
      al_(config.slaves.size()),
      cycles_per_round_(
          std::max<std::size_t>(1, static_cast<std::size_t>(kRound / std::max<Nanoseconds>(1, config.cycle_time())))),
      next_al_(al_.size()) {
  turns_.resize(al_.size() / cycles_per_round_ + 1);
  deviations_read_.reserve(deviations_.size());
  for (std::size_t i = 0; i < al_.size(); ++i) {
    al_[i].datagram = {Command::kFprd, device_address(config.slaves[i].station_address, reg::kAlStatus), al_[i].bytes};
    al_[i].dl_datagram = {Command::kFprd, device_address(config.slaves[i].station_address, reg::kDlStatus),
                          al_[i].dl_bytes};
  }
  all_ = {Command::kBrd, device_address(0, reg::kSystemTimeDifference), all_bytes_};
}

bool SlaveWatch::observe_broadcast(std::uint16_t al_status, std::uint16_t wkc) {
  const bool others = last_wkc_ && last_wkc_ != wkc;
  const bool changed = last_status_ != al_status || last_wkc_ != wkc;
  last_status_ = al_status;
  last_wkc_ = wkc;
  if (changed) refresh_al_status();
  return others;
}

void SlaveWatch::observe_silence(bool silent, Nanoseconds time) {
  if (!silent) {
    silent_since_.reset();
    return;
  }
  if (!silent_since_) silent_since_ = time;
  if (time - *silent_since_ < kAbsentAfter || last_wkc_ == 0) return;
  last_wkc_ = 0;  // the first answer is a change
  next_al_ = al_.size();
  const bool any = std::ranges::any_of(snapshot_.slaves, &SlaveStatus::present);
  if (any && snapshot_.link_up) tell_cable(time, 0, false);
  for (auto& reading : al_) reading.datagram.wkc = 0;
  for (std::size_t i = 0; i < al_.size(); ++i) states_.set_present(i, false, time);
  states_.update_master_state(time);
  ++sweeps_;
}

void SlaveWatch::add_to(PendingFrame& frame, bool read_deviation_of_all, bool hurry) {
  asked_deviations_ = 0;
  asked_all_ = false;
  const auto wanted = std::min(hurry ? deviations_.size() : 1, dc_slaves_.size());
  while (asked_deviations_ < wanted && add_deviation(frame)) {
  }
  if (read_deviation_of_all) {
    all_bytes_.fill(0);
    asked_all_ = frame.add(all_);
  }
  add_al_status(frame);
  add_turns(frame);
}

bool SlaveWatch::add_deviation(PendingFrame& frame) {
  auto& reading = deviations_[asked_deviations_];
  reading.slave = dc_slaves_[next_dc_ % dc_slaves_.size()];
  reading.bytes.fill(0);
  const auto station = config_.slaves[reading.slave].station_address;
  reading.datagram = {Command::kFprd, device_address(station, reg::kSystemTimeDifference), reading.bytes};
  if (!frame.add(reading.datagram)) return false;
  ++asked_deviations_;
  ++next_dc_;
  return true;
}

void SlaveWatch::add_al_status(PendingFrame& frame) {
  asked_begin_ = asked_end_ = next_al_;
  while (next_al_ < al_.size() && asked_end_ - asked_begin_ < kAlReadsPerCycle) {
    auto& reading = al_[next_al_];
    reading.bytes.fill(0);
    reading.dl_bytes.fill(0);
    if (!frame.add(reading.dl_datagram) || !frame.add(reading.datagram)) break;
    asked_end_ = ++next_al_;
  }
}

/// None while a sweep reads them all, or while nobody answers.
void SlaveWatch::add_turns(PendingFrame& frame) {
  turns_asked_ = 0;
  if (refreshing() || last_wkc_.value_or(0) == 0) return;
  for (turn_credit_ += al_.size(); turn_credit_ >= cycles_per_round_ && turns_asked_ < turns_.size(); ++turns_asked_) {
    auto& turn = turns_[turns_asked_];
    turn.slave = next_turn_;
    turn.bytes.fill(0);
    turn.datagram = {Command::kFprd, device_address(config_.slaves[turn.slave].station_address, reg::kAlStatus),
                     turn.bytes};
    if (!frame.add(turn.datagram)) break;
    turn_credit_ -= cycles_per_round_;
    next_turn_ = (next_turn_ + 1) % al_.size();
  }
  turn_credit_ = std::min(turn_credit_, cycles_per_round_ * turns_.size());
}

void SlaveWatch::take_turns(Nanoseconds time) {
  for (std::size_t i = 0; i < turns_asked_; ++i) {
    const auto& turn = turns_[i];
    if (!turn.datagram.answered) {  // the frame was lost: once more
      next_turn_ = turn.slave;
      turn_credit_ += cycles_per_round_ * (turns_asked_ - i);
      break;
    }
    if (is_news(turn)) {
      refresh_al_status();
    } else if (turn.datagram.wkc > 0) {
      snapshot_.slaves[turn.slave].al_status_time = time;
    }
  }
  turns_asked_ = 0;
}

bool SlaveWatch::is_news(const Turn& turn) const {
  const auto& known = snapshot_.slaves[turn.slave];
  const bool present = turn.datagram.wkc > 0;
  if (!present || !known.present) return present != known.present;
  const AlStatus read(turn.bytes);
  return read.status != known.al_status || read.code != known.al_status_code;
}

std::optional<OredDeviation> SlaveWatch::take(Nanoseconds time, CycleSample& sample) {
  take_deviations(time, sample);
  take_turns(time);
  take_al_status(time);
  if (!std::exchange(asked_all_, false) || !all_.done()) return std::nullopt;
  return OredDeviation{SystemTimeDifference{load_le<std::uint32_t>(all_bytes_)}.magnitude(), all_.wkc};
}

/// The sample shows the last one.
void SlaveWatch::take_deviations(Nanoseconds time, CycleSample& sample) {
  deviations_read_.clear();
  for (std::size_t i = 0; i < asked_deviations_; ++i) {
    const auto& reading = deviations_[i];
    if (!reading.datagram.done()) continue;
    const auto deviation =
        static_cast<std::int32_t>(SystemTimeDifference{load_le<std::uint32_t>(reading.bytes)}.signed_value());
    auto& slave = snapshot_.slaves[reading.slave];
    slave.deviation_ns = deviation;
    slave.deviation_valid = true;
    slave.deviation_time = time;
    deviations_read_.push_back(reading.slave);
    sample.slave_position = static_cast<std::int16_t>(reading.slave);
    sample.slave_deviation_ns = deviation;
  }
}

void SlaveWatch::take_al_status(Nanoseconds time) {
  if (asked_begin_ == asked_end_) return;
  for (std::size_t i = asked_begin_; i < asked_end_; ++i) {
    if (al_[i].datagram.answered) continue;
    next_al_ = std::min(next_al_, asked_begin_);  // the frame was lost: once more
    return;
  }
  if (asked_end_ == al_.size() && next_al_ == al_.size()) finish_sweep(time);
}

void SlaveWatch::finish_sweep(Nanoseconds time) {
  ++sweeps_;
  tell_cables(time, false);
  tell_presence(time, false);
  tell_cables(time, true);
  tell_presence(time, true);
  for (std::size_t i = 0; i < al_.size(); ++i) {
    if (!al_[i].present()) continue;
    const AlStatus read(al_[i].bytes);
    states_.set_al_status(i, read.status, read.code, time);
  }
  states_.update_master_state(time);
}

/// A cable is known by the slaves at its ends: the near one answers and its port is dead, the far one does
/// not. Pulled, broken or no power behind it look the same from here.
void SlaveWatch::tell_cables(Nanoseconds time, bool healed) {
  for (std::size_t i = 0; i < al_.size(); ++i) {
    const auto& slave = snapshot_.slaves[i];
    const auto& previous = config_.slaves[i].previous;
    if (config_.hot_connect_head(i)) continue;  // its cable is meant to be plugged and pulled
    if (!previous) {
      if (healed && slave.cable_broken) tell_cable(time, i, true);  // somebody answers
      continue;
    }
    if (previous->position >= al_.size() || !al_[previous->position].present()) continue;
    const DlStatus near{load_le<std::uint16_t>(al_[previous->position].dl_bytes)};
    const bool dead = !near.active(previous->port);
    const bool broken = dead && !al_[i].present();
    const bool news = healed ? slave.cable_broken && !dead : broken && !slave.cable_broken && slave.present;
    if (news) tell_cable(time, i, healed);
  }
}

void SlaveWatch::tell_cable(Nanoseconds time, std::size_t slave, bool healed) {
  snapshot_.slaves[slave].cable_broken = !healed;
  snapshot_.slaves[slave].moved = time;
  const auto& previous = config_.slaves[slave].previous;
  const int near = previous ? previous->position : kMaster;
  const auto port = static_cast<std::uint8_t>(previous ? previous->port : 0);
  teller_.tell(time, near, events::CableChanged{port, static_cast<int>(slave), healed});
}

void SlaveWatch::tell_presence(Nanoseconds time, bool present) {
  for (std::size_t i = 0; i < al_.size(); ++i) {
    if (al_[i].present() == present) states_.set_present(i, present, time);
  }
}

}  // namespace syncline
