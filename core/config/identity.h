// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Who a device is, and which revisions count as it.
namespace syncline {

struct Identity {
  std::uint32_t vendor_id = 0;
  std::uint32_t product_code = 0;
  std::uint32_t revision_no = 0;
  std::uint32_t serial_no = 0;  // 0 = any
  bool operator==(const Identity&) const = default;
};
[[nodiscard]] std::string to_string(const Identity& identity);  // "0x00000002:0x044c2c52:0x00120000"

/// Type@CheckRevisionNo: which revisions count as this device.
enum class RevisionCheck : std::uint8_t {
  kNone,
  kEqual,
  kEqualOrGreater,
  kLowWordEqual,
  kLowWordEqualHighWordEqualOrGreater,
};
/// ETG.2000 CheckRevisionNo: "NONE", "EQ", "EQ_OR_G", "LW_EQ", "LW_EQ_HW_EQ_OR_G".
[[nodiscard]] std::string_view revision_check_name(RevisionCheck check);
[[nodiscard]] std::optional<RevisionCheck> revision_check_from_name(std::string_view name);

}  // namespace syncline
