// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace syncline {

/// "192.168.1.10" in the order of the text; empty when it is no such address.
[[nodiscard]] std::optional<std::array<std::uint8_t, 4>> ipv4_bytes(std::string_view text);

/// "5.1.2.3.1.1": six numbers 0..255 with dots.
[[nodiscard]] std::optional<std::array<std::uint8_t, 6>> ams_net_id_bytes(std::string_view text);

}  // namespace syncline
