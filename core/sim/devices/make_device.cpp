// SPDX-License-Identifier: Apache-2.0
#include "families/families.h"
#include "sim/device/device.h"
#include "sim/device/own_loop.h"
#include "sim/devices/analog_input.h"
#include "sim/devices/can_gateway.h"
#include "sim/devices/drive.h"
#include "sim/devices/drive_c.h"
#include "sim/devices/sync_bridge.h"

namespace syncline::sim {
namespace {

/// Holds what it is given (terminals, couplers, any other device); its inputs are what its objects say.
class Generic final : public Device {
 public:
  Generic(const SimSlaveConfig& config, Esc& esc) : Device(config, esc), loop_(esc) {}

 protected:
  void on_sync0(Nanoseconds time) override { cycle(time); }
  void on_outputs(Nanoseconds time) override {
    loop_.outputs_came(output_manager(), application_delay());
    if (!dc().sync0_enabled()) cycle(time);
  }
  void check_running(Nanoseconds time) override {
    if (loop_.ended(time)) renew_inputs();
  }
  Nanoseconds runs_alone_until() override { return loop_.end(); }
  bool rests() override { return inputs_stay() && application_delay() == 0 && !loop_.under_way(); }

 private:
  void cycle(Nanoseconds time) {
    check_running(time);
    if (loop_.begin(output_manager(), time, application_delay()) && !loop_.under_way()) renew_inputs();
  }

  OwnLoop loop_;
};

/// Of the device's own family, where that is one of these servos; what is not known of it is the simulated servo's.
DriveHabits servo_habits(const DeviceDescription& device) {
  constexpr std::uint16_t kSupported =
      SyncHabits::kFreeRun | SyncHabits::kSync0 | SyncHabits::kLocalShift | SyncHabits::kMeasures;
  constexpr std::string_view kBehaviour = "servo-y";
  const families::Family& usual = *families::of_behaviour(kBehaviour);
  const families::Family* own = families::find(device);
  families::Family family = own != nullptr && own->behaviour == kBehaviour ? *own : usual;
  if (!family.times) family.times = usual.times;
  // Of a family whose places the sources disagree about: those of ETG.1020.
  if (!family.counters) family.counters = families::SyncCounters{};
  return {family, kSupported};
}

}  // namespace

std::unique_ptr<Device> make_device(const SimSlaveConfig& config, Esc& esc) {
  if (config.behaviour == "servo-y") return std::make_unique<Drive>(config, esc, servo_habits(config.device));
  if (config.behaviour == "drive-c") return std::make_unique<DriveC>(config, esc);
  if (config.behaviour == "can-gateway") return std::make_unique<CanGateway>(config, esc);
  if (config.behaviour == "analog-input") return std::make_unique<AnalogInput>(config, esc);
  if (config.behaviour == "sync-bridge") return std::make_unique<SyncBridge>(config, esc);
  return std::make_unique<Generic>(config, esc);
}

}  // namespace syncline::sim
