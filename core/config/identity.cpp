// SPDX-License-Identifier: Apache-2.0
#include "config/identity.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace syncline {
namespace {

constexpr std::array<std::pair<RevisionCheck, std::string_view>, 5> kRevisionChecks{{
    {RevisionCheck::kNone, "NONE"},
    {RevisionCheck::kEqual, "EQ"},
    {RevisionCheck::kEqualOrGreater, "EQ_OR_G"},
    {RevisionCheck::kLowWordEqual, "LW_EQ"},
    {RevisionCheck::kLowWordEqualHighWordEqualOrGreater, "LW_EQ_HW_EQ_OR_G"},
}};

}  // namespace

std::string to_string(const Identity& identity) {
  return fmt::format("0x{:08x}:0x{:08x}:0x{:08x}", identity.vendor_id, identity.product_code, identity.revision_no);
}

std::string_view revision_check_name(RevisionCheck check) {
  for (const auto& [value, name] : kRevisionChecks) {
    if (value == check) return name;
  }
  return {};
}

std::optional<RevisionCheck> revision_check_from_name(std::string_view name) {
  for (const auto& [value, known] : kRevisionChecks) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace syncline
