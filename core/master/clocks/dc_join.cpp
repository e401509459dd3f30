// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/dc_join.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/clocks/clock_feed.h"
#include "master/clocks/dc_loop_values.h"
#include "master/clocks/sync_watch.h"
#include "master/exchange/bus.h"
#include "master/scan/bus_scanner.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "protocol/speed_counter.h"
#include "protocol/system_time_difference.h"

namespace syncline {
namespace {

constexpr Nanoseconds kSettleTimeout = 5 * kSecond;
/// In the mean of so many cycles; a mean, because a clock in front of the leader is told what the master believes.
constexpr int kReadings = 16;
constexpr std::int64_t kNear = 31;  // ns
/// Before the loop has seen so many messages, the small deviation of the beginning says nothing.
constexpr std::size_t kLearning = 600, kLearningSlowly = 2'048;

/// The burst ends with whoever asked for it.
class Burst {
 public:
  Burst(ClockFeed& feed, std::uint16_t station) : feed_(feed) { feed_.start(station); }
  ~Burst() { feed_.stop(); }
  Burst(const Burst&) = delete;
  Burst& operator=(const Burst&) = delete;

 private:
  ClockFeed& feed_;
};

}  // namespace

Status DcJoin::run(std::span<const std::size_t> slaves, std::optional<std::uint16_t> leader) {
  std::vector<std::uint16_t> stations;
  for (const auto slave : slaves) stations.push_back(config_.slaves[slave].station_address);
  const auto capabilities = probe_dc(bus_, stations);
  if (!capabilities) return tl::unexpected(capabilities.error());
  std::vector<std::size_t> joined;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const bool wide = (*capabilities)[i] == DcCapability::kSystemTime64;
    if (!wide && (*capabilities)[i] != DcCapability::kSystemTime32) continue;
    if (auto status = set_clock(slaves[i], wide, leader); !status) return status;
    if (snapshot_.slaves[slaves[i]].dc_enabled) joined.push_back(slaves[i]);
  }
  if (!leader || joined.empty()) return {};
  const Burst burst(feed_, config_.slaves[*leader].station_address);
  return await(joined, leader);
}

Status DcJoin::set_clock(std::size_t slave, bool wide, std::optional<std::uint16_t> leader) {
  const auto& config = config_;
  const auto station = config.slaves[slave].station_address;
  std::array<std::uint8_t, 8> zero{}, mine{}, theirs{};
  auto delay = le_bytes(snapshot_.slaves[slave].propagation_delay_ns);
  const auto at = [](std::uint16_t address, std::uint16_t ado, std::span<std::uint8_t> bytes, Command command) {
    return Datagram{command, device_address(address, ado), bytes};
  };
  const std::size_t width = wide ? 8 : 4;
  std::array clear{at(station, reg::kSystemTimeOffset, std::span(zero).first(width), Command::kFpwr),
                   at(station, reg::kSystemTimeDelay, delay, Command::kFpwr)};
  if (auto status = bus_.transact(clear); !status) return status;

  Nanoseconds reference = 0;
  std::array read{
      at(station, reg::kSystemTime, std::span(mine).first(width), Command::kFprd),
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
  std::array set{at(station, reg::kSystemTimeOffset, offset, Command::kFpwr)};
  if (auto status = bus_.transact(set); !status) return status;
  return set_loop(slave, role_of(slave, leader));  // resets the filters, which must see the new time
}

/// Who leads while the home clock is away is in front of more slaves than that, as a rule; they are prepared for it.
DcLoopRole DcJoin::role_of(std::size_t slave, std::optional<std::uint16_t> leader) const {
  if (slave == home_) return DcLoopRole::kReturning;
  return slave < std::max(home_, leader.value_or(home_)) ? DcLoopRole::kInFront : DcLoopRole::kFollower;
}

Status DcJoin::set_loop(std::size_t slave, DcLoopRole role) {
  const auto station = config_.slaves[slave].station_address;
  auto values = dc_loop_values(config_, role);
  if (values.empty()) values.push_back({reg::kSpeedCounterStart, le_bytes(kSpeedCounterDefault)});
  std::vector<Datagram> writes;
  for (auto& value : values) writes.push_back({Command::kFpwr, device_address(station, value.address), value.bytes});
  return bus_.transact(writes);
}

/// The loop needs some hundred frames to learn the quartz; SYNC signals before that would be off by microseconds.
Status DcJoin::await(std::span<const std::size_t> slaves, std::optional<std::uint16_t> leader) {
  const auto end = bus_.clock().now() + kSettleTimeout;
  std::vector<std::array<std::uint8_t, 4>> bytes(slaves.size());
  std::vector<std::int64_t> sums(slaves.size());
  const bool slowly =
      std::ranges::any_of(slaves, [&](std::size_t slave) { return role_of(slave, leader) != DcLoopRole::kFollower; });
  const auto rounds = (slowly ? kLearningSlowly : kLearning) / (feed_.messages_per_cycle() * kReadings) + 1;
  bool near = false;
  for (std::size_t round = 0; (!near || round < rounds) && bus_.clock().now() < end; ++round) {
    std::ranges::fill(sums, 0);
    for (int reading = 0; reading < kReadings; ++reading) {
      std::vector<Datagram> reads;
      for (std::size_t i = 0; i < slaves.size(); ++i) {
        bytes[i].fill(0);
        const auto station = config_.slaves[slaves[i]].station_address;
        reads.push_back({Command::kFprd, device_address(station, reg::kSystemTimeDifference), bytes[i]});
      }
      if (auto status = bus_.transact(reads); !status) return status;
      for (std::size_t i = 0; i < slaves.size(); ++i) {
        sums[i] += SystemTimeDifference{load_le<std::uint32_t>(bytes[i])}.signed_value();
      }
    }
    near = std::ranges::all_of(sums, [](std::int64_t sum) { return std::abs(sum) <= kNear * kReadings; });
  }
  return {};
}

}  // namespace syncline
