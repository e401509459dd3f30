// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/dc_unit.h"

#include <algorithm>
#include <utility>

#include "protocol/registers.h"
#include "sim/dc/correction_rates.h"
#include "sim/registers/esc_ranges.h"
#include "support/random.h"

namespace syncline::sim {
namespace {

constexpr std::uint64_t kGarbage = 0x6C72'9A3E'0900'0900, kNoise = 0x6E6F'6973'6500;

/// No quartz and no correction of it makes the counter run a quarter faster: what is due in n ns is not due before
/// this.
constexpr Nanoseconds surely_after(Nanoseconds n) { return n - n / 4; }

/// Signals that are delivered at once at most: nobody who has not asked for so long wants to see all of them.
constexpr Nanoseconds kMostSignals = 200'000;

// Bits of the activation register (0x0981).
constexpr unsigned kUnitOn = 0x01, kSync0On = 0x02, kSync1On = 0x04, kAutoActivation = 0x08, kExtendStartTime = 0x10,
                   kCheckStartTime = 0x20, kNearFuture2s = 0x40;

}  // namespace

DcUnit::DcUnit(const OscillatorConfig& oscillator, const SimDcConfig& config, Nanoseconds power_on, std::uint64_t seed,
               EscMemory& memory)
    : config_(config),
      latches_(memory, config.is_64bit),
      latch_noise_(seed ^ kNoise),
      clock_(oscillator, power_on, seed),
      memory_(memory),
      wide_(config.is_64bit),
      sign_of_older_edition_(config.sign_of_older_edition) {
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
  latches_.implement_registers();
  memory_.set<std::uint16_t>(reg::kSpeedCounterStart, TimeControlLoop::kDefaultSpeedCounterStart);
  memory_.set<std::uint8_t>(reg::kFilterDepthDifference, loop_.filter_depth_difference());
  memory_.set<std::uint8_t>(reg::kFilterDepthSpeedCounter, loop_.filter_depth_speed_counter());
}

std::uint64_t DcUnit::offset() const {
  return wide_ ? memory_.u64(reg::kSystemTimeOffset) : memory_.u32(reg::kSystemTimeOffset);
}

std::uint64_t DcUnit::system_time(Nanoseconds time) const { return masked(unwrapped_time(time)); }

bool DcUnit::has_regular_signals() const {
  const bool regular = generator_.active() && settings_.sync0 && !settings_.sync1 && settings_.cycle0 >= kShortestCycle;
  // Without an acknowledgement of the last one none comes.
  const bool stuck = memory_.u16(reg::kPulseLength) == 0 && memory_.u8(reg::kSync0Status) != 0;
  return regular && !stuck && generator_.next_sync0();
}

void DcUnit::deliver_from(Nanoseconds time) {
  const auto now = std::exchange(now_, time);
  signals_moved();
  deliver_until(now);
}

void DcUnit::leave_signals_unminded() {
  if (unminded_ || !has_regular_signals()) return;
  unminded_ = true;
  next_when_left_ = *generator_.next_sync0();
}

void DcUnit::pass_unminded() { unasked_ += generator_.skip_to(unwrapped_time(now_) + 1); }

std::optional<Nanoseconds> DcUnit::mind_signals() {
  pass_unminded();
  unminded_ = false;
  unasked_ = 0;
  signals_moved();
  const auto next = generator_.next_sync0();
  if (!next || *next == next_when_left_) return std::nullopt;
  const auto last = *next - settings_.cycle0;
  return now_ - clock_.true_duration(unwrapped_time(now_) - last);
}

void DcUnit::deliver_until(Nanoseconds time) {
  if (time < now_) return;
  if (unminded_) {
    now_ = time;
    (void)clock_.advance_to(time);
    return;
  }
  skip_signals_before(time);
  while (time >= quiet_until_ && next_signal() <= time) {
    now_ = std::max(now_, *next_signal_);
    clock_.advance_to(now_);
    const auto fired = *generator_.due();
    generator_.fired();
    next_signal_.reset();
    if (const auto next = generator_.due()) {
      quiet_until_ = now_ + surely_after(static_cast<Nanoseconds>(next->time - fired.time));
    }
    pulse(fired.signal, now_);
  }
  now_ = time;
  if (clock_.advance_to(time)) next_signal_.reset();
}

void DcUnit::skip_signals_before(Nanoseconds time) {
  const Nanoseconds cycle = settings_.cycle0;
  if (!generator_.active() || cycle < kShortestCycle || time - now_ < (kMostSignals + 1) * cycle) return;
  generator_.skip_to(unwrapped_time(time) - static_cast<std::uint64_t>(kMostSignals * cycle));
  signals_moved();
}

void DcUnit::signals_moved() {
  next_signal_.reset();
  quiet_until_ = INT64_MIN;
}

Nanoseconds DcUnit::next_signal() {
  if (!next_signal_) {
    const auto due = generator_.due();
    // The generator counts in system time; its value minus the offset is the local time it waits for.
    next_signal_ = due ? clock_.time_of(due->time - offset(), now_) : LocalClock::kNever;
    quiet_until_ = now_ + surely_after(*next_signal_ - now_);
  }
  return *next_signal_;
}

void DcUnit::pulse(SyncGenerator::Signal signal, Nanoseconds time) {
  if (memory_.u16(reg::kPulseLength) == 0) {
    const auto status = signal == SyncGenerator::Signal::kSync0 ? reg::kSync0Status : reg::kSync1Status;
    if (memory_.u8(status) != 0) return;
    memory_.set<std::uint8_t>(status, 1);
  }
  if (on_sync) on_sync(signal, time);
}

void DcUnit::acknowledge_sync(SyncGenerator::Signal signal) {
  memory_.set<std::uint8_t>(signal == SyncGenerator::Signal::kSync0 ? reg::kSync0Status : reg::kSync1Status, 0);
}

bool DcUnit::latch_input(unsigned number, bool level, Nanoseconds time) {
  return config_.system_time && latches_.input(number, level, masked(clock_.sample(time) + offset()));
}

void DcUnit::start_of_frame(Nanoseconds time) { local_at_start_of_frame_ = clock_.sample(time); }

void DcUnit::refresh_registers() {
  if (!config_.system_time) return;
  // An ECAT read shows the time at which the frame passed the *reference* clock: the delay is subtracted.
  const auto time = masked(local_at_start_of_frame_ + offset() - memory_.u32(reg::kSystemTimeDelay));
  memory_.set<std::uint64_t>(reg::kSystemTime, time);
  memory_.set<std::uint32_t>(reg::kSystemTimeDifference, shown_difference());
  memory_.set<std::uint16_t>(reg::kSpeedCounterDiff, static_cast<std::uint16_t>(loop_.speed_counter_diff()));
  if (unminded_) pass_unminded();
  if (generator_.active()) {
    memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, masked(generator_.next_sync0().value_or(start_time_)));
    if (generator_.latest_sync1() != 0)
      memory_.set<std::uint64_t>(reg::kNextSync1Pulse, masked(generator_.latest_sync1()));
  }
  write_status();
}

void DcUnit::write_status() {
  const unsigned pending =
      (generator_.sync0_pending() ? 1U : 0U) | (generator_.sync1_pending() ? 2U : 0U) | (start_implausible_ ? 4U : 0U);
  memory_.set<std::uint8_t>(reg::kActivationStatus, static_cast<std::uint8_t>(pending));
}

void DcUnit::compare(std::uint32_t received, Nanoseconds frame_end) {
  const auto local =
      static_cast<std::uint32_t>(local_at_start_of_frame_ + offset()) - memory_.u32(reg::kSystemTimeDelay);
  if (loop_.observe(static_cast<std::int32_t>(local - received)))
    clock_.set_correction_rate(correction_rate(loop_), frame_end);
}

void DcUnit::write_activation(Nanoseconds time) {
  const auto activation = memory_.u8(reg::kActivation);
  if ((activation & kUnitOn) == 0) {
    generator_.deactivate();
    settings_ = {};
    start_missed_ = start_implausible_ = false;
    memory_.set<std::uint16_t>(reg::kSync0Status, 0);
    return;
  }
  if (generator_.active()) return;
  settings_ = {(activation & kSync0On) != 0, (activation & kSync1On) != 0, memory_.u32(reg::kSync0CycleTime),
               memory_.u32(reg::kSync1CycleTime)};
  auto first = first_sync0(unwrapped_time(time));
  if (!settings_.sync0) first.reset();
  auto generated = settings_;
  if (generated.cycle0 < kShortestCycle) generated.cycle0 = 0;
  generator_.activate(generated, first);
}

std::optional<std::uint64_t> DcUnit::first_sync0(std::uint64_t now) {
  const auto activation = memory_.u8(reg::kActivation);
  start_time_ = memory_.u64(reg::kStartTimeCyclicOperation);
  const std::uint64_t half = wide_ ? std::uint64_t{1} << 63 : std::uint64_t{1} << 31;
  const std::uint64_t near_future = (activation & kNearFuture2s) != 0 ? std::uint64_t{1} << 31 : half;
  const auto ahead = masked(start_time_ - now);
  start_implausible_ = ahead == 0 || ahead > near_future;
  if (start_implausible_ && (activation & kCheckStartTime) != 0) return now;
  // A start time that has passed fires only when the counter comes round again: never, for 64 bit.
  start_missed_ = ahead == 0 || ahead >= half;
  if (!wide_) return now + (ahead == 0 ? std::uint64_t{1} << 32 : ahead);
  return start_missed_ ? std::nullopt : std::optional(start_time_);
}

void DcUnit::extend_start_time(std::uint64_t now) {
  const auto ahead = memory_.u32(reg::kStartTimeCyclicOperation) - static_cast<std::uint32_t>(now);
  memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, now + ahead);
}

void DcUnit::start_time_written(std::uint16_t address, std::size_t length, Nanoseconds time) {
  const auto activation = memory_.u8(reg::kActivation);
  if (generator_.active()) return;
  if (start_shift_ != 0) {
    const auto start = memory_.u64(reg::kStartTimeCyclicOperation) + static_cast<std::uint64_t>(start_shift_);
    memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, masked(start));
  }
  const bool upper = overlaps(address, length, reg::kStartTimeCyclicOperation + 4, 4);
  if (wide_ && !upper && (activation & kExtendStartTime) != 0) extend_start_time(unwrapped_time(time));
  if ((activation & kAutoActivation) == 0) return;
  memory_.set<std::uint8_t>(reg::kActivation, static_cast<std::uint8_t>(activation | kUnitOn));
  write_activation(time);
}

void DcUnit::follow_ownership() {
  const auto rights = [this](unsigned bit) {
    const bool pdi = (memory_.u8(reg::kCyclicUnitControl) >> bit & 1U) != 0;
    return pdi ? EscMemory::kRead : EscMemory::kReadWrite;
  };
  memory_.implement(reg::kActivation, 1, rights(0));
  memory_.implement(reg::kStartTimeCyclicOperation, wide_ ? 8 : 4, rights(0));
  memory_.implement(reg::kSync0CycleTime, 8, rights(0));
  for (std::uint16_t number = 0; number < LatchUnit::kInputs; ++number) {
    memory_.implement(static_cast<std::uint16_t>(reg::kLatch0Control + number), 1, rights(4U + number));
  }
}

void DcUnit::registers_written(std::uint16_t address, std::size_t length, Nanoseconds frame_end) {
  if (!config_.system_time) return;
  if (overlaps(address, length, reg::kSystemTime, 4)) compare(memory_.u32(reg::kSystemTime), frame_end);
  if (address >= reg::kSystemTime && address + length <= reg::kSystemTime + 8U) {  // in every cycle
    next_signal_.reset();
    return;
  }
  if (kept_ && overlaps(address, length, reg::kSystemTimeOffset, 12)) keep_clock();
  signals_moved();
  if (overlaps(address, length, reg::kSystemTimeOffset, 8)) generator_.realign(unwrapped_time(frame_end), wide_);
  if (overlaps(address, length, reg::kSpeedCounterStart, 2)) {
    loop_.set_speed_counter_start(memory_.u16(reg::kSpeedCounterStart));
    clock_.set_correction(loop_.correction(), frame_end);
  }
  if (overlaps(address, length, reg::kFilterDepthDifference, 1)) {
    loop_.set_filter_depth_difference(memory_.u8(reg::kFilterDepthDifference));
  }
  if (overlaps(address, length, reg::kFilterDepthSpeedCounter, 1)) {
    loop_.set_filter_depth_speed_counter(memory_.u8(reg::kFilterDepthSpeedCounter));
    clock_.set_correction(loop_.correction(), frame_end);
  }
  if (overlaps(address, length, reg::kStartTimeCyclicOperation, 24)) restore_locked_registers();
  if (overlaps(address, length, reg::kStartTimeCyclicOperation, 4)) start_time_written(address, length, frame_end);
  if (overlaps(address, length, reg::kActivation, 1)) write_activation(frame_end);
  if (overlaps(address, length, reg::kCyclicUnitControl, 1)) follow_ownership();
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
    if (!passed[port] || stuck_ports_[port]) continue;
    const double noise = config_.latch_noise_ns > 0 ? config_.latch_noise_ns * latch_noise_.uniform() : 0;
    memory_.set<std::uint32_t>(
        static_cast<std::uint16_t>(reg::kReceiveTimePort0 + 4 * port),
        static_cast<std::uint32_t>(clock_.sample(*passed[port] + static_cast<Nanoseconds>(noise))));
  }
}

void DcUnit::step_clock(Nanoseconds delta, Nanoseconds time) {
  deliver_until(time);
  clock_.step(delta);
  signals_moved();
  generator_.realign(unwrapped_time(time), wide_);
}

void DcUnit::step_offset(Nanoseconds delta, Nanoseconds time) {
  if (!config_.system_time) return;
  deliver_until(time);
  memory_.set<std::uint64_t>(reg::kSystemTimeOffset, masked(offset() + static_cast<std::uint64_t>(delta)));
  signals_moved();
  generator_.realign(unwrapped_time(time), wide_);
}

void DcUnit::ignore_clock_writes(bool ignore) {
  kept_.reset();
  if (ignore) kept_ = {memory_.u64(reg::kSystemTimeOffset), memory_.u32(reg::kSystemTimeDelay)};
}

void DcUnit::keep_clock() {
  memory_.set<std::uint64_t>(reg::kSystemTimeOffset, kept_->offset);
  memory_.set<std::uint32_t>(reg::kSystemTimeDelay, kept_->delay);
}

void DcUnit::leave_sync_running(std::uint32_t cycle, Nanoseconds time) {
  if (!config_.system_time || generator_.active()) return;
  deliver_until(time);
  memory_.set<std::uint32_t>(reg::kSync0CycleTime, cycle);
  memory_.set<std::uint32_t>(reg::kSync1CycleTime, 0);
  memory_.set<std::uint64_t>(reg::kStartTimeCyclicOperation, masked(unwrapped_time(time) + cycle));
  memory_.set<std::uint8_t>(reg::kActivation, kUnitOn | kSync0On);
  signals_moved();
  write_activation(time);
}

}  // namespace syncline::sim
