// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/power_state.h"

#include <utility>

namespace syncline::sim {
namespace {

constexpr std::uint16_t kSwitchOn = 0x01, kEnableVoltage = 0x02, kNoQuickStop = 0x04, kEnableOperation = 0x08,
                        kFaultReset = 0x80;
constexpr std::uint16_t kVoltage = kEnableVoltage | kNoQuickStop;

}  // namespace

void PowerState::control(std::uint16_t controlword) {
  const bool reset = (controlword & ~last_ & kFaultReset) != 0;
  last_ = controlword;
  if (state_ == State::kFault) {
    reset_ = reset;
    if (reset) state_ = State::kSwitchOnDisabled;
    return;
  }
  if ((controlword & kVoltage) != kVoltage) {
    state_ = State::kSwitchOnDisabled;
    return;
  }
  const bool on = (controlword & kSwitchOn) != 0;
  const bool run = on && (controlword & kEnableOperation) != 0;
  if (!on) {
    state_ = State::kReadyToSwitchOn;
  } else if (state_ != State::kSwitchOnDisabled) {  // that one is left by "shutdown" only
    state_ = run ? State::kOperationEnabled : State::kSwitchedOn;
  }
}

void PowerState::disable() {
  if (state_ != State::kFault) state_ = State::kSwitchOnDisabled;
}

bool PowerState::take_reset() { return std::exchange(reset_, false); }

std::uint16_t PowerState::statusword() const {
  switch (state_) {
    case State::kSwitchOnDisabled:
      return 0x0250;
    case State::kReadyToSwitchOn:
      return 0x0231;
    case State::kSwitchedOn:
      return 0x0233;
    case State::kOperationEnabled:
      return 0x0237;
    case State::kFault:
      return 0x0218;
  }
  return 0;
}

}  // namespace syncline::sim
