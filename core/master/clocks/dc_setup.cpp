// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/dc_setup.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/dc_settings.h"
#include "config/network_config.h"
#include "dc/clock_registers.h"
#include "dc/system_time_offset.h"
#include "master/clocks/dc_loop_values.h"
#include "master/clocks/delay_latch.h"
#include "master/clocks/drift_compensation.h"
#include "master/exchange/bus.h"
#include "protocol/registers.h"
#include "reasons/because.h"
#include "support/le_number.h"

namespace syncline {
namespace {

constexpr Nanoseconds kSetupReplyTimeout = 10 * kMillisecond;
/// Nobody waits for the frames of the burst, which takes a thousand of its cycles: in long ones minutes. At a tenth of
/// the cycle a slave still learns its quartz so well that it does not run off until the next frame.
constexpr Nanoseconds burst_cycle(Nanoseconds cycle) {
  constexpr Nanoseconds kUsual = kMillisecond;
  constexpr int kSooner = 10;
  return std::min(cycle, std::max(kUsual, cycle / kSooner));
}

}  // namespace

std::optional<std::uint16_t> configured_reference_clock(const NetworkConfig& config) {
  if (!config.dc.enabled) return std::nullopt;
  if (config.dc.reference_clock) return config.dc.reference_clock;
  if (const auto position = config.reference_clock()) return position;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (config.slaves[i].dc) return static_cast<std::uint16_t>(i);
  }
  return std::nullopt;
}

dc::DelayOptions delay_options(const DcMasterSettings& settings) { return {settings.delay_difference}; }

std::size_t DcNetwork::synchronised_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(slaves, &Slave::synchronised));
}

std::string DcSetup::subject(std::size_t slave) const {
  return fmt::format("slave {} ({})", slaves_[slave], config_.slaves[slaves_[slave]].name);
}

Result<DcNetwork> DcSetup::run() {
  if (auto status = read_slaves(); !status) return tl::unexpected(status.error());
  if (auto status = measure(); !status) return tl::unexpected(status.error());
  if (auto status = burst(); !status) return tl::unexpected(status.error());
  return for_all_slaves();
}

/// The network as the configuration counts its slaves.
DcNetwork DcSetup::for_all_slaves() const {
  DcNetwork network = network_;
  network.slaves.assign(config_.slaves.size(), {});
  for (std::size_t i = 0; i < slaves_.size(); ++i) network.slaves[slaves_[i]] = network_.slaves[i];
  network.measured = slaves_;
  network.segment = segment_;
  network.reference_clock = static_cast<std::uint16_t>(slaves_[network_.reference_clock]);
  for (auto& finding : network.findings) finding.position = static_cast<std::uint16_t>(slaves_[finding.position]);
  return network;
}

/// The configured clock, or the first one by the user's will; when it is not there, or its system time does not answer,
/// the next one that takes part in distributed clocks.
Status DcSetup::choose_reference() {
  const auto can_lead = [this](std::size_t i) { return has_system_time(segment_.capabilities[i]); };
  const auto take = [this](std::size_t i, std::size_t home) {
    network_.reference_clock = static_cast<std::uint16_t>(i);
    network_.home = static_cast<std::uint16_t>(home);
    return Status{};
  };
  if (config_.dc.first_slave_is_reference_clock) {
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      if (can_lead(i)) return take(i, slaves_[i]);
    }
    return fail(ErrorCode::kDcSetup, "master", because("no slave on the bus has a system time"));
  }
  const auto configured = configured_reference_clock(config_);
  if (!configured || *configured >= config_.slaves.size()) {
    return fail(ErrorCode::kDcSetup, "master", because("no slave is configured as reference clock"));
  }
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const bool is_it = slaves_[i] == *configured;
    if (is_it && !can_lead(i)) network_.without_time = configured;
    const bool candidate = is_it || (slaves_[i] > *configured && config_.slaves[slaves_[i]].dc);
    if (candidate && can_lead(i)) return take(i, network_.without_time ? slaves_[i] : *configured);
  }
  if (network_.without_time) {
    return fail(ErrorCode::kDcSetup, fmt::format("slave {} ({})", *configured, config_.slaves[*configured].name),
                because("it has no system time and cannot be the reference clock, and no slave behind it can"));
  }
  return fail(ErrorCode::kDcSetup, "master", because("no slave that is there can be the reference clock"));
}

Status DcSetup::read_slaves() {
  for (const auto slave : slaves_) {
    addresses_.push_back(SlaveAddress::at_station(config_.slaves[slave].station_address));
  }
  auto segment = read_clock_segment(bus_, addresses_);
  if (!segment) return tl::unexpected(segment.error());
  segment_ = std::move(*segment);
  if (auto status = choose_reference(); !status) return status;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto capability = segment_.capabilities[i];
    network_.slaves.push_back({capability, has_system_time(capability) && i >= network_.reference_clock, 0});
  }
  return {};
}

/// False when a frame was lost: that costs its round only.
Result<bool> DcSetup::latch_round(DelayLatch& latch) {
  auto& trigger = latch.trigger();
  frame_.clear();
  (void)frame_.add(trigger);
  if (auto status = bus_.exchange().send(frame_); !status) return tl::unexpected(status.error());
  PendingFrame* frames[] = {&frame_};
  if (auto status = bus_.exchange().collect(frames, frame_.send_time() + kSetupReplyTimeout); !status) {
    return tl::unexpected(status.error());
  }
  if (!trigger.answered) return false;
  if (auto status = bus_.transact(latch.begin_reading()); !status) {
    if (status.error().code == ErrorCode::kNoResponse) return false;
    return tl::unexpected(status.error());
  }
  if (!latch.take()) return false;
  latch_time_ = frame_.send_time();
  return true;
}

Status DcSetup::measure() {
  DelayLatch latch(addresses_, segment_.nodes, config_.dc.delay_rounds);
  for (unsigned round = 0; round < std::max<unsigned>(config_.dc.delay_rounds, 1); ++round) {
    if (auto counted = latch_round(latch); !counted) return tl::unexpected(counted.error());
  }
  if (latch.rounds() == 0) return fail(ErrorCode::kDcSetup, "master", because("no answer to the receive time latch"));
  segment_.wiring = segment_wiring(latch.nodes(), segment_.dl_status);
  auto delays = segment_delays(latch.nodes(), segment_.wiring, segment_.whole, delay_options(config_.dc));
  network_.findings = std::move(delays.findings);
  std::erase_if(network_.findings,
                [&](const auto& finding) { return !matters_behind(network_.reference_clock, finding); });
  const auto origin = delays.delay_ns[network_.reference_clock].value_or(0);
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto delay = delays.delay_ns[i].value_or(origin);
    network_.slaves[i].delay_ns = delay > origin ? delay - origin : 0;
  }
  return write_times(latch);
}

/// With control off nothing teaches the reference clock the host's rate, or its natural drift would not be seen.
bool DcSetup::steered() const { return steers_reference_clock(config_.dc.dcm.mode) && !config_.dc.dcm.control_off; }

Status DcSetup::write_times(const DelayLatch& latch) {
  std::vector<Write> times, filters;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto& slave = network_.slaves[i];
    if (!has_system_time(slave.capability)) continue;
    const bool wide = slave.capability == DcCapability::kSystemTime64;
    auto offset = le_bytes(dc::system_time_offset(latch_time_, latch.processing_unit(i), slave.delay_ns, wide));
    if (!wide) offset.resize(4);
    times.push_back({i, reg::kSystemTimeOffset, std::move(offset)});
    times.push_back({i, reg::kSystemTimeDelay, le_bytes(slave.delay_ns)});
    add_loop_values(i, filters);
  }
  // Writing the speed counter resets the filters, which must see the new times.
  return write_all(times).and_then([&] { return see_whether_taken(times); }).and_then([&] {
    return write_all(filters);
  });
}

void DcSetup::add_loop_values(std::size_t slave, std::vector<Write>& filters) const {
  const auto role = slave == network_.reference_clock  ? DcLoopRole::kLeader
                    : slave < network_.reference_clock ? DcLoopRole::kInFront
                                                       : DcLoopRole::kFollower;
  for (auto& write : dc_loop_values(config_, role)) {
    const bool optional = write.optional();
    filters.push_back({slave, write.address, std::move(write.bytes), optional});
  }
}

Status DcSetup::write_all(std::span<Write> writes) {
  std::vector<Datagram> datagrams;
  for (auto& write : writes) datagrams.push_back(addresses_[write.slave].write(write.address, write.bytes));
  if (auto status = bus_.transact(datagrams); !status) return status;
  for (std::size_t i = 0; i < writes.size(); ++i) {
    if (datagrams[i].wkc > 0 || writes[i].optional) continue;
    return fail(ErrorCode::kDcSetup, subject(writes[i].slave), because("it does not take its system time offset"));
  }
  return {};
}

/// A register may count a write and keep its value: such a clock stays where it is, and start times for its SYNC
/// signals would be times that never come. Nobody waits for clocks in front of the reference clock.
Status DcSetup::see_whether_taken(std::span<const Write> times) {
  std::vector<std::vector<std::uint8_t>> read;
  std::vector<Datagram> datagrams;
  for (const auto& write : times) read.emplace_back(write.bytes.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    datagrams.push_back(addresses_[times[i].slave].read(times[i].address, read[i]));
  }
  if (auto status = bus_.transact(datagrams); !status) return status;
  std::vector<std::size_t> stubborn;
  std::size_t first = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto slave = times[i].slave;
    const bool kept = datagrams[i].wkc == 0 || read[i] == times[i].bytes;
    if (kept || !network_.slaves[slave].synchronised) continue;
    if (stubborn.empty()) first = i;
    if (stubborn.empty() || stubborn.back() != slave) stubborn.push_back(slave);
  }
  if (stubborn.empty()) return {};
  constexpr std::size_t kMostNames = 4;
  auto names = subject(stubborn.front());
  for (std::size_t n = 1; n < std::min(stubborn.size(), kMostNames); ++n) names += ", " + subject(stubborn[n]);
  if (stubborn.size() > kMostNames) names += ", ...";
  const auto number = [](std::span<const std::uint8_t> bytes) { return fmt::format("0x{:X}", le_number(bytes)); };
  return fail(ErrorCode::kDcSetup, std::move(names),
              because("{count} of the clocks do not keep what is written to 0x0920 and 0x0928, the first one reads "
                      "{read} in {register} instead of {written}",
                      stubborn.size(), number(read[first]), fmt::format("0x{:04X}", times[first].address),
                      number(times[first].bytes)));
}

Status DcSetup::burst() {
  DcBurst::Plan plan;
  plan.by_place = complete();  // else places on the bus are not those of the configuration
  const auto adp = plan.by_place ? Position{network_.reference_clock}.auto_increment_address()
                                 : config_.slaves[slaves_[network_.reference_clock]].station_address;
  plan.address = device_address(adp, reg::kSystemTime);
  plan.steer = steered();
  plan.wide = config_.dc.show_64bit_system_time;
  plan.total = config_.dc.burst_total;
  plan.bulk = config_.dc.burst_bulk;
  plan.ends_early = config_.dc.burst_ends_early;
  plan.cycle = burst_cycle(config_.cycle_time());
  const auto outcome = DcBurst(bus_, plan).run();
  if (!outcome) return tl::unexpected(outcome.error());
  if (!outcome->answered) {
    return fail(ErrorCode::kDcSetup, subject(network_.reference_clock), because("its system time cannot be read"));
  }
  network_.host_time = outcome->host_time;
  network_.reference_time = outcome->reference_time;
  network_.burst_frames = outcome->frames;
  network_.settled = outcome->settled;
  return {};
}

}  // namespace syncline
