// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_survey.h"

#include <algorithm>
#include <array>
#include <utility>

#include "config/dc_settings.h"
#include "master/clocks/delay_latch.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_address.h"
#include "master/scan/bus_scanner.h"
#include "protocol/assign_activate.h"
#include "protocol/registers.h"
#include "protocol/speed_counter.h"
#include "protocol/system_time_difference.h"

namespace syncline {
namespace {

/// Registers 0x0910 to 0x0935 and 0x0980 to 0x09A7, in pieces that ESCs of 32 bits answer too.
struct Raw {
  std::array<std::uint8_t, 8> system_time{}, offset{}, next_sync0{};
  std::array<std::uint8_t, 4> delay{}, difference{};
  std::array<std::uint8_t, 6> loop{};
  std::array<std::uint8_t, 2> activate{};
  std::array<std::uint8_t, 1> status{};
  std::array<std::uint8_t, 8> cycles{};
};

template <class T, std::size_t N>
T at(const std::array<std::uint8_t, N>& bytes, std::size_t offset = 0) {
  return load_le<T>(std::span<const std::uint8_t>(bytes).subspan(offset));
}

ClockReading reading_of(const Raw& raw, DcCapability capability) {
  ClockReading clock;
  clock.capability = capability;
  clock.system_time = at<std::uint64_t>(raw.system_time);
  clock.offset = at<std::uint64_t>(raw.offset);
  clock.delay_ns = at<std::uint32_t>(raw.delay);
  clock.difference_ns = SystemTimeDifference{at<std::uint32_t>(raw.difference)}.signed_value();
  clock.speed_counter_start = at<std::uint16_t>(raw.loop);
  clock.speed_counter_diff = static_cast<std::int16_t>(at<std::uint16_t>(raw.loop, 2));
  clock.filter_depth_difference = raw.loop[4] & 0x0F;
  clock.filter_depth_speed_counter = raw.loop[5] & 0x0F;
  clock.assign_activate = at<std::uint16_t>(raw.activate);
  clock.start_pending = (raw.status[0] & 0x01) != 0;
  clock.next_sync0 = at<std::uint64_t>(raw.next_sync0);
  clock.sync0_cycle_ns = at<std::uint32_t>(raw.cycles);
  clock.sync1_cycle_ns = at<std::uint32_t>(raw.cycles, 4);
  return clock;
}

}  // namespace

double ClockReading::correction_ppm() const {
  return speed_counter_rate(speed_counter_start, speed_counter_diff) * 1e6;
}

bool ClockReading::start_missed() const {
  if (!AssignActivate{assign_activate}.unit_on() || !AssignActivate{assign_activate}.sync0() || !start_pending)
    return false;
  if (capability == DcCapability::kSystemTime64) return static_cast<std::int64_t>(next_sync0 - system_time) <= 0;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(next_sync0) - static_cast<std::uint32_t>(system_time)) <=
         0;
}

Result<std::vector<ClockReading>> survey_clocks(Bus& bus, std::span<const SlaveAddress> slaves) {
  const auto capabilities = probe_dc(bus, slaves);
  if (!capabilities) return tl::unexpected(capabilities.error());
  std::vector<Raw> raw(slaves.size());
  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!has_system_time((*capabilities)[i])) continue;
    const std::size_t width = (*capabilities)[i] == DcCapability::kSystemTime64 ? 8 : 4;
    reads.push_back(slaves[i].read(reg::kSystemTime, std::span(raw[i].system_time).first(width)));
    reads.push_back(slaves[i].read(reg::kSystemTimeOffset, std::span(raw[i].offset).first(width)));
    reads.push_back(slaves[i].read(reg::kSystemTimeDelay, raw[i].delay));
    reads.push_back(slaves[i].read(reg::kSystemTimeDifference, raw[i].difference));
    reads.push_back(slaves[i].read(reg::kSpeedCounterStart, raw[i].loop));
    reads.push_back(slaves[i].read(reg::kCyclicUnitControl, raw[i].activate));
    reads.push_back(slaves[i].read(reg::kActivationStatus, raw[i].status));
    reads.push_back(slaves[i].read(reg::kStartTimeCyclicOperation, std::span(raw[i].next_sync0).first(width)));
    reads.push_back(slaves[i].read(reg::kSync0CycleTime, raw[i].cycles));
  }
  if (auto status = bus.transact(reads); !status) return tl::unexpected(status.error());
  std::vector<ClockReading> clocks;
  for (std::size_t i = 0; i < slaves.size(); ++i) clocks.push_back(reading_of(raw[i], (*capabilities)[i]));
  return clocks;
}

Result<DelaySurvey> survey_delays(Bus& bus, std::span<const SlaveAddress> slaves, std::size_t rounds,
                                  const dc::DelayOptions& options) {
  auto segment = read_clock_segment(bus, slaves);
  if (!segment) return tl::unexpected(segment.error());
  DelaySurvey survey;
  survey.segment = std::move(*segment);
  DelayLatch latch(slaves, survey.segment.nodes, rounds);
  for (std::size_t round = 0; round < std::max<std::size_t>(rounds, 1); ++round) {
    if (rounds > 0) {
      if (auto status = bus.transact(latch.trigger()); !status) return tl::unexpected(status.error());
    }
    if (auto status = bus.transact(latch.begin_reading()); !status) return tl::unexpected(status.error());
    (void)latch.take();
  }
  if (latch.rounds() == 0) return fail(ErrorCode::kNoResponse, "receive times");
  survey.rounds = rounds == 0 ? 0 : latch.rounds();
  survey.segment.nodes = latch.nodes();
  auto& wiring = survey.segment.wiring;
  wiring = segment_wiring(survey.segment.nodes, survey.segment.dl_status);
  survey.result = segment_delays(survey.segment.nodes, wiring, survey.segment.whole, options);
  return survey;
}

}  // namespace syncline
