// SPDX-License-Identifier: Apache-2.0
#include "compile/eoe_ip.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/dotted_address.h"
#include "config/slave_options.h"
#include "protocol/eoe.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kFlags = 4, kMac = 6, kAddress = 4, kName = 32;
constexpr std::size_t kSizes[] = {kMac, kAddress, kAddress, kAddress, kAddress, kName};
constexpr std::size_t kCount = std::size(kSizes);
constexpr std::size_t kWhole = kFlags + kMac + 4 * kAddress + kName;

std::array<std::uint8_t, kMac> mac_of(std::uint16_t station_address) {
  return {0x02,
          0x01,
          0x05,
          0x20,
          static_cast<std::uint8_t>(station_address >> 8),
          static_cast<std::uint8_t>(station_address)};
}

/// Bytes of the six parameters, empty where one is not set.
using Parameters = std::array<std::vector<std::uint8_t>, kCount>;

std::vector<std::uint8_t> address_bytes(const std::string& text) {
  const auto bytes = ipv4_bytes(text);
  return bytes ? std::vector<std::uint8_t>(bytes->rbegin(), bytes->rend()) : std::vector<std::uint8_t>{};
}

std::string address_text(std::span<const std::uint8_t> bytes) {
  const bool none = std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
  return none ? std::string() : fmt::format("{}.{}.{}.{}", bytes[3], bytes[2], bytes[1], bytes[0]);
}

Parameters parameters_of(const EoeSlaveSettings& eoe) {
  Parameters out;
  if (eoe.mac) out[0].assign(eoe.mac->begin(), eoe.mac->end());
  const std::string* const addresses[] = {&eoe.ip, &eoe.subnet, &eoe.gateway, &eoe.dns};
  for (std::size_t i = 0; i < std::size(addresses); ++i) out[i + 1] = address_bytes(*addresses[i]);
  if (!eoe.host_name.empty()) {
    out[5].assign(eoe.host_name.begin(), eoe.host_name.end());
    out[5].resize(kName);
  }
  return out;
}

}  // namespace

std::vector<std::uint8_t> encode_ip_parameters(const EoeSlaveSettings& eoe, std::uint16_t station_address) {
  const Parameters set = parameters_of(eoe);
  std::size_t last = kCount;  // behind the last one that is set
  while (last > 0 && set[last - 1].empty()) --last;
  if (last == 0) return {};
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes).u32((1U << last) - 1);
  for (std::size_t i = 0; i < kCount; ++i) {
    std::vector<std::uint8_t> parameter = set[i];
    if (i == 0 && parameter.empty()) {
      const auto made = mac_of(station_address);
      parameter.assign(made.begin(), made.end());
    }
    parameter.resize(kSizes[i]);
    bytes.insert(bytes.end(), parameter.begin(), parameter.end());
  }
  return bytes;
}

std::optional<EoeSlaveSettings> decode_ip_parameters(std::span<const std::uint8_t> data,
                                                     std::uint16_t station_address) {
  constexpr std::size_t kHeader = 4;
  if (!eoe::is_ip_parameters(data)) {
    const auto header = eoe::decode(data);
    if (!header || header->kind != eoe::Kind::kSetIpRequest) return std::nullopt;
    data = data.subspan(kHeader);
    if (!eoe::is_ip_parameters(data)) return std::nullopt;
  }
  const auto flags = load_le<std::uint32_t>(data);
  const bool fixed = data.size() == kWhole;
  EoeSlaveSettings out;
  std::size_t at = kFlags;
  for (std::size_t i = 0; i < kCount; ++i) {
    const bool set = (flags >> i & 1U) != 0;
    if (!set && !fixed) continue;
    const auto bytes = data.subspan(at, kSizes[i]);
    at += kSizes[i];
    if (!set) continue;
    if (i == 0) {
      std::array<std::uint8_t, kMac> mac{};
      std::ranges::copy(bytes, mac.begin());
      if (mac != mac_of(station_address)) out.mac = mac;
    } else if (i == kCount - 1) {
      out.host_name.assign(bytes.begin(), std::ranges::find(bytes, std::uint8_t{0}));
    } else {
      std::string* const addresses[] = {&out.ip, &out.subnet, &out.gateway, &out.dns};
      *addresses[i - 1] = address_text(bytes);
    }
  }
  return out;
}

}  // namespace syncline
