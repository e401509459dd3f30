// SPDX-License-Identifier: Apache-2.0
#include "master/dc_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dc/plans.h"
#include "master/bus_scanner.h"
#include "master/topology.h"
#include "protocol/dc_registers.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr int kLatchRounds = 20;
constexpr std::uint16_t kSpeedCounterDefault = 0x1000;
/// Averages 2^4 differences: what the host writes jitters with its send times, what slaves are written does not.
constexpr std::uint8_t kSteeredFilterDepth = 4;
constexpr Nanoseconds kReplyTimeout = 10 * kMillisecond;
/// Before a filter length of frames (2^12) the small deviation of the beginning says nothing.
constexpr std::uint32_t kBurstMinimum = 4096;
constexpr std::uint32_t kSettledDeviation = 31;
/// Quartzes far apart need more frames than planned; as many again, then it is the cyclic frames' turn.
constexpr std::uint32_t kBurstPatience = 2;

bool has_system_time(DcCapability capability) {
  return capability == DcCapability::kSystemTime32 || capability == DcCapability::kSystemTime64;
}

dc::DcKind kind_of(DcCapability capability) {
  if (has_system_time(capability)) return dc::DcKind::kFull;
  return capability == DcCapability::kNone ? dc::DcKind::kNone : dc::DcKind::kReceiveTimesOnly;
}

std::uint32_t median(std::vector<std::uint32_t>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
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

std::size_t DcNetwork::synchronised_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(slaves, &Slave::synchronised));
}

/// Receive times of all slaves after one latch, and of all rounds against port 0.
struct DcSetup::Latch {
  explicit Latch(std::size_t slaves) : ports(slaves), processing_unit(slaves), differences(slaves) {}
  Nanoseconds host_time = 0;
  std::vector<std::array<std::uint8_t, 16>> ports;
  std::vector<std::array<std::uint8_t, 8>> processing_unit;
  std::vector<std::array<std::vector<std::uint32_t>, kPortCount>> differences;

  [[nodiscard]] std::uint32_t port(std::size_t slave, std::size_t n) const {
    return load_le<std::uint32_t>(std::span(ports[slave]).subspan(4 * n));
  }
};

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
  network.reference_clock = static_cast<std::uint16_t>(slaves_[network_.reference_clock]);
  for (auto& finding : network.findings) finding.position = static_cast<std::uint16_t>(slaves_[finding.position]);
  return network;
}

/// The configured clock; when it is not there, the next one that takes part in distributed clocks.
Status DcSetup::choose_reference(const std::vector<DcCapability>& capabilities) {
  const auto configured = configured_reference_clock(config_);
  if (!configured || *configured >= config_.slaves.size()) {
    return fail(ErrorCode::kDcSetup, "master", "no slave is configured as reference clock");
  }
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const bool is_it = slaves_[i] == *configured;
    if (is_it && !has_system_time(capabilities[i])) {
      return fail(ErrorCode::kDcSetup, subject(i), "it has no system time and cannot be the reference clock");
    }
    if (is_it || (slaves_[i] > *configured && config_.slaves[slaves_[i]].dc && has_system_time(capabilities[i]))) {
      network_.reference_clock = static_cast<std::uint16_t>(i);
      return {};
    }
  }
  return fail(ErrorCode::kDcSetup, "master", "no slave that is there can be the reference clock");
}

Status DcSetup::read_slaves() {
  for (const auto slave : slaves_) stations_.push_back(config_.slaves[slave].station_address);
  const auto capabilities = probe_dc(bus_, stations_);
  if (!capabilities) return tl::unexpected(capabilities.error());
  if (auto status = choose_reference(*capabilities); !status) return status;
  std::vector<std::array<std::uint8_t, 2>> bytes(stations_.size());
  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    reads.push_back({Command::kFprd, device_address(stations_[i], reg::kDlStatus), bytes[i]});
  }
  if (auto read = bus_.transact(reads); !read) return read;
  std::vector<DlStatus> status;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (reads[i].wkc == 0) return fail(ErrorCode::kNoResponse, subject(i));
    status.push_back({load_le<std::uint16_t>(bytes[i])});
  }
  const auto previous = find_topology(status);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    dc::DelayNode node;
    node.kind = kind_of((*capabilities)[i]);
    for (unsigned port = 0; port < kPortCount; ++port) node.active[port] = status[i].active(port);
    if (previous[i]) {
      node.parent = previous[i]->position;
      node.parent_port = previous[i]->port;
    }
    nodes_.push_back(node);
    network_.slaves.push_back({(*capabilities)[i], has_system_time((*capabilities)[i]) && i >= network_.reference_clock, 0});
  }
  return {};
}

Status DcSetup::latch_round(Latch& latch) {
  std::array<std::uint8_t, 4> zeros{};
  Datagram trigger{Command::kBwr, device_address(0, reg::kReceiveTimePort0), zeros};
  frame_.clear();
  (void)frame_.add(trigger);
  if (auto status = bus_.exchange().send(frame_); !status) return status;
  PendingFrame* frames[] = {&frame_};
  if (auto status = bus_.exchange().collect(frames, frame_.send_time() + kReplyTimeout); !status) return status;
  if (!trigger.answered) return fail(ErrorCode::kNoResponse, "receive time latch");
  latch.host_time = frame_.send_time();

  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (nodes_[i].kind == dc::DcKind::kNone) continue;
    reads.push_back({Command::kFprd, device_address(stations_[i], reg::kReceiveTimePort0), latch.ports[i]});
    if (nodes_[i].kind == dc::DcKind::kFull) {
      reads.push_back(
          {Command::kFprd, device_address(stations_[i], reg::kReceiveTimeProcessingUnit), latch.processing_unit[i]});
    }
  }
  if (auto status = bus_.transact(reads); !status) return status;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    for (std::size_t port = 0; port < kPortCount; ++port) {
      latch.differences[i][port].push_back(latch.port(i, port) - latch.port(i, 0));
    }
  }
  return {};
}

Status DcSetup::measure() {
  Latch latch(stations_.size());
  for (int round = 0; round < kLatchRounds; ++round) {
    // A lost latch frame costs its round only.
    if (auto status = latch_round(latch); !status && status.error().code != ErrorCode::kNoResponse) return status;
  }
  if (latch.host_time == 0) return fail(ErrorCode::kDcSetup, "master", "no answer to the receive time latch");
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    for (std::size_t port = 0; port < kPortCount; ++port) {
      nodes_[i].receive_time[port] = latch.port(i, 0) + median(latch.differences[i][port]);
    }
  }
  auto delays = dc::propagation_delays(nodes_);
  network_.findings = std::move(delays.findings);
  const auto origin = delays.delay_ns[network_.reference_clock].value_or(0);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const auto delay = delays.delay_ns[i].value_or(origin);
    network_.slaves[i].delay_ns = delay > origin ? delay - origin : 0;
  }
  return write_times(latch);
}

Status DcSetup::write_times(const Latch& latch) {
  std::vector<Write> times, filters;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const auto& slave = network_.slaves[i];
    if (!has_system_time(slave.capability)) continue;
    const bool wide = slave.capability == DcCapability::kSystemTime64;
    const auto local = load_le<std::uint64_t>(latch.processing_unit[i]);
    auto offset = le_bytes(dc::system_time_offset(latch.host_time, local, slave.delay_ns, wide));
    if (!wide) offset.resize(4);
    times.push_back({i, reg::kSystemTimeOffset, std::move(offset)});
    times.push_back({i, reg::kSystemTimeDelay, le_bytes(slave.delay_ns)});
    if (i == network_.reference_clock && config_.dc.dcm.mode == DcmMode::kBusShift) {
      filters.push_back({i, reg::kFilterDepthDifference, {kSteeredFilterDepth}});
    }
    filters.push_back({i, reg::kSpeedCounterStart, le_bytes(kSpeedCounterDefault)});
  }
  // Writing the speed counter resets the filters, which must see the new times.
  return write_all(times).and_then([&] { return write_all(filters); });
}

Status DcSetup::write_all(std::span<Write> writes) {
  std::vector<Datagram> datagrams;
  for (auto& write : writes) {
    datagrams.push_back({Command::kFpwr, device_address(stations_[write.slave], write.address), write.bytes});
  }
  if (auto status = bus_.transact(datagrams); !status) return status;
  for (std::size_t i = 0; i < writes.size(); ++i) {
    if (datagrams[i].wkc > 0 || writes[i].address == reg::kFilterDepthDifference) continue;
    return fail(ErrorCode::kDcSetup, subject(writes[i].slave), "it does not take its system time offset");
  }
  return {};
}

void DcSetup::stamp(Nanoseconds send_time) {
  if (!anchor_) return;
  const auto expected = static_cast<std::uint32_t>(send_time + *anchor_);
  store_le(time_bytes_, expected);  // for slaves in front of the reference clock
  store_le(steer_bytes_, expected);
}

Status DcSetup::burst_frame(std::uint32_t* deviation_ored) {
  const auto adp = Position{network_.reference_clock}.auto_increment_address();
  std::array<std::uint8_t, 4> deviation{};
  time_bytes_.fill(0);
  Datagram read{Command::kArmw, device_address(adp, reg::kSystemTime), time_bytes_};
  Datagram steer{Command::kApwr, device_address(adp, reg::kSystemTime), steer_bytes_};
  if (!complete()) {
    // Places on the bus are not those of the configuration.
    const auto station = stations_[network_.reference_clock];
    read = {Command::kFrmw, device_address(station, reg::kSystemTime), time_bytes_};
    steer = {Command::kFpwr, device_address(station, reg::kSystemTime), steer_bytes_};
  }
  Datagram window{Command::kBrd, device_address(0, reg::kSystemTimeDifference), deviation};
  read.stamped = steer.stamped = true;
  frame_.clear();
  (void)frame_.add(read);
  if (anchor_ && config_.dc.dcm.mode == DcmMode::kBusShift) (void)frame_.add(steer);
  if (deviation_ored != nullptr) (void)frame_.add(window);
  if (auto status = bus_.exchange().send(frame_, this); !status) return status;
  PendingFrame* frames[] = {&frame_};
  if (auto status = bus_.exchange().collect(frames, frame_.send_time() + kReplyTimeout); !status) return status;
  if (read.wkc > 0) {
    network_.host_time = frame_.send_time();
    network_.reference_time = dc::extend_32bit(load_le<std::uint32_t>(time_bytes_), frame_.send_time());
    if (!anchor_) anchor_ = network_.reference_time - network_.host_time;
  }
  if (deviation_ored != nullptr && window.answered) {
    *deviation_ored = SystemTimeDifference{load_le<std::uint32_t>(deviation)}.magnitude();
  }
  return {};
}

Result<std::uint32_t> DcSetup::burst_bulk(std::uint32_t frames, std::uint32_t& deviation_ored) {
  // The bulk must leave room in its cycle, or the burst would not keep the cycle's pace.
  const auto end = bus_.clock().now() + config_.cycle_time() * 6 / 10;
  std::uint32_t sent = 0;
  while (sent < frames && (sent == 0 || bus_.clock().now() < end)) {
    if (auto status = burst_frame(sent == 0 ? &deviation_ored : nullptr); !status) {
      return tl::unexpected(status.error());
    }
    ++sent;
  }
  return sent;
}

Status DcSetup::burst() {
  const auto& settings = config_.dc;
  const auto bulk = std::max<std::uint32_t>(settings.burst_bulk, 1);
  auto next = bus_.clock().now();
  std::uint32_t sent = 0;
  const auto total = settings.burst_total * kBurstPatience;
  while (sent < total) {
    if (auto status = bus_.check_cancel(); !status) return status;
    std::uint32_t deviation = ~0U;
    const auto frames = burst_bulk(std::min(bulk, total - sent), deviation);
    if (!frames) return tl::unexpected(frames.error());
    sent += *frames;
    if (sent >= kBurstMinimum && deviation <= kSettledDeviation) break;
    next += config_.cycle_time();
    bus_.clock().sleep_until(next);
  }
  std::uint32_t deviation = 0;
  for (int attempt = 0; attempt < 4 && network_.reference_time == 0; ++attempt) {
    if (auto status = burst_frame(&deviation); !status) return status;
  }
  if (network_.reference_time == 0) {
    return fail(ErrorCode::kDcSetup, subject(network_.reference_clock), "its system time cannot be read");
  }
  return {};
}

}  // namespace syncline
