// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sm2_counter_profile.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "config/identity.h"
#include "families/device_family.h"
#include "families/families.h"

namespace syncline {
namespace {

bool speaks_of_misses(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("miss") != std::string::npos;
}

}  // namespace

std::optional<std::uint8_t> known_sm2_missed_sub_index(const Identity& identity) {
  const auto counters = families::sync_counters(identity);
  return counters ? std::optional(counters->missed) : std::nullopt;
}

std::uint8_t sm2_missed_sub_index(const Identity& identity) {
  return known_sm2_missed_sub_index(identity).value_or(kSm2MissedSubIndex);
}

std::uint8_t sm2_missed_sub_index(std::string_view name_of_0b, std::string_view name_of_0c) {
  if (speaks_of_misses(name_of_0b)) return kSm2MissedSubIndex;
  return speaks_of_misses(name_of_0c) ? kSm2MissedSubIndexOldLayout : std::uint8_t{0};
}

}  // namespace syncline
