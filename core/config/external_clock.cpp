// SPDX-License-Identifier: Apache-2.0
#include "config/external_clock.h"

#include "config/network_config.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kExternalSynchronisation = 0x10F4;
constexpr std::uint8_t kInternalTime = 0x11, kExternalTime = 0x12;
constexpr std::size_t kTimeBytes = 8;

std::optional<ExternalClockPlace> find_in(const SlaveConfig& slave, std::size_t position) {
  if (!slave.receive) return std::nullopt;
  std::optional<std::size_t> internal, external;
  std::size_t bit = slave.receive->bit_start;
  for (const auto& configured : slave.pdos) {
    if (configured.direction != PdoDirection::kTx || !configured.pdo.sync_manager) continue;
    for (const auto& entry : configured.pdo.entries) {
      const bool time = entry.index == kExternalSynchronisation && entry.bit_length == 64 && bit % 8 == 0;
      if (time && entry.sub_index == kInternalTime) internal = bit / 8;
      if (time && entry.sub_index == kExternalTime) external = bit / 8;
      bit += entry.bit_length;
    }
  }
  if (!internal || !external) return std::nullopt;
  return ExternalClockPlace{position, *internal, *external};
}

}  // namespace

std::optional<ExternalClockPlace> find_external_clock(const NetworkConfig& config) {
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (auto found = find_in(config.slaves[i], i)) return found;
  }
  return std::nullopt;
}

std::optional<ExternalClockTimes> external_clock_times(const ExternalClockPlace& place,
                                                       std::span<const std::uint8_t> inputs) {
  const auto time_at = [&](std::size_t byte) -> std::uint64_t {
    if (byte > inputs.size() || inputs.size() - byte < kTimeBytes) return 0;
    return load_le<std::uint64_t>(inputs.subspan(byte, kTimeBytes));
  };
  const auto internal = time_at(place.internal_byte), external = time_at(place.external_byte);
  if (internal == 0 || external == 0) return std::nullopt;
  return ExternalClockTimes{internal, external};
}

}  // namespace syncline
