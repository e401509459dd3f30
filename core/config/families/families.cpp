// SPDX-License-Identifier: Apache-2.0
#include "config/families/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "config/families/family_tables.h"

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

}  // namespace

std::span<const Family* const> all() {
  static const std::vector<const Family*> families = [] {
    std::vector<const Family*> list;
    for (const auto table : {yaskawa_families(), copley_families(), beckhoff_families(), simulated_families()}) {
      for (const Family& family : table) list.push_back(&family);
    }
    return list;
  }();
  return families;
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
  return first_that([&](const Family& family) { return family.behaviour == behaviour; });
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

std::string alarm_text(const Identity& identity, std::uint16_t error_code) {
  const Alarm* alarm = find_alarm(identity, error_code);
  if (alarm == nullptr) return fmt::format("0x{:04X}", error_code);
  if (alarm->name.empty()) return fmt::format("0x{:04X} {}", error_code, alarm->text);
  return fmt::format("{} (0x{:04X}) {}", alarm->name, error_code, alarm->text);
}

}  // namespace syncline::families
