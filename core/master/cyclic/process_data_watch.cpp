// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/process_data_watch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "channels/snapshot.h"
#include "channels/sync_standing.h"
#include "config/command_data.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/exchange/event_teller.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "recover/register_writes.h"

namespace syncline {
namespace {

constexpr std::uint16_t kStatusOffset = 5;
constexpr unsigned kBufferShift = 4;
constexpr std::uint8_t kNoBuffer = 3;  // none was written yet
constexpr std::uint8_t kWindow = 16;   // readings that are judged
constexpr std::uint32_t kWindowMask = (1U << kWindow) - 1;
constexpr std::uint8_t kInputLearning = 32;
constexpr int kFew = 1, kMany = 6;
/// What lasts shorter is an interrupt, or firmware that hangs until its watchdog (100 ms) tells.
constexpr Nanoseconds kLasts = 400 * kMillisecond;
constexpr Nanoseconds kNearly = 1 * kMicrosecond;
/// Cycles behind each one or two, in which other evidence is read.
constexpr std::uint8_t kForOthers = 1;

constexpr unsigned kFirstManager = 8;  // bit of SM0 in 0x0220

/// The first SyncManager of buffers in this direction; nothing when the configuration sets none.
std::optional<std::uint8_t> process_data_manager(const SlaveConfig& slave, bool outputs) {
  for (const auto& [number, manager] : recover::register_writes(slave.init_cmds).sync_managers) {
    if (manager.enabled() && manager.length > 0 && !manager.is_mailbox() && manager.ecat_writes() == outputs)
      return number;
  }
  return std::nullopt;
}

/// Cycles from one SYNC0 to the next, in which a slave does its work once; 0: no whole number, or too many to wait for.
std::uint8_t cycles_of_sync0(const SlaveDcConfig& dc, Nanoseconds cycle_time) {
  constexpr Nanoseconds kMost = 8;
  if (dc.cycle_time0 <= cycle_time) return 1;
  const auto cycles = dc.cycle_time0 / cycle_time;
  return dc.cycle_time0 % cycle_time == 0 && cycles <= kMost ? static_cast<std::uint8_t>(cycles) : std::uint8_t{0};
}

}  // namespace

ProcessDataWatch::ProcessDataWatch(const NetworkConfig& config, const Snapshot& snapshot, EventTeller& teller)
    : config_(config), snapshot_(snapshot), teller_(teller) {
  // Whose task is slower need not do anything in each cycle.
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (is_exchanged_in_each_cycle(config, i)) add_slave(i);
  }
}

void ProcessDataWatch::add_slave(std::size_t position) {
  const auto& config = config_.slaves[position];
  const bool outputs = !config.receive;
  if (outputs && !config.send) return;
  const auto manager = process_data_manager(config, outputs);
  if (!manager) return;
  Slave slave;
  slave.position = static_cast<std::uint16_t>(position);
  slave.has_sync0 = config.dc && config.dc->assign_activate != 0;
  if (slave.has_sync0) slave.cycles = cycles_of_sync0(*config.dc, config_.cycle_time());
  // What it has taken is seen in one of them, and in which one is by chance.
  if (slave.cycles == 0 || (outputs && slave.cycles > 1)) return;
  if (outputs) {
    const auto bit = kFirstManager + *manager;
    slave.address = static_cast<std::uint16_t>(reg::kAlEventRequest + bit / 8);
    slave.event = static_cast<std::uint8_t>(1U << bit % 8);
  } else {
    slave.address = static_cast<std::uint16_t>(reg::sync_manager(*manager) + kStatusOffset);
  }
  slaves_.push_back(slave);
}

bool ProcessDataWatch::worth_reading(const Slave& slave) const {
  const auto& status = snapshot_.slaves[slave.position];
  return status.present && status.al_status == static_cast<std::uint16_t>(AlState::kOp);
}

/// Not for ever: where nothing rides, or no two frames are far enough apart, nothing is known of anybody.
void ProcessDataWatch::try_again() {
  constexpr std::uint8_t kTries = 8;
  if (++tries_ >= kTries) return go_on();
  first_.reset();
  pause_ = kForOthers;
}

void ProcessDataWatch::go_on() {
  first_.reset();
  tries_ = 0;
  const bool stays = looked_into_ > 0;
  if (stays) {
    --looked_into_;
  } else {
    current_ = (current_ + 1) % slaves_.size();
  }
  pause_ = kForOthers;
  // Slow firmware has a rhythm of its own; to look in the same rhythm would be to see always the same of it.
  if (stays || current_ == 0) pause_ = static_cast<std::uint8_t>(pause_ + shuffle_.next() % 4);
  if (!stays && current_ == 0) may_look_into_another_ = true;
}

std::optional<ProcessDataWatch::Wish> ProcessDataWatch::next() {
  asked_ = false;
  if (slaves_.empty()) return std::nullopt;
  if (pause_ > 0) {
    --pause_;
    return std::nullopt;
  }
  constexpr int kTries = 16;  // nobody being in OP is no hang
  int tried = 0;
  for (; !worth_reading(slaves_[current_]) && tried < kTries; ++tried) {
    auto& slave = slaves_[current_];
    slave.readings = 0;  // it begins anew when it comes back
    slave.regular = false;
    slave.stale_since.reset();
    looked_into_ = 0;
    go_on();
  }
  if (tried > 0) return std::nullopt;  // in the next cycles
  const auto& slave = slaves_[current_];
  byte_.fill(0);
  datagram_ = {Command::kFprd, device_address(config_.slaves[slave.position].station_address, slave.address), byte_};
  asked_ = true;
  return Wish{&datagram_, slave.position, slave.event != 0};
}

/// What a slave does at SYNC0 is done before the next frame as long as the frames keep their distance from it.
bool ProcessDataWatch::counts(const Slave& slave, bool regular) const {
  if (!datagram_.done() || !regular) return false;
  return slave.event == 0 || !slave.has_sync0 || master_in_sync(snapshot_.dcm).value_or(false);
}

void ProcessDataWatch::Spacing::note(Nanoseconds between) {
  constexpr double kWeight = 1.0 / 64;
  const auto now = static_cast<double>(between);
  if (usual == 0) usual = now;
  varies += (std::abs(now - usual) - varies) * kWeight;
  usual += (now - usual) * kWeight;
}

/// By so much of what varies anyway that hardly any are left whose stamps only say so; all, where nothing varies.
bool ProcessDataWatch::Spacing::exceeded_by(Nanoseconds between) const {
  constexpr double kShare = 0.3, kSame = 1;
  return static_cast<double>(between) >= usual + kShare * varies - kSame;
}

bool ProcessDataWatch::far_enough(const Slave& slave, Nanoseconds between) const {
  return between + kNearly >= config_.cycle_time() && (slave.has_sync0 || spacing_.exceeded_by(between));
}

void ProcessDataWatch::take(Nanoseconds send_time, bool regular) {
  const auto passed = send_time - std::exchange(last_send_, send_time);
  if (2 * std::abs(passed - config_.cycle_time()) < config_.cycle_time()) spacing_.note(passed);
  if (slaves_.empty()) return;
  auto& slave = slaves_[current_];
  if (!std::exchange(asked_, false)) {
    if (first_ && !(regular && far_enough(slave, passed))) try_again();  // between the two
    return;
  }
  if (!counts(slave, regular)) return try_again();
  const bool outputs = slave.event != 0;
  const auto buffer = static_cast<std::uint8_t>((byte_[0] >> kBufferShift) & 3U);
  if (!outputs && buffer == kNoBuffer) return go_on();
  if (!first_) {
    first_ = buffer;
    pause_ = static_cast<std::uint8_t>(slave.cycles - 1);
    return;
  }
  if (!far_enough(slave, passed)) return try_again();
  note(slave, outputs ? (byte_[0] & slave.event) != 0 : *first_ == buffer, send_time);
  go_on();
}

void ProcessDataWatch::note(Slave& slave, bool stale, Nanoseconds time) {
  slave.stale = slave.stale << 1U | (stale ? 1U : 0U);
  slave.readings = static_cast<std::uint8_t>(std::min<int>(slave.readings + 1, kInputLearning));
  if (slave.regular) {
    if (stale && !slave.told && std::exchange(may_look_into_another_, false)) looked_into_ = kWindow;
    return judge(slave, time);
  }
  if (slave.readings < kInputLearning) return;
  slave.regular = std::popcount(slave.stale) <= kFew;
}

void ProcessDataWatch::judge(Slave& slave, Nanoseconds time) {
  const auto& watchdog = snapshot_.slaves[slave.position].evidence.pdi_watchdog;
  const auto count = std::popcount(slave.stale & kWindowMask);
  const auto tell = [&](bool begun) {
    teller_.tell(time, slave.position,
                 events::StaleProcessData{begun, static_cast<std::uint32_t>(count), kWindow, slave.event != 0});
  };
  if (count <= kFew) {
    slave.stale_since.reset();
    slave.watchdog_before = watchdog.total;
    if (std::exchange(slave.told, false)) tell(false);
  } else if (count >= kMany && !slave.stale_since) {
    slave.stale_since = time;
  }
  if (!slave.stale_since || slave.told || time - *slave.stale_since < kLasts || count < kMany) return;
  if (watchdog.total != slave.watchdog_before) return;  // it hangs, or did
  slave.told = true;
  tell(true);
}

}  // namespace syncline
