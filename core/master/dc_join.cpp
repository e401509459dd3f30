// SPDX-License-Identifier: Apache-2.0
#include "master/dc_join.h"

#include <algorithm>
#include <array>
#include <vector>

#include "master/bus_scanner.h"
#include "protocol/dc_registers.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSpeedCounterDefault = 0x1000;
constexpr Nanoseconds kSettleTimeout = 5 * kSecond;
constexpr std::uint32_t kNear = 1'000;  // ns
constexpr int kNearInARow = 50;

}  // namespace

Status DcJoin::run(std::span<const std::size_t> slaves, std::optional<std::uint16_t> leader) {
  std::vector<std::uint16_t> stations;
  for (const auto slave : slaves) stations.push_back(run_.config().slaves[slave].station_address);
  const auto capabilities = probe_dc(bus_, stations);
  if (!capabilities) return tl::unexpected(capabilities.error());
  std::vector<std::size_t> joined;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const bool wide = (*capabilities)[i] == DcCapability::kSystemTime64;
    if (!wide && (*capabilities)[i] != DcCapability::kSystemTime32) continue;
    if (auto status = set_clock(slaves[i], wide, leader); !status) return status;
    if (run_.snapshot.slaves[slaves[i]].dc_enabled) joined.push_back(slaves[i]);
  }
  return leader ? await(joined) : Status{};
}

Status DcJoin::set_clock(std::size_t slave, bool wide, std::optional<std::uint16_t> leader) {
  const auto& config = run_.config();
  const auto station = config.slaves[slave].station_address;
  std::array<std::uint8_t, 8> zero{}, mine{}, theirs{};
  auto delay = le_bytes(run_.snapshot.slaves[slave].propagation_delay_ns);
  const auto at = [](std::uint16_t address, std::uint16_t ado, std::span<std::uint8_t> bytes, Command command) {
    return Datagram{command, device_address(address, ado), bytes};
  };
  const std::size_t width = wide ? 8 : 4;
  std::array clear{at(station, reg::kSystemTimeOffset, std::span(zero).first(width), Command::kFpwr),
                   at(station, reg::kSystemTimeDelay, delay, Command::kFpwr)};
  if (auto status = bus_.transact(clear); !status) return status;

  Nanoseconds reference = 0;
  std::array read{at(station, reg::kSystemTime, std::span(mine).first(width), Command::kFprd),
                  at(leader ? config.slaves[*leader].station_address : station, reg::kSystemTime, theirs, Command::kFprd)};
  if (auto status = bus_.transact(read); !status) return status;
  if (read[0].wkc == 0) return {};  // gone again: the next sweep tells
  const auto host = sync_.reference_time_at(bus_.clock().now());
  reference = host;
  if (leader && read[1].wkc > 0) {
    reference = sync_.extend(load_le<std::uint32_t>(theirs), bus_.clock().now());
  }
  const auto local = wide ? load_le<std::uint64_t>(mine) : load_le<std::uint32_t>(mine);
  auto offset = le_bytes(static_cast<std::uint64_t>(reference) - local);
  offset.resize(width);
  auto speed = le_bytes(kSpeedCounterDefault);
  std::array set{at(station, reg::kSystemTimeOffset, offset, Command::kFpwr)};
  if (auto status = bus_.transact(set); !status) return status;
  // Resets the filters, which must see the new time.
  std::array filter{at(station, reg::kSpeedCounterStart, speed, Command::kFpwr)};
  return bus_.transact(filter);
}

/// The loop needs some thousand frames to learn the quartz; SYNC signals before that would be off by microseconds.
Status DcJoin::await(std::span<const std::size_t> slaves) {
  const auto end = bus_.clock().now() + kSettleTimeout;
  std::vector<std::array<std::uint8_t, 4>> bytes(slaves.size());
  int near = 0;
  while (!slaves.empty() && near < kNearInARow && bus_.clock().now() < end) {
    std::vector<Datagram> reads;
    for (std::size_t i = 0; i < slaves.size(); ++i) {
      bytes[i].fill(0);
      reads.push_back({Command::kFprd,
                       device_address(run_.config().slaves[slaves[i]].station_address, reg::kSystemTimeDifference),
                       bytes[i]});
    }
    if (auto status = bus_.transact(reads); !status) return status;
    const bool all = std::ranges::all_of(bytes, [](const auto& b) {
      return SystemTimeDifference{load_le<std::uint32_t>(b)}.magnitude() <= kNear;
    });
    near = all ? near + 1 : 0;
  }
  return {};
}

}  // namespace syncline
