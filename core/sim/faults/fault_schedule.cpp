// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/fault_schedule.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "protocol/al_state.h"
#include "protocol/registers.h"
#include "sim/device/device.h"
#include "sim/faults/line_faults.h"

namespace syncline::sim {
namespace {

/// In the mean, between foreign frames by chance.
constexpr Nanoseconds kShortestGap = 200 * kMicrosecond;

}  // namespace

FaultSchedule::FaultSchedule(const SimConfig& config, Nanoseconds start, FaultTarget& target)
    : target_(target), start_(start), seed_(config.seed ^ 0x6661'756C'7473U) {
  for (const auto& fault : config.faults) {
    ++faults_;
    if (fault.kind == FaultKind::kIgnoredClockWrites && fault.slave < 0) {
      for (std::size_t i = 0; i < config.slaves.size(); ++i) {
        if (config.slaves[i].dc.system_time) add_clock_fault(fault, i);
      }
    } else if (fault.kind == FaultKind::kReversedCable || fault.kind == FaultKind::kClosedRing) {
      add_wiring_fault(fault, config.slaves[static_cast<std::size_t>(fault.slave)].entry_port);
    } else {
      add_fault(fault);
    }
  }
  for (const auto& pulses : config.latch_pulses) add_pulses(pulses);
  if (config.bus.foreign_per_second > 0) add_foreign_frames(config.bus.foreign_per_second);
  std::ranges::stable_sort(actions_, {}, &Action::time);
}

/// Nobody has sent or asked for so long: of what repeats itself, only the last is still worth doing.
void FaultSchedule::skip_long_ago(Nanoseconds time) {
  constexpr Nanoseconds kMostAtOnce = 100'000;
  for (auto& one : repeated_) {
    const auto period = one.period > 0 ? one.period : kShortestGap;
    if (one.next >= time || (time - one.next) / period <= kMostAtOnce) continue;
    one.next += ((time - one.next) / period - kMostAtOnce) * period;
    if (one.next >= one.end) one.next = INT64_MAX;
  }
}

void FaultSchedule::run_due(Nanoseconds time) {
  skip_long_ago(time);
  for (;;) {
    const auto repeated = std::ranges::min_element(repeated_, {}, &Repeated::next);
    const auto of_repeated = repeated == repeated_.end() ? INT64_MAX : repeated->next;
    const auto of_action = next_ < actions_.size() ? actions_[next_].time : INT64_MAX;
    due_ = std::min(of_repeated, of_action);
    if (due_ > time || due_ == INT64_MAX) return;
    if (of_action <= of_repeated) {
      actions_[next_++].act();
    } else {
      const auto now = repeated->next;
      repeated->next += repeated->period;
      if (repeated->next >= repeated->end) repeated->next = INT64_MAX;
      repeated->act(now);
    }
  }
}

void FaultSchedule::started_anew(std::size_t slave) {
  for (const auto& lasting : lasting_) {
    if (lasting.slave == slave) lasting.act();
  }
}

void FaultSchedule::add(const FaultConfig& fault, Act apply, Act undo) {
  actions_.push_back({start_ + fault.at, std::move(apply)});
  if (undo && fault.until > fault.at) actions_.push_back({start_ + fault.until, std::move(undo)});
}

void FaultSchedule::add_lasting(const FaultConfig& fault, std::size_t slave, const Act& apply, const Act& undo) {
  const auto number = faults_;
  add(
      fault,
      [this, number, slave, apply] {
        lasting_.push_back({number, slave, apply});
        apply();
      },
      [this, number, slave, undo] {
        std::erase_if(lasting_, [&](const Lasting& one) { return one.fault == number && one.slave == slave; });
        undo();
      });
}

void FaultSchedule::add_repeated(const FaultConfig& fault, std::uint32_t count, std::function<void(Nanoseconds)> act) {
  const auto begin = start_ + fault.at;
  const auto end = fault.until > 0 ? start_ + fault.until : count > 0 ? begin + count * fault.period : INT64_MAX;
  repeated_.push_back({begin, fault.period, end, std::move(act)});
}

void FaultSchedule::add_fault(const FaultConfig& fault) {
  const auto slave = static_cast<std::size_t>(std::max(fault.slave, 0));
  const auto begin = start_ + fault.at, end = start_ + fault.until;
  auto& target = target_;
  switch (fault.kind) {
    case FaultKind::kLoseFrames:
    case FaultKind::kBitErrors:
      return add_line_fault(fault);
    case FaultKind::kCableBreak:
      return add(
          fault, [&target, slave] { target.set_cable(slave, false); },
          [&target, slave] { target.set_cable(slave, true); });
    case FaultKind::kReversedCable:
    case FaultKind::kClosedRing:
      return;  // see the constructor
    case FaultKind::kForeignFrames:
      return add_repeated(fault, fault.until > 0 ? 0 : fault.count,
                          [&target](Nanoseconds time) { target.foreign_frame(time); });
    case FaultKind::kSlaveOff:
      return add(
          fault, [&target, slave, begin] { target.set_power(slave, false, begin); },
          [&target, slave, end] { target.set_power(slave, true, end); });
    case FaultKind::kHoldFrames:  // not the segment's: link/adapter_faults
    case FaultKind::kHoldAnswers:
    case FaultKind::kAdapterOff:
    case FaultKind::kCalendarStep:  // nor these: link/simulated_host
    case FaultKind::kHostStall:
    case FaultKind::kClockSlew:  // sim/dc/rate_changes
    case FaultKind::kTemperatureRamp:
      return;
    case FaultKind::kClockStep:
    case FaultKind::kIgnoredClockWrites:
    case FaultKind::kOffsetStep:
    case FaultKind::kStuckPortTime:
    case FaultKind::kWrongStartTime:
    case FaultKind::kSyncLeftRunning:
    case FaultKind::kSilentSync:
      return add_clock_fault(fault, slave);
    case FaultKind::kNoisyDelay:
      return add_noisy_delay(fault);
    case FaultKind::kRefuseState:
    case FaultKind::kMailboxSilence:
    case FaultKind::kSlowMailbox:
    case FaultKind::kSlowApplication:
    case FaultKind::kStopApplication:
      return add_firmware_fault(fault);
  }
}

void FaultSchedule::add_line_fault(const FaultConfig& fault) {
  auto& target = target_;
  const bool by_chance = fault.probability > 0;
  if (fault.slave < 0 && !by_chance)
    return add(fault, [&target, count = fault.count] { target.lines().lose_frames(count); });
  const bool burst = by_chance || fault.until > fault.at;
  const LineFaults::Fault line{fault.slave < 0 ? LineFaults::kAnywhere : fault.slave, fault.port,
                               fault.kind == FaultKind::kBitErrors, burst ? LineFaults::kUntilRemoved : fault.count,
                               by_chance ? fault.probability : 1};
  add(
      fault, [&target, line] { target.lines().add(line); }, [&target, line] { target.lines().remove(line); });
}

void FaultSchedule::add_wiring_fault(const FaultConfig& fault, std::uint8_t entry_port) {
  auto& target = target_;
  const auto slave = static_cast<std::size_t>(fault.slave);
  if (fault.kind == FaultKind::kClosedRing) {
    const Wiring::Ring ring{static_cast<std::uint16_t>(slave), fault.port, static_cast<double>(fault.value_ns)};
    return add(
        fault, [&target, ring] { target.close_ring(ring); }, [&target] { target.close_ring(std::nullopt); });
  }
  add(
      fault, [&target, slave, port = fault.port] { target.reverse_cable(slave, port); },
      [&target, slave, entry_port] { target.reverse_cable(slave, entry_port); });
}

void FaultSchedule::add_clock_fault(const FaultConfig& fault, std::size_t slave) {
  auto& target = target_;
  const auto now = start_ + fault.at;
  const auto lasting = [&](auto set) {
    add_lasting(
        fault, slave, [&target, slave, set] { set(target.esc(slave), true); },
        [&target, slave, set] { set(target.esc(slave), false); });
  };
  switch (fault.kind) {
    case FaultKind::kClockStep:
      return add(fault,
                 [&target, slave, delta = fault.value_ns, now] { target.esc(slave).dc().step_clock(delta, now); });
    case FaultKind::kOffsetStep:
      return add(fault,
                 [&target, slave, delta = fault.value_ns, now] { target.esc(slave).dc().step_offset(delta, now); });
    case FaultKind::kSyncLeftRunning:
      return add(fault, [&target, slave, cycle = static_cast<std::uint32_t>(fault.value_ns), now] {
        target.esc(slave).dc().leave_sync_running(cycle, now);
      });
    case FaultKind::kIgnoredClockWrites:
      return lasting([](Esc& esc, bool on) { esc.dc().ignore_clock_writes(on); });
    case FaultKind::kStuckPortTime:
      return lasting([port = fault.port](Esc& esc, bool on) { esc.dc().stick_port_time(port, on); });
    case FaultKind::kWrongStartTime:
      return lasting([by = fault.value_ns](Esc& esc, bool on) { esc.dc().shift_start_times(on ? by : 0); });
    case FaultKind::kSilentSync:
      return lasting([](Esc& esc, bool on) { esc.silence_sync(on); });
    default:
      return;
  }
}

void FaultSchedule::add_firmware_fault(const FaultConfig& fault) {
  auto& target = target_;
  const auto slave = static_cast<std::size_t>(fault.slave);
  const auto begin = start_ + fault.at, end = start_ + fault.until;
  const auto lasting = [&](auto apply, auto undo) {
    add_lasting(
        fault, slave, [&target, slave, apply] { apply(target.device(slave)); },
        [&target, slave, undo] { undo(target.device(slave)); });
  };
  switch (fault.kind) {
    case FaultKind::kRefuseState:
      return lasting([state = fault.state, code = fault.code](Device& device) { device.refuse(state, code); },
                     [](Device& device) { device.refuse(AlState::kNone, 0); });
    case FaultKind::kSlowMailbox:
      return lasting([delay = fault.value_ns](Device& device) { device.slow_mailbox(delay); },
                     [](Device& device) { device.slow_mailbox(0); });
    case FaultKind::kSlowApplication:
      return lasting([delay = fault.value_ns](Device& device) { device.slow_application(delay); },
                     [](Device& device) { device.slow_application(0); });
    case FaultKind::kMailboxSilence:
      return lasting([](Device& device) { device.silence_mailbox(true); },
                     [](Device& device) { device.silence_mailbox(false); });
    case FaultKind::kStopApplication:  // which a power cycle mends
      return add(
          fault, [&target, slave, begin] { target.device(slave).stop_application(begin); },
          [&target, slave, end] { target.device(slave).resume_application(end); });
    default:
      return;
  }
}

/// Each time somewhere else about what was there at first.
void FaultSchedule::add_noisy_delay(const FaultConfig& fault) {
  auto& target = target_;
  const auto slave = static_cast<std::size_t>(fault.slave);
  struct Noise {
    Random random;
    std::optional<std::uint32_t> right{};
  };
  auto noise = std::make_shared<Noise>(Noise{Random(seed_ + faults_)});
  add_repeated(fault, 0, [&target, slave, noise, most = static_cast<double>(fault.value_ns)](Nanoseconds) {
    auto& memory = target.esc(slave).memory();
    if (!noise->right) noise->right = memory.u32(reg::kSystemTimeDelay);
    const auto wrong = std::llround(noise->random.uniform(-most, most));
    memory.set<std::uint32_t>(reg::kSystemTimeDelay, *noise->right + static_cast<std::uint32_t>(wrong));
  });
}

/// By chance: the time to the next one has no memory.
void FaultSchedule::add_foreign_frames(double per_second) {
  auto random = std::make_shared<Random>(seed_ ^ 0x666F'7265'6967'6EU);
  const auto gap = [random, per_second] {
    constexpr double kNever = 1e18;  // ns: 31 years
    return std::max<Nanoseconds>(1,
                                 std::llround(std::min(-std::log(1 - random->uniform()) / per_second * 1e9, kNever)));
  };
  const auto place = repeated_.size();
  repeated_.push_back({start_ + gap(), 0, INT64_MAX, [this, place, gap](Nanoseconds time) {
                         repeated_[place].next = time + gap();
                         target_.foreign_frame(time);
                       }});
}

void FaultSchedule::add_pulses(const LatchPulses& pulses) {
  const auto edge = [&](bool level, Nanoseconds time) {
    actions_.push_back({time, [&target = target_, level, time, slave = pulses.slave, input = pulses.input] {
                          target.device(slave).advance_to(time);
                          (void)target.esc(slave).latch_input(input, level, time);
                        }});
  };
  for (std::uint32_t i = 0; i < pulses.count; ++i) {
    const auto rise = start_ + pulses.at + i * pulses.period;
    edge(true, rise);
    edge(false, rise + pulses.width);
  }
}

}  // namespace syncline::sim
