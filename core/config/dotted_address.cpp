// SPDX-License-Identifier: Apache-2.0
#include "config/dotted_address.h"

#include <charconv>

namespace syncline {
namespace {

/// `N` numbers 0..255 with dots.
template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> dotted_bytes(std::string_view text) {
  std::array<std::uint8_t, N> bytes{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
    const auto [behind, error] = std::from_chars(at, end, bytes[i]);
    if (error != std::errc{}) return std::nullopt;
    at = behind;
  }
  return at == end ? std::optional(bytes) : std::nullopt;
}

}  // namespace

std::optional<std::array<std::uint8_t, 4>> ipv4_bytes(std::string_view text) { return dotted_bytes<4>(text); }

std::optional<std::array<std::uint8_t, 6>> ams_net_id_bytes(std::string_view text) { return dotted_bytes<6>(text); }

}  // namespace syncline
