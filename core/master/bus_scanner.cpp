// SPDX-License-Identifier: Apache-2.0
#include "master/bus_scanner.h"

#include <fmt/format.h>

#include <array>

#include "master/sii_reader.h"
#include "master/topology.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr std::uint16_t kFeatureDc64Bit = 0x0008;

/// The same register of many stations in as few frames as possible.
template <std::size_t N>
struct RegisterOfAll {
  RegisterOfAll(std::span<const std::uint16_t> stations, std::uint16_t ado) : bytes(stations.size()) {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      datagrams.push_back({Command::kFprd, device_address(stations[i], ado), bytes[i]});
    }
  }
  template <std::unsigned_integral T>
  [[nodiscard]] T get(std::size_t slave, std::size_t offset = 0) const {
    return load_le<T>(std::span(bytes[slave]).subspan(offset));
  }
  [[nodiscard]] bool answered(std::size_t slave) const { return datagrams[slave].wkc != 0; }

  std::vector<std::array<std::uint8_t, N>> bytes;
  std::vector<Datagram> datagrams;
};

Status assign_addresses(Bus& bus, std::span<const std::uint16_t> stations) {
  // Without the alias enabled a slave listens to one address only.
  if (auto wkc = bus.write(Command::kBwr, 0, reg::kDlControlAlias, std::uint8_t{0}); !wkc) {
    return tl::unexpected(wkc.error());
  }
  if (auto wkc = bus.write(Command::kBwr, 0, reg::kStationAddress, std::uint16_t{0}); !wkc) {
    return tl::unexpected(wkc.error());
  }
  std::vector<std::array<std::uint8_t, 2>> bytes(stations.size());
  std::vector<Datagram> datagrams;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    store_le(bytes[i], stations[i]);
    const auto position = Position{static_cast<std::uint16_t>(i)};
    datagrams.push_back(
        {Command::kApwr, device_address(position.auto_increment_address(), reg::kStationAddress), bytes[i]});
  }
  return bus.transact(datagrams);
}

Status read_registers(Bus& bus, std::span<const std::uint16_t> stations, std::vector<ScannedSlave>& slaves) {
  RegisterOfAll<10> information(stations, reg::kType);
  RegisterOfAll<2> alias(stations, reg::kStationAlias);
  RegisterOfAll<2> dl_status(stations, reg::kDlStatus);
  RegisterOfAll<2> al_status(stations, reg::kAlStatus);
  for (auto* datagrams : {&information.datagrams, &alias.datagrams, &dl_status.datagrams, &al_status.datagrams}) {
    if (auto status = bus.transact(*datagrams); !status) return status;
  }
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!information.answered(i)) return fail(ErrorCode::kNoResponse, fmt::format("slave {}", i));
    auto& slave = slaves[i];
    slave.esc_type = information.get<std::uint8_t>(i);
    slave.fmmu_count = information.get<std::uint8_t>(i, reg::kFmmuCount);
    slave.sync_manager_count = information.get<std::uint8_t>(i, reg::kSyncManagerCount);
    slave.features = information.get<std::uint16_t>(i, reg::kFeatures);
    slave.alias = alias.get<std::uint16_t>(i);
    slave.dl_status.value = dl_status.get<std::uint16_t>(i);
    slave.al_status = al_status.get<std::uint16_t>(i);
  }
  return {};
}

void take_topology(std::vector<ScannedSlave>& slaves) {
  std::vector<DlStatus> status;
  for (const auto& slave : slaves) status.push_back(slave.dl_status);
  const auto previous = find_topology(status);
  for (std::size_t i = 0; i < slaves.size(); ++i) slaves[i].previous = previous[i];
}

void take_sii(ScannedSlave& slave, SiiContent content) {
  if (content.error) {
    slave.sii_error = std::move(content.error);
    slave.sii_error->subject = fmt::format("slave {}", slave.position);
    return;
  }
  auto image = sii::decode(content.bytes);
  if (!image) {
    slave.sii_error = image.error();
    if (slave.sii_error->subject.empty()) slave.sii_error->subject = fmt::format("slave {}", slave.position);
    return;
  }
  slave.identity = {image->vendor_id, image->product_code, image->revision_no, image->serial_no};
  slave.sii = std::move(*image);
}

}  // namespace

Result<std::uint16_t> count_slaves(Bus& bus) {
  // Twice: the first frame after power-on may be lost while PHYs settle.
  std::uint16_t count = 0;
  for (int round = 0; round < 2; ++round) {
    std::array<std::uint8_t, 1> type{};
    const auto wkc = bus.exchange(Command::kBrd, 0, reg::kType, type);
    if (!wkc) return wkc;
    count = *wkc;
  }
  return count;
}

Result<std::vector<DcCapability>> probe_dc(Bus& bus, std::span<const std::uint16_t> stations) {
  RegisterOfAll<2> features(stations, reg::kFeatures);
  RegisterOfAll<4> system_time(stations, reg::kSystemTime);
  RegisterOfAll<4> receive_time(stations, reg::kReceiveTimePort0);
  for (auto* datagrams : {&features.datagrams, &system_time.datagrams, &receive_time.datagrams}) {
    if (auto status = bus.transact(*datagrams); !status) return tl::unexpected(status.error());
  }
  std::vector<DcCapability> capabilities;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    auto capability = receive_time.answered(i) ? DcCapability::kReceiveTimesOnly : DcCapability::kNone;
    if (system_time.answered(i)) {
      const bool wide = (features.get<std::uint16_t>(i) & kFeatureDc64Bit) != 0;
      capability = wide ? DcCapability::kSystemTime64 : DcCapability::kSystemTime32;
    }
    capabilities.push_back(capability);
  }
  return capabilities;
}

Result<BusScan> scan_slaves(Bus& bus, const ScanProgress& progress) {
  const auto count = count_slaves(bus);
  if (!count) return tl::unexpected(count.error());
  if (*count == 0) return fail(ErrorCode::kNoResponse, bus.exchange().link().describe().name);
  if (progress) progress(0, *count);

  BusScan scan;
  std::vector<std::uint16_t> stations;
  for (std::uint16_t i = 0; i < *count; ++i) {
    stations.push_back(static_cast<std::uint16_t>(kFirstStationAddress + i));
    ScannedSlave slave;
    slave.position = i;
    slave.station_address = stations.back();
    scan.slaves.push_back(std::move(slave));
  }
  if (auto status = assign_addresses(bus, stations); !status) return tl::unexpected(status.error());
  if (auto status = read_registers(bus, stations, scan.slaves); !status) return tl::unexpected(status.error());
  take_topology(scan.slaves);
  const auto clocks = probe_dc(bus, stations);
  if (!clocks) return tl::unexpected(clocks.error());
  for (std::size_t i = 0; i < clocks->size(); ++i) scan.slaves[i].dc = (*clocks)[i];

  auto contents = read_sii(bus, stations, [&](std::size_t done) {
    if (progress) progress(done, *count);
  });
  if (!contents) return tl::unexpected(contents.error());
  for (std::size_t i = 0; i < contents->size(); ++i) take_sii(scan.slaves[i], std::move((*contents)[i]));
  return scan;
}

}  // namespace syncline
