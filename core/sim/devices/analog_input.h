// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device/device.h"

namespace syncline::sim {

/// Analogue input terminal: every 16-bit input is a triangle over the whole range, 1 s long, of which each
/// further channel shows the part an eighth of a second later.
class AnalogInput final : public Device {
 public:
  using Device::Device;

 protected:
  void check_running(Nanoseconds time) override;

 private:
  std::optional<Nanoseconds> converted_;
};

}  // namespace syncline::sim
