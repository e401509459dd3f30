// SPDX-License-Identifier: Apache-2.0
#include "master/scan/device_id.h"

#include <array>

#include "channels/values/bus_scan.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_address.h"
#include "protocol/al_state.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint8_t kIdentByAlStatus = 0x08, kIdentByMemory = 0x10;  // General.flags
constexpr std::uint16_t kIdRequest = 0x0020, kIdLoaded = 0x0020;        // AL control, AL status
constexpr Nanoseconds kIdPatience = 200 * kMillisecond;

Status read_from_memory(Bus& bus, std::span<const SlaveAddress> addresses, std::vector<ScannedSlave>& slaves) {
  std::vector<std::array<std::uint8_t, 2>> bytes(slaves.size());
  std::vector<Datagram> reads;
  std::vector<std::size_t> whom;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const auto& sii = slaves[i].sii;
    if (!sii || !sii->general || (sii->general->flags & kIdentByMemory) == 0) continue;
    reads.push_back(addresses[i].read(sii->general->physical_memory_address, bytes[i]));
    whom.push_back(i);
  }
  if (auto status = bus.transact(reads); !status) return status;
  for (std::size_t n = 0; n < whom.size(); ++n) {
    if (reads[n].wkc != 0) slaves[whom[n]].device_id = load_le<std::uint16_t>(bytes[whom[n]]);
  }
  return {};
}

/// The request bit on or off, in the state the slave is in.
Status write_request(Bus& bus, std::span<const SlaveAddress> addresses, std::span<const std::size_t> whom, bool on) {
  const auto control = static_cast<std::uint16_t>(AlState::kInit) | (on ? kIdRequest : 0);
  std::array<std::uint8_t, 2> bytes{};
  store_le(bytes, static_cast<std::uint16_t>(control));
  std::vector<Datagram> writes;
  for (const auto i : whom) writes.push_back(addresses[i].write(reg::kAlControl, bytes));
  return bus.transact(writes);
}

Status poll(Bus& bus, std::span<const SlaveAddress> addresses, std::vector<std::size_t> open,
            std::vector<ScannedSlave>& slaves) {
  const auto end = bus.clock().now() + kIdPatience;
  while (!open.empty() && bus.clock().now() < end) {
    if (auto status = bus.wait_a_little(); !status) return status;
    std::vector<std::array<std::uint8_t, 6>> bytes(open.size());
    std::vector<Datagram> reads;
    for (std::size_t n = 0; n < open.size(); ++n) reads.push_back(addresses[open[n]].read(reg::kAlStatus, bytes[n]));
    if (auto status = bus.transact(reads); !status) return status;
    std::vector<std::size_t> still;
    for (std::size_t n = 0; n < open.size(); ++n) {
      if (reads[n].wkc != 0 && (load_le<std::uint16_t>(bytes[n]) & kIdLoaded) != 0) {
        slaves[open[n]].device_id = load_le<std::uint16_t>(std::span(bytes[n]).subspan(4));
      } else {
        still.push_back(open[n]);
      }
    }
    open = std::move(still);
  }
  return {};
}

}  // namespace

Status read_device_ids(Bus& bus, std::span<const SlaveAddress> addresses, bool may_request,
                       std::vector<ScannedSlave>& slaves) {
  if (auto status = read_from_memory(bus, addresses, slaves); !status) return status;
  std::vector<std::size_t> whom;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const auto& slave = slaves[i];
    const bool offered = slave.sii && slave.sii->general && (slave.sii->general->flags & kIdentByAlStatus) != 0;
    const bool at_rest = slave.al_status == static_cast<std::uint16_t>(AlState::kInit);
    if (may_request && offered && at_rest && !slave.device_id) whom.push_back(i);
  }
  if (whom.empty()) return {};
  if (auto status = write_request(bus, addresses, whom, true); !status) return status;
  const auto polled = poll(bus, addresses, whom, slaves);
  if (auto status = write_request(bus, addresses, whom, false); !status) return status;
  return polled;
}

}  // namespace syncline
