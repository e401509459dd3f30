// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/sync_bridge.h"

#include "support/byte_order.h"

namespace syncline::sim {

void SyncBridge::check_running(Nanoseconds time) {
  constexpr std::uint16_t kExternalSynchronisation = 0x10F4;
  auto* internal = dictionary_.find(kExternalSynchronisation, 0x11);
  auto* external = dictionary_.find(kExternalSynchronisation, 0x12);
  if (internal == nullptr || external == nullptr) return;
  const auto theirs = config().external_time ? config().external_time(time) : std::nullopt;
  internal->value = le_bytes(dc().system_time(time));
  external->value = le_bytes(static_cast<std::uint64_t>(theirs.value_or(0)));
  inputs_from_dictionary();
}

}  // namespace syncline::sim
