// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/analog_input.h"

#include <cstdlib>

namespace syncline::sim {
namespace {

constexpr Nanoseconds kConversion = 100 * kMicrosecond;
constexpr Nanoseconds kPeriod = kSecond, kBetweenChannels = kSecond / 8;
constexpr Nanoseconds kLargest = 0x7FFF;
constexpr std::uint16_t kInteger16 = 0x03;

std::uint16_t triangle(Nanoseconds time) {
  const auto phase = time % kPeriod;                                // rises for the first half
  const auto height = kPeriod / 2 - std::abs(phase - kPeriod / 2);  // 0 .. half a period
  return static_cast<std::uint16_t>(2 * kLargest * height / (kPeriod / 2) - kLargest);
}

}  // namespace

void AnalogInput::check_running(Nanoseconds time) {
  if (converted_ && time - *converted_ < kConversion + application_delay()) return;
  converted_ = time;
  Nanoseconds shift = 0;
  for (const auto& pdo : config().device.tx_pdos) {
    for (const auto& entry : pdo.entries) {
      auto* object = dictionary_.find(entry.index, entry.sub_index);
      if (object == nullptr || object->type() != kInteger16) continue;
      object->value = le_bytes(triangle(time + shift));
      shift += kBetweenChannels;
    }
  }
  inputs_from_dictionary();
}

}  // namespace syncline::sim
