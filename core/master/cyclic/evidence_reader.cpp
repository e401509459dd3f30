// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/evidence_reader.h"

#include <algorithm>
#include <utility>

#include "channels/slave_evidence.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/exchange/acyclic_window.h"
#include "master/exchange/event_teller.h"
#include "protocol/datagram.h"
#include "protocol/port_damage.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kPorts = 4;
// Offsets from 0x0300.
constexpr std::size_t kForwarded = 0x08, kProcessingUnit = 0x0C, kPdi = 0x0D, kLostLinks = 0x10;

}  // namespace

struct EvidenceReader::Place {
  std::uint16_t address = 0, length = 0;
};

EvidenceReader::EvidenceReader(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller)
    : config_(config), snapshot_(snapshot), teller_(teller), totals_(config.slaves.size()) {}

std::span<CounterTotal> EvidenceReader::counters(const Place& place) {
  auto& totals = totals_[slave_];
  const bool of_watchdogs = place.address >= reg::kWatchdogCounterProcessData;
  const std::span<CounterTotal> all = of_watchdogs ? std::span<CounterTotal>(totals.watchdogs) : totals.ports;
  return all.subspan(place.address - (of_watchdogs ? reg::kWatchdogCounterProcessData : reg::kRxErrorCounter),
                     place.length);
}

/// ESC data sheet II, 2.9: a write to one of them clears all of the place.
const EvidenceReader::Place* EvidenceReader::at_end_stop() {
  static constexpr std::array<Place, 5> kPlaces{{{reg::kRxErrorCounter, 12},
                                                 {reg::kProcessingUnitErrorCounter, 1},
                                                 {reg::kPdiErrorCounter, 1},
                                                 {reg::kLostLinkCounter, 4},
                                                 {reg::kWatchdogCounterProcessData, 2}}};
  const auto* const place = std::ranges::find_if(
      kPlaces, [this](const Place& p) { return std::ranges::any_of(counters(p), &CounterTotal::at_end_stop); });
  return place == kPlaces.end() ? nullptr : place;
}

bool EvidenceReader::worth_asking() {
  const auto& slave = snapshot_.slaves[slave_];
  if (what_ == What::kEndStop) return slave.present && at_end_stop() != nullptr;
  if (what_ == What::kDlStatus) return slave.present && slave.evidence.pdi_watchdog.total > 0;
  return slave.present && (what_ != What::kSpeedCounter || slave.dc_enabled);
}

void EvidenceReader::move_on() {
  what_ = static_cast<What>((static_cast<std::uint8_t>(what_) + 1) % kKinds);
  if (what_ == What::kPorts) slave_ = (slave_ + 1) % totals_.size();
}

Datagram* EvidenceReader::next(Nanoseconds /*now*/) {
  if (totals_.empty()) return nullptr;
  // Whoever is not there costs no cycle, and nobody being there no hang.
  for (std::size_t tried = 0; !worth_asking() && tried < kKinds * 16; ++tried) move_on();
  if (!worth_asking()) return nullptr;
  constexpr std::array<Place, kKinds> kPlaces{{{reg::kRxErrorCounter, 20},
                                               {reg::kWatchdogCounterProcessData, 2},
                                               {},
                                               {reg::kDlStatus, 2},
                                               {reg::kSpeedCounterDiff, 2}}};
  const bool clears = what_ == What::kEndStop;
  const auto place = clears ? *at_end_stop() : kPlaces[static_cast<std::size_t>(what_)];
  bytes_.fill(0);
  datagram_ = {clears ? Command::kFpwr : Command::kFprd,
               device_address(config_.slaves[slave_].station_address, place.address),
               std::span(bytes_).first(place.length)};
  return &datagram_;
}

void EvidenceReader::take(Nanoseconds time) {
  if (!datagram_.answered) return;  // lost: once more
  if (datagram_.wkc > 0) {
    switch (what_) {
      case What::kPorts:
        take_ports(time);
        break;
      case What::kWatchdogs:
        take_watchdogs(time);
        break;
      case What::kEndStop:
        std::ranges::for_each(counters(*at_end_stop()), &CounterTotal::cleared);
        break;
      case What::kDlStatus:
        take_dl_status();
        break;
      case What::kSpeedCounter:
        take_speed_counter(time);
        break;
    }
  }
  move_on();
}

void EvidenceReader::take_ports(Nanoseconds time) {
  auto& evidence = snapshot_.slaves[slave_].evidence;
  auto& totals = totals_[slave_].ports;
  std::array<std::uint32_t, 20> more{};
  for (std::size_t i = 0; i < totals.size(); ++i) more[i] = totals[i].read(bytes_[i]);
  for (std::size_t port = 0; port < kPorts; ++port) {
    auto& errors = evidence.ports[port];
    const auto &invalid = totals[2 * port], &receive = totals[2 * port + 1], &forwarded = totals[kForwarded + port],
               &lost = totals[kLostLinks + port];
    errors = {invalid.total(), receive.total(), forwarded.total(), lost.total(),
              invalid.at_least() || receive.at_least() || forwarded.at_least() || lost.at_least()};
    tell_port(port, damaged_frames(more[2 * port], more[2 * port + 1]), more[kLostLinks + port], time);
  }
  const auto count_of = [time](const CounterTotal& total) {
    return EvidenceCount{total.total(), total.at_least(), time};
  };
  evidence.processing_unit_errors = count_of(totals[kProcessingUnit]);
  evidence.pdi_errors = count_of(totals[kPdi]);
  evidence.ports_time = time;
}

void EvidenceReader::tell_port(std::size_t port, std::uint32_t damaged, std::uint32_t lost_links, Nanoseconds time) {
  if (damaged == 0 && lost_links == 0) return;
  const auto since = snapshot_.slaves[slave_].evidence.ports_time;
  teller_.tell(time, static_cast<int>(slave_),
               events::PortErrors{static_cast<std::uint8_t>(port), damaged, lost_links, since});
}

void EvidenceReader::take_watchdogs(Nanoseconds time) {
  auto& evidence = snapshot_.slaves[slave_].evidence;
  auto& totals = totals_[slave_].watchdogs;
  const std::array<EvidenceCount*, 2> counts{&evidence.process_data_watchdog, &evidence.pdi_watchdog};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto more = totals[i].read(bytes_[i]);
    *counts[i] = {totals[i].total(), totals[i].at_least(), time};
    if (more == 0) continue;
    using Which = events::WatchdogExpired::Which;
    teller_.tell(time, static_cast<int>(slave_),
                 events::WatchdogExpired{i == 0 ? Which::kProcessData : Which::kPdi, more});
  }
}

/// ESC data sheet II, DL status: the watchdog is served again when the firmware works.
void EvidenceReader::take_dl_status() {
  constexpr std::uint16_t kPdiWatchdogServed = 0x0002;
  auto& evidence = snapshot_.slaves[slave_].evidence;
  evidence.pdi_silent = (load_le<std::uint16_t>(bytes_) & kPdiWatchdogServed) == 0;
}

void EvidenceReader::take_speed_counter(Nanoseconds time) {
  auto& evidence = snapshot_.slaves[slave_].evidence;
  evidence.speed_counter_difference = static_cast<std::int16_t>(load_le<std::uint16_t>(bytes_));
  evidence.speed_counter_time = time;
}

}  // namespace syncline
