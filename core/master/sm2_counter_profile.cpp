// SPDX-License-Identifier: Apache-2.0
#include "master/sm2_counter_profile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>

namespace syncline {
namespace {

struct Profile {
  std::uint32_t vendor_id;
  std::optional<std::uint32_t> product_code;  // empty: all of the vendor's
  std::uint8_t missed_sub_index;
};

constexpr std::array<Profile, 4> kProfiles{{
    {0x0000'0539, std::nullopt, kSm2MissedSubIndexOldLayout},  // Yaskawa Sigma: AN.MTN.01, "SM2 event miss count" at 0x0C
    {0x0000'0002, 0x1A5F'3052, kSm2MissedSubIndexOldLayout},   // Beckhoff EL6751: 0x0B counts exceeded cycles
    {0x0000'5C17, 0x0000'7001, kSm2MissedSubIndexOldLayout},   // SL-SV7, the simulated servo of that generation
    {0x0000'5C17, 0x0000'7002, kSm2MissedSubIndex},            // SL-XE2
}};

bool speaks_of_misses(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("miss") != std::string::npos;
}

}  // namespace

std::optional<std::uint8_t> known_sm2_missed_sub_index(const Identity& identity) {
  const auto known = std::ranges::find_if(kProfiles, [&](const Profile& profile) {
    return profile.vendor_id == identity.vendor_id &&
           (!profile.product_code || *profile.product_code == identity.product_code);
  });
  return known == kProfiles.end() ? std::nullopt : std::optional(known->missed_sub_index);
}

std::uint8_t sm2_missed_sub_index(const Identity& identity) {
  return known_sm2_missed_sub_index(identity).value_or(kSm2MissedSubIndex);
}

std::uint8_t sm2_missed_sub_index(std::string_view name_of_0b, std::string_view name_of_0c) {
  if (speaks_of_misses(name_of_0b)) return kSm2MissedSubIndex;
  return speaks_of_misses(name_of_0c) ? kSm2MissedSubIndexOldLayout : std::uint8_t{0};
}

}  // namespace syncline
