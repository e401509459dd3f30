// SPDX-License-Identifier: Apache-2.0
#include "families/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "config/slave_config.h"
#include "families/device_family.h"
#include "families/family_tables.h"
#include "support/byte_order.h"

namespace syncline::families {
namespace {

bool has_product(const Match& match, const Identity& identity) {
  return match.vendor_id == identity.vendor_id && identity.product_code >= match.first_product &&
         identity.product_code <= match.last_product;
}

template <class Fits>
const Family* first_that(Fits fits) {
  const auto families = all();
  const auto found = std::ranges::find_if(families, [&](const Family* family) { return fits(*family); });
  return found == families.end() ? nullptr : *found;
}

/// Default of an unsigned 32-bit object, 0 when the dictionary does not have it.
std::uint32_t object_default(const DeviceDescription& device, std::uint16_t index, std::uint8_t sub_index) {
  const auto object = std::ranges::find(device.dictionary, index, &ObjectDescription::index);
  if (object == device.dictionary.end()) return 0;
  const auto entry = std::ranges::find(object->entries, sub_index, &ObjectEntry::sub_index);
  if (entry == object->entries.end() || entry->default_data.size() != 4) return 0;
  return load_le<std::uint32_t>(entry->default_data);
}

}  // namespace

std::span<const Family* const> all() {
  // Without memory from the heap: the first caller may be the cyclic thread.
  struct List {
    std::array<const Family*, 16> families{};
    std::size_t count = 0;
  };
  static const List list = [] {
    List made;
    for (const auto table : {yaskawa_families(), copley_families(), beckhoff_families(), simulated_families()}) {
      for (const Family& family : table) made.families.at(made.count++) = &family;
    }
    return made;
  }();
  return std::span(list.families).first(list.count);
}

const Family* find(const Identity& identity) {
  return first_that([&](const Family& family) { return has_product(family.match, identity); });
}

const Family* find(const DeviceDescription& device) {
  if (const Family* family = find(device.identity)) return family;
  return first_that([&](const Family& family) {
    const Match& match = family.match;
    return match.vendor_id == device.identity.vendor_id && !match.type.empty() && device.type.starts_with(match.type);
  });
}

const Family* of_behaviour(std::string_view behaviour) {
  if (behaviour.empty()) return nullptr;
  const auto families = simulated_families();
  const auto found = std::ranges::find(families, behaviour, &Family::behaviour);
  return found == families.end() ? nullptr : &*found;
}

std::string_view behaviour_of(const DeviceDescription& device) {
  const Family* family = find(device);
  return family == nullptr || family->behaviour.empty() ? "generic" : family->behaviour;
}

std::optional<Nanoseconds> minimum_cycle(const DeviceDescription& device) {
  constexpr std::uint8_t kMinimumCycleTime = 5;  // ETG.1020
  const Nanoseconds least = std::max<Nanoseconds>(object_default(device, kOutputSync, kMinimumCycleTime),
                                                  object_default(device, kInputSync, kMinimumCycleTime));
  return least > 0 ? std::optional(least) : std::nullopt;
}

std::optional<SyncCounters> sync_counters(const Identity& identity) {
  const Family* family = find(identity);
  return family == nullptr ? std::nullopt : family->counters;
}

std::optional<std::uint32_t> error_limit(const SlaveConfig& slave) {
  std::optional<std::uint32_t> limit;
  if (const Family* family = find(slave.identity); family != nullptr && family->error_limit)
    limit = family->error_limit->usual;
  if (!slave.mailbox) return limit;
  for (const CoeInitCmd& cmd : slave.mailbox->coe_commands) {
    const StartupCommand& command = cmd.command;
    const bool writes = command.enabled && command.index == kSyncErrorLimit.index &&
                        command.sub_index == kSyncErrorLimit.sub_index && !command.complete_access;
    if (!writes || command.data.empty() || command.data.size() > 4) continue;
    std::uint32_t value = 0;
    for (std::size_t i = command.data.size(); i-- > 0;) value = value << 8 | command.data[i];
    limit = value;
  }
  return limit;
}

const Alarm* find_alarm(const Identity& identity, std::uint16_t error_code) {
  const Family* family = find(identity);
  if (family == nullptr) return nullptr;
  const auto& alarms = family->alarms.list;
  const auto found = std::ranges::find(alarms, error_code, &Alarm::error_code);
  return found == alarms.end() ? nullptr : &*found;
}

const Alarm* find_alarm(const Identity& identity, std::uint16_t error_code, const std::array<std::uint8_t, 5>& data) {
  constexpr std::uint16_t kDeviceSpecific = 0xFF00;
  // The first of the five bytes is reserved, the number follows (Yaskawa SIEP C710812 02, emergency messages).
  const auto own = static_cast<std::uint16_t>(data[1] | data[2] << 8);
  return find_alarm(identity, error_code == kDeviceSpecific ? own : error_code);
}

std::vector<StatusLine> status_lines(const StatusObject& object, std::uint32_t value) {
  std::vector<StatusLine> lines;
  for (const StatusBit& bit : object.bits) {
    const bool set = (value >> bit.bit & 1U) != 0;
    lines.push_back({bit.bit, set == bit.wanted, set ? bit.when_set : bit.when_clear});
  }
  return lines;
}

std::string alarm_text(const Identity& identity, std::uint16_t error_code) {
  const Alarm* alarm = find_alarm(identity, error_code);
  if (alarm == nullptr) return fmt::format("0x{:04X}", error_code);
  if (alarm->name.empty()) return fmt::format("0x{:04X} {}", error_code, alarm->text);
  return fmt::format("{} (0x{:04X}) {}", alarm->name, error_code, alarm->text);
}

}  // namespace syncline::families
