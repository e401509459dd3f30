// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/devices/drive.h"

namespace syncline::sim {

/// Drive whose servo loop runs at 250 us: SYNC0 periods that are multiples of 62.5 us are legal, but only
/// multiples of 250 us synchronise the servo loop. Object 0x21B4 says which (bit 0 period legal, 1 servo
/// period synchronised, 2 multiple of 250 us, 3 start time before system time).
class DriveC final : public Drive {
 public:
  DriveC(const SimSlaveConfig& config, Esc& esc);

 protected:
  void on_state(AlState state) override;

 private:
  [[nodiscard]] std::uint16_t synchronisation_status();
};

}  // namespace syncline::sim
