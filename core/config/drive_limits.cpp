// SPDX-License-Identifier: Apache-2.0
#include "config/drive_limits.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "support/byte_order.h"

namespace syncline {
namespace {

/// A family of drives by the vendor and the beginning of the type's name.
struct Family {
  std::uint32_t vendor_id;
  std::string_view type;
  std::string_view name;
  unsigned objects_per_direction;   // 0: no limit known
  Nanoseconds cycle_step, longest_cycle;
};

constexpr std::array kFamilies{
    Family{0x0000'0539, "SGD", "Yaskawa Sigma", 16, 125 * kMicrosecond, 4 * kMillisecond},
    Family{0x0000'00AB, "", "Copley Controls", 0, 250 * kMicrosecond, 10 * kMillisecond},
};

/// Default of an unsigned 32-bit object, 0 when the dictionary does not have it.
std::uint32_t object_default(const DeviceDescription& device, std::uint16_t index, std::uint8_t sub_index) {
  const auto object = std::ranges::find(device.dictionary, index, &ObjectDescription::index);
  if (object == device.dictionary.end()) return 0;
  const auto entry = std::ranges::find(object->entries, sub_index, &ObjectEntry::sub_index);
  if (entry == object->entries.end() || entry->default_data.size() != 4) return 0;
  return load_le<std::uint32_t>(entry->default_data);
}

}  // namespace

DeviceLimits device_limits(const DeviceDescription& device) {
  DeviceLimits limits;
  const auto family = std::ranges::find_if(kFamilies, [&](const Family& f) {
    return f.vendor_id == device.identity.vendor_id && device.type.starts_with(f.type);
  });
  if (family != kFamilies.end()) {
    limits.family = family->name;
    if (family->objects_per_direction > 0) limits.objects_per_direction = family->objects_per_direction;
    limits.cycle_step = limits.shortest_cycle = family->cycle_step;
    limits.longest_cycle = family->longest_cycle;
  }
  // Minimum cycle time of the output and input SyncManagers (ETG.1020, 0x1C32:05 and 0x1C33:05).
  for (const std::uint16_t index : {std::uint16_t{0x1C32}, std::uint16_t{0x1C33}}) {
    if (const Nanoseconds least = object_default(device, index, 5); least > 0) {
      limits.shortest_cycle = std::max(limits.shortest_cycle.value_or(0), least);
    }
  }
  return limits;
}

}  // namespace syncline
