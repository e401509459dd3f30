// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "families/device_family.h"
#include "families/family_tables.h"

namespace syncline::families {
namespace {

// The simulated devices (resources/esi) have the habits of a family each, and some of their own where it is silent.
constexpr std::uint32_t kSimulatedVendor = 0x5C17;
constexpr std::string_view kOwn = "docs/scenarios.md";

constexpr std::array kDriveAlarms{Alarm{0x8700, {}, "Sync controller"}};

Family simulated(const Family& like, std::string_view id, std::string_view name, std::uint32_t product) {
  Family family = like;
  family.id = id;
  family.name = name;
  family.match = {kSimulatedVendor, product, product, {}};
  return family;
}

Family servo() {
  Family family = simulated(yaskawa_families()[0], "sl-sv7", "SL-SV7", 0x7001);
  family.times = LocalTimes{62'500, 10'000, kOwn};
  return family;
}

Family drive() {
  Family family = simulated(copley_families()[0], "sl-xe2", "SL-XE2", 0x7002);
  // CiA 402 has the number; the real drive's is not known.
  family.error_limit->error_code = 0x8700;
  family.alarms = {kDriveAlarms, "CiA 402, error codes"};
  family.times = LocalTimes{30'000, 5'000, kOwn};
  return family;
}

Family gateway() {
  Family family = simulated(beckhoff_families()[0], "sl-6751", "SL-6751", 0x6751);
  family.cycle = CycleLimits{1, 1, {}, 100 * kMicrosecond, 0, kOwn};
  family.times = LocalTimes{40'000, 20'000, kOwn};
  return family;
}

Family analog_input() {
  Family family;
  family.id = "sl-3002";
  family.name = "SL-3002";
  family.devices = "terminals";
  family.match = {kSimulatedVendor, 0x3002, 0x3002, {}};
  family.behaviour = "analog-input";
  return family;
}

}  // namespace

std::span<const Family> simulated_families() {
  static const std::array families{servo(), drive(), gateway(), analog_input()};
  return families;
}

}  // namespace syncline::families
