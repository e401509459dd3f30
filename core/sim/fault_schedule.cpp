// SPDX-License-Identifier: Apache-2.0
#include "sim/fault_schedule.h"

#include <algorithm>

namespace syncline::sim {

FaultSchedule::FaultSchedule(const SimConfig& config, Nanoseconds start, FaultTarget& target)
    : target_(target), start_(start) {
  for (const auto& fault : config.faults) add_fault(fault);
  for (const auto& pulses : config.latch_pulses) add_pulses(pulses);
  std::ranges::stable_sort(actions_, {}, &Action::time);
}

void FaultSchedule::add(const FaultConfig& fault, std::function<void()> apply, std::function<void()> undo) {
  actions_.push_back({start_ + fault.at, std::move(apply)});
  if (undo && fault.until > fault.at) actions_.push_back({start_ + fault.until, std::move(undo)});
}

void FaultSchedule::add_fault(const FaultConfig& fault) {
  const auto slave = static_cast<std::size_t>(std::max(fault.slave, 0));
  const auto begin = start_ + fault.at, end = start_ + fault.until;
  auto& target = target_;
  const auto add_to_device = [&](auto apply, auto undo) {
    add(fault, [&target, slave, apply] { apply(target.device(slave)); }, [&target, slave, undo] { undo(target.device(slave)); });
  };
  switch (fault.kind) {
    case FaultKind::kLoseFrames:
      if (fault.slave < 0) return add(fault, [&target, count = fault.count] { target.lines().lose_frames(count); });
      return add_line_fault(fault);
    case FaultKind::kBitErrors: return add_line_fault(fault);
    case FaultKind::kCableBreak:
      return add(fault, [&target, slave] { target.set_cable(slave, false); }, [&target, slave] { target.set_cable(slave, true); });
    case FaultKind::kSlaveOff:
      return add(fault, [&target, slave, begin] { target.set_power(slave, false, begin); },
                 [&target, slave, end] { target.set_power(slave, true, end); });
    case FaultKind::kClockStep:
      return add(fault, [&target, slave, delta = fault.value_ns] { target.esc(slave).dc().step_clock(delta); });
    case FaultKind::kRefuseState:
      return add_to_device([state = fault.state, code = fault.code](Device& device) { device.refuse(state, code); },
                           [](Device& device) { device.refuse(AlState::kNone, 0); });
    case FaultKind::kSlowMailbox:
      return add_to_device([delay = fault.value_ns](Device& device) { device.slow_mailbox(delay); },
                           [](Device& device) { device.slow_mailbox(0); });
    case FaultKind::kSlowApplication:
      return add_to_device([delay = fault.value_ns](Device& device) { device.slow_application(delay); },
                           [](Device& device) { device.slow_application(0); });
    case FaultKind::kStopApplication:
      return add_to_device([begin](Device& device) { device.stop_application(begin); },
                           [end](Device& device) { device.resume_application(end); });
    case FaultKind::kHostStall: return;  // not the segment's: link/simulated_host
    case FaultKind::kMailboxSilence:
      return add_to_device([](Device& device) { device.silence_mailbox(true); },
                           [](Device& device) { device.silence_mailbox(false); });
  }
}

void FaultSchedule::add_line_fault(const FaultConfig& fault) {
  const bool burst = fault.until > fault.at;
  const LineFaults::Fault line{static_cast<std::uint16_t>(fault.slave), fault.port, fault.kind == FaultKind::kBitErrors,
                               burst ? LineFaults::kUntilRemoved : fault.count};
  auto& target = target_;
  add(fault, [&target, line] { target.lines().add(line); },
      [&target, line] { target.lines().remove(line.slave, line.port, line.damaged); });
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
