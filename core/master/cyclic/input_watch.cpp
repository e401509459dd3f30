// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/input_watch.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/exchange/run_state.h"
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
/// Cycles behind each two, in which other evidence is read.
constexpr std::uint8_t kForOthers = 1;

}  // namespace

std::optional<std::uint8_t> input_sync_manager(const SlaveConfig& slave) {
  for (const auto& [number, manager] : recover::register_writes(slave.init_cmds).sync_managers) {
    if (manager.enabled() && manager.length > 0 && !manager.is_mailbox() && !manager.ecat_writes()) return number;
  }
  return std::nullopt;
}

InputWatch::InputWatch(RunState& run) : run_(run) {
  const auto& config = run.config();
  // With several tasks the inputs of some are not read in every cycle.
  if (config.cyclic.size() != 1) return;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto manager = input_sync_manager(config.slaves[i]);
    if (!manager || !config.slaves[i].receive) continue;
    Slave slave;
    slave.position = static_cast<std::uint16_t>(i);
    slave.address = static_cast<std::uint16_t>(reg::sync_manager(*manager) + kStatusOffset);
    slaves_.push_back(slave);
  }
}

bool InputWatch::worth_reading(const Slave& slave) const {
  const auto& status = run_.snapshot.slaves[slave.position];
  return status.present && status.al_status == static_cast<std::uint16_t>(AlState::kOp);
}

void InputWatch::next() {
  first_.reset();
  current_ = (current_ + 1) % slaves_.size();
  pause_ = kForOthers;
  // Slow firmware has a rhythm of its own; to look in the same rhythm would be to see always the same of it.
  if (current_ == 0) pause_ = static_cast<std::uint8_t>(pause_ + shuffle_.next() % 4);
}

bool InputWatch::add_to(PendingFrame& frame) {
  asked_ = false;
  if (slaves_.empty()) return false;
  if (pause_ > 0) {
    --pause_;
    return false;
  }
  constexpr int kTries = 16;  // nobody being in OP is no hang
  int tried = 0;
  for (; !worth_reading(slaves_[current_]) && tried < kTries; ++tried) {
    auto& slave = slaves_[current_];
    slave.readings = 0;  // it begins anew when it comes back
    slave.regular = false;
    slave.stale_since.reset();
    next();
  }
  if (tried > 0) return false;  // in the next cycles
  const auto& slave = slaves_[current_];
  byte_.fill(0);
  datagram_ = {Command::kFprd, device_address(run_.config().slaves[slave.position].station_address, slave.address),
               byte_};
  asked_ = frame.add(datagram_);
  return asked_;
}

void InputWatch::take(Nanoseconds send_time, bool read) {
  const auto between = send_time - std::exchange(last_send_, send_time);
  if (!std::exchange(asked_, false) || !read || !datagram_.done()) {
    first_.reset();
    return;
  }
  const auto buffer = static_cast<std::uint8_t>((byte_[0] >> kBufferShift) & 3U);
  // In less than a cycle a slave that renews them once a cycle may not have done so yet.
  const bool whole_cycle = between + kNearly >= run_.config().cycle_time();
  if (!first_ || !whole_cycle || buffer == kNoBuffer) {
    first_ = buffer;
    if (buffer == kNoBuffer) next();
    return;
  }
  note(slaves_[current_], *first_ == buffer, send_time);
  next();
}

void InputWatch::note(Slave& slave, bool stale, Nanoseconds time) {
  slave.stale = slave.stale << 1U | (stale ? 1U : 0U);
  slave.readings = static_cast<std::uint8_t>(std::min<int>(slave.readings + 1, kInputLearning));
  if (slave.regular) return judge(slave, time);
  if (slave.readings < kInputLearning) return;
  slave.regular = std::popcount(slave.stale) <= kFew;
}

void InputWatch::judge(Slave& slave, Nanoseconds time) {
  const auto& watchdog = run_.snapshot.slaves[slave.position].evidence.pdi_watchdog;
  const auto count = std::popcount(slave.stale & kWindowMask);
  const auto tell = [&](bool begun) {
    run_.event(time, slave.position, events::StaleInputs{begun, static_cast<std::uint32_t>(count), kWindow});
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
