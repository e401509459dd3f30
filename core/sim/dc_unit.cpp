// SPDX-License-Identifier: Apache-2.0
#include "sim/dc_unit.h"

#include <algorithm>

#include "protocol/registers.h"
#include "support/random.h"

namespace syncline::sim {
namespace {

constexpr std::uint64_t kGarbage = 0x6C72'9A3E'0900'0900;

bool touches(std::uint16_t address, std::size_t length, std::uint16_t reg, std::size_t size) {
  return address < reg + size && reg < address + length;
}

}  // namespace

DcUnit::DcUnit(const OscillatorConfig& oscillator, const SimDcConfig& config, Nanoseconds power_on, std::uint64_t seed,
               EscMemory& memory)
    : memory_(memory), config_(config), wide_(config.is_64bit), clock_(oscillator, power_on, seed) {
  implement_registers(seed);
}

void DcUnit::implement_registers(std::uint64_t seed) {
  constexpr std::uint8_t kRead = EscMemory::kRead;
  constexpr std::uint8_t kBoth = EscMemory::kReadWrite;
  if (!config_.receive_times) return;
  memory_.implement(reg::kReceiveTimePort0, 4, kBoth);
  memory_.implement(reg::kReceiveTimePort1, 12, kRead);
  Random random(seed ^ kGarbage);  // what unused ports show on real ESCs: anything but zero
  for (std::uint16_t port = 0; port < 4; ++port) {
    const auto garbage = static_cast<std::uint32_t>(random.next()) | 1U;
    memory_.set<std::uint32_t>(static_cast<std::uint16_t>(reg::kReceiveTimePort0 + 4 * port), garbage);
  }
  if (!config_.system_time) return;
  const std::uint16_t width = wide_ ? 8 : 4;
  memory_.implement(reg::kSystemTime, width, kBoth);
  memory_.implement(reg::kReceiveTimeProcessingUnit, 8, kRead);
  memory_.implement(reg::kSystemTimeOffset, width, kBoth);
  memory_.implement(reg::kSystemTimeDelay, 4, kBoth);
  memory_.implement(reg::kSystemTimeDifference, 4, kRead);
  memory_.implement(reg::kSpeedCounterStart, 2, kBoth);
  memory_.implement(reg::kSpeedCounterDiff, 2, kRead);
  memory_.implement(reg::kFilterDepthDifference, 2, kBoth);
  memory_.implement(reg::kCyclicUnitControl, 2, kBoth);
  memory_.implement(reg::kPulseLength, 2, kRead);
  memory_.implement(reg::kActivationStatus, 1, kRead);
  memory_.implement(reg::kSync0Status, 2, kRead);
  memory_.implement(reg::kStartTimeCyclicOperation, width, kBoth);
  memory_.implement(reg::kNextSync1Pulse, width, kRead);
  memory_.implement(reg::kSync0CycleTime, 8, kBoth);
  memory_.implement(reg::kLatch0Control, 2, kBoth);
  memory_.implement(reg::kLatch0Status, 2, kRead);
  memory_.implement(reg::kLatch0PositiveEdge, 32, kRead);
  memory_.set<std::uint16_t>(reg::kSpeedCounterStart, TimeControlLoop::kDefaultSpeedCounterStart);
  memory_.set<std::uint8_t>(reg::kFilterDepthDifference, loop_.filter_depth_difference());
  memory_.set<std::uint8_t>(reg::kFilterDepthSpeedCounter, loop_.filter_depth_speed_counter());
}

std::uint64_t DcUnit::offset() const {
  return wide_ ? memory_.u64(reg::kSystemTimeOffset) : memory_.u32(reg::kSystemTimeOffset);
}

std::uint64_t DcUnit::system_time(Nanoseconds time) const { return masked(unwrapped_time(time)); }

void DcUnit::advance_to(Nanoseconds time) {
  if (!config_.system_time || time < now_) return;
  while (next_signal() <= time) {
    now_ = std::max(now_, *next_signal_);
    clock_.advance_to(now_);
    const auto signal = generator_.due()->signal;
    generator_.fired();
    next_signal_.reset();
    if (on_sync) on_sync(signal, now_);
  }
  now_ = time;
  if (clock_.advance_to(time)) next_signal_.reset();
}

Nanoseconds DcUnit::next_signal() {
  if (!next_signal_) {
    const auto due = generator_.due();
    // The generator counts in system time; its value minus the offset is the local time it waits for.
    next_signal_ = due ? clock_.time_of(due->time - offset()) : INT64_MAX;
  }
  return *next_signal_;
}

void DcUnit::start_of_frame(Nanoseconds time) { local_at_start_of_frame_ = clock_.sample(time); }

void DcUnit::refresh_registers() {
  if (!config_.system_time) return;
  // An ECAT read shows the time at which the frame passed the *reference* clock: the delay is subtracted.
  const auto time = masked(local_at_start_of_frame_ + offset() - memory_.u32(reg::kSystemTimeDelay));
  memory_.set<std::uint64_t>(reg::kSystemTime, time);
  memory_.set<std::uint32_t>(reg::kSystemTimeDifference, loop_.system_time_difference());
  memory_.set<std::uint16_t>(reg::kSpeedCounterDiff, static_cast<std::uint16_t>(loop_.speed_counter_diff()));
  if (generator_.active()) {
    memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, masked(generator_.next_sync0().value_or(start_time_)));
    if (const auto next = generator_.next_sync1()) memory_.set<std::uint64_t>(reg::kNextSync1Pulse, masked(*next));
  }
  write_status();
}

void DcUnit::write_status() {
  const unsigned pending = (generator_.sync0_pending() ? 1U : 0U) | (generator_.sync1_pending() ? 2U : 0U);
  memory_.set<std::uint8_t>(reg::kActivationStatus, static_cast<std::uint8_t>(pending));
}

void DcUnit::compare(Nanoseconds frame_end) {
  const auto received = memory_.u32(reg::kSystemTime);
  const auto local = static_cast<std::uint32_t>(local_at_start_of_frame_ + offset()) - memory_.u32(reg::kSystemTimeDelay);
  loop_.observe(static_cast<std::int32_t>(local - received));
  clock_.set_correction(loop_.correction(), frame_end);
}

void DcUnit::write_activation(Nanoseconds time) {
  const auto activation = memory_.u8(reg::kActivation);
  if ((activation & 0x01) == 0) {
    generator_.deactivate();
    settings_ = {};
    start_missed_ = false;
    return;
  }
  if (generator_.active()) return;
  settings_ = {(activation & 0x02) != 0, (activation & 0x04) != 0, memory_.u32(reg::kSync0CycleTime),
               memory_.u32(reg::kSync1CycleTime)};
  // A start time that has passed fires only when the counter comes round again: never, for 64 bit.
  const auto now = unwrapped_time(time);
  start_time_ = memory_.u64(reg::kStartTimeCyclicOperation);
  std::optional<std::uint64_t> first;
  if (wide_) {
    start_missed_ = start_time_ <= now;
    if (!start_missed_) first = start_time_;
  } else {
    const auto ahead = static_cast<std::uint32_t>(start_time_) - static_cast<std::uint32_t>(now);
    start_missed_ = ahead == 0 || ahead > 0x8000'0000U;
    first = now + (ahead == 0 ? std::uint64_t{1} << 32 : ahead);
  }
  if (!settings_.sync0) first.reset();
  generator_.activate(settings_, first);
}

void DcUnit::registers_written(std::uint16_t address, std::size_t length, Nanoseconds frame_end) {
  if (!config_.system_time) return;
  next_signal_.reset();
  if (touches(address, length, reg::kSystemTime, 4)) compare(frame_end);
  if (touches(address, length, reg::kSystemTimeOffset, 8)) generator_.realign(unwrapped_time(frame_end));
  if (touches(address, length, reg::kSpeedCounterStart, 2)) {
    loop_.set_speed_counter_start(memory_.u16(reg::kSpeedCounterStart));
    clock_.set_correction(loop_.correction(), frame_end);
  }
  if (touches(address, length, reg::kFilterDepthDifference, 1)) {
    loop_.set_filter_depth_difference(memory_.u8(reg::kFilterDepthDifference));
  }
  if (touches(address, length, reg::kFilterDepthSpeedCounter, 1)) {
    loop_.set_filter_depth_speed_counter(memory_.u8(reg::kFilterDepthSpeedCounter));
  }
  if (touches(address, length, reg::kStartTimeCyclicOperation, 24)) restore_locked_registers();
  if (touches(address, length, reg::kActivation, 1)) write_activation(frame_end);
}

void DcUnit::restore_locked_registers() {
  if (!generator_.active()) return;
  memory_.set<std::uint32_t>(reg::kSync0CycleTime, settings_.cycle0);
  memory_.set<std::uint32_t>(reg::kSync1CycleTime, settings_.cycle1);
  memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, masked(generator_.next_sync0().value_or(start_time_)));
}

void DcUnit::latch_processing_unit() {
  if (config_.system_time) memory_.set<std::uint64_t>(reg::kReceiveTimeProcessingUnit, local_at_start_of_frame_);
}

void DcUnit::latch_ports(const std::array<std::optional<Nanoseconds>, 4>& passed) {
  if (!config_.receive_times) return;
  for (std::uint16_t port = 0; port < 4; ++port) {
    if (!passed[port]) continue;
    memory_.set<std::uint32_t>(static_cast<std::uint16_t>(reg::kReceiveTimePort0 + 4 * port),
                               static_cast<std::uint32_t>(clock_.sample(*passed[port])));
  }
}

void DcUnit::step_clock(Nanoseconds delta) {
  clock_.step(delta);
  next_signal_.reset();
}

}  // namespace syncline::sim
