// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline::sim {

/// Power drive state machine of CiA 402 (IEC 61800-7-201): controlword in, state bits of the statusword out.
class PowerState {
 public:
  enum class State : std::uint8_t { kSwitchOnDisabled, kReadyToSwitchOn, kSwitchedOn, kOperationEnabled, kFault };

  void control(std::uint16_t controlword);
  void fault() { state_ = State::kFault; }
  /// Communication has ended: the power stage goes off, a fault stays.
  void disable();
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool enabled() const { return state_ == State::kOperationEnabled; }
  [[nodiscard]] std::uint16_t statusword() const;
  /// A rising edge of the fault reset has just been taken.
  [[nodiscard]] bool take_reset();

 private:
  State state_ = State::kSwitchOnDisabled;
  std::uint16_t last_ = 0;
  bool reset_ = false;
};

}  // namespace syncline::sim
