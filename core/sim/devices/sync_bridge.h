// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device/device.h"

namespace syncline::sim {

/// Bridge to another network: shows the system time of its own segment and of the other one, both of the same moment,
/// in 0x10F4:11 and :12. Zero while nobody is connected on the other side.
class SyncBridge final : public Device {
 public:
  using Device::Device;

 protected:
  void check_running(Nanoseconds time) override;
};

}  // namespace syncline::sim
