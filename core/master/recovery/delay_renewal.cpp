// SPDX-License-Identifier: Apache-2.0
#include "master/recovery/delay_renewal.h"

#include <algorithm>
#include <array>
#include <utility>

#include "channels/slave_status.h"
#include "channels/snapshot.h"
#include "config/dc_settings.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/clocks/clock_segment.h"
#include "master/clocks/clock_survey.h"
#include "master/clocks/dc_setup.h"
#include "master/clocks/delay_compensation.h"
#include "master/cyclic/cyclic_task.h"
#include "master/exchange/event_teller.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr Nanoseconds kMovesPeriod = 100 * kMillisecond;
constexpr Nanoseconds kQuiet = kSecond;  // a plug that is pushed in makes contact more than once
/// Without a sync window: small beside what positions are compared with.
constexpr std::uint32_t kUsualStep = 31;  // ns

}  // namespace

Nanoseconds DelayRenewal::last_move() const {
  Nanoseconds last = 0;
  for (const auto& slave : snapshot_.slaves) last = std::max(last, slave.moved);
  return last;
}

/// Nobody answers whose station address is not known: a device that is not set up changes the way, too.
bool DelayRenewal::all_known() const {
  const auto known = std::ranges::count_if(snapshot_.slaves, &SlaveStatus::present);
  return !task_.slaves().refreshing() && known > 0 && task_.slaves().answering() == known;
}

Status DelayRenewal::after_cycle() {
  const auto now = snapshot_.time;
  if (now < next_look_) return {};
  next_look_ = now + kMovesPeriod;
  const auto last = last_move();
  const auto leader = task_.reference().leader();
  if (last <= delays_.measured_at() || now - last < kQuiet || !leader || !all_known()) return {};
  next_look_ = now + kQuiet;
  return measure(*leader);
}

Result<std::optional<DelayRenewal::Members>> DelayRenewal::read_members() {
  const std::size_t count = *task_.slaves().answering();
  std::vector<std::array<std::uint8_t, 2>> stations(count);
  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < count; ++i) {
    reads.push_back(SlaveAddress::at_position(static_cast<std::uint16_t>(i)).read(reg::kStationAddress, stations[i]));
  }
  if (auto status = bus_.transact(reads); !status) return tl::unexpected(status.error());
  Members members;
  const auto& slaves = config_.slaves;
  for (const auto& bytes : stations) {
    const auto station = load_le<std::uint16_t>(bytes);
    const auto found = std::ranges::find(slaves, station, &SlaveConfig::station_address);
    const auto position = static_cast<std::size_t>(found - slaves.begin());
    if (found == slaves.end() || !snapshot_.slaves[position].present) return std::nullopt;
    if (std::ranges::find(members.slaves, position) != members.slaves.end()) return std::nullopt;
    members.slaves.push_back(position);
    members.addresses.push_back(SlaveAddress::at_station(station));
  }
  return members;
}

Status DelayRenewal::measure(std::uint16_t leader) {
  const auto last = last_move();
  auto members = read_members();
  if (!members) return tl::unexpected(members.error());
  if (!*members) return {};
  const auto& dc = config_.dc;
  auto survey = survey_delays(bus_, (*members)->addresses, dc.delay_rounds, delay_options(dc));
  if (!survey) return tl::unexpected(survey.error());
  // Somebody moved meanwhile: what was latched is of two trees.
  if (last_move() != last || task_.reference().leader() != leader) return {};
  const auto now = snapshot_.time;
  const auto leads = std::ranges::find((*members)->slaves, leader) - (*members)->slaves.begin();
  for (const auto& finding : survey->result.findings) {
    if (!matters_behind(static_cast<std::size_t>(leads), finding)) continue;
    teller_.tell(now, static_cast<int>((*members)->slaves[finding.position]),
                 events::DelayFinding{finding.warning, finding.value_ns});
  }
  const auto limit = snapshot_.dc.limit_ns;
  const auto step = limit > 0 ? std::max<std::uint32_t>(limit / 4, 1) : kUsualStep;
  delays_.renew(std::move((*members)->slaves), *survey, leader, step, now);
  return {};
}

}  // namespace syncline
