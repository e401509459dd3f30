// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim/devices/drive.h"
#include "sim/segment/pin_trace.h"

namespace syncline::sim {

/// Drive whose servo loop runs at 250 us and follows SYNC0 by a PLL: periods that are multiples of 62.5 us are
/// legal, but only multiples of 250 us synchronise the servo loop. Object 0x21B4 says which (bit 0 period legal,
/// 1 servo period synchronised, 2 multiple of 250 us, 3 start time before system time). Objects 0x1C32:01 and 0x1C33:01
/// choose per direction between free run (0) and SYNC0 (2, default). Output pins show SYNC0, the start of the servo
/// period or received frames (0x2193).
class DriveC final : public Drive {
 public:
  DriveC(const SimSlaveConfig& config, Esc& esc);
  [[nodiscard]] const PinTrace* output_pin(unsigned number) const override;
  void frame_received(Nanoseconds begin, Nanoseconds end) override;

 protected:
  void on_sync0(Nanoseconds time) override;
  void servo_tick(Nanoseconds time) override;

 private:
  enum Function : std::uint16_t { kSync0 = 11, kFrame = 12, kServoPeriod = 0x200 };
  struct Pin {
    std::uint16_t function = 0;  // nothing
    PinTrace trace;
  };
  void add_pins();
  std::uint32_t configure(std::size_t pin, std::uint16_t function);
  void pulse(Function function, Nanoseconds begin, Nanoseconds end);
  [[nodiscard]] std::uint16_t synchronisation_status();

  std::vector<Pin> pins_;
};

}  // namespace syncline::sim
