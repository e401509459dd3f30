// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "master/exchange/bus.h"
#include "master/exchange/slave_address.h"
#include "master/scan/device_id.h"
#include "master/scan/scan_findings.h"
#include "master/scan/topology.h"
#include "master/sii/sii_access.h"
#include "master/sii/sii_reader.h"
#include "protocol/al_state.h"
#include "protocol/registers.h"
#include "protocol/station_address.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kFeatureDc64Bit = 0x0008;
constexpr std::size_t kInformationBytes = 0x14;  // 0x0000 to the station alias
constexpr std::size_t kReceiveTimeBytes = 16;
/// Receive times of one frame lie nearer together than this on every bus; others are left from long ago.
constexpr std::uint32_t kOneRoundTrip = 10'000'000;

std::string subject_of(std::size_t position) { return fmt::format("slave {}", position); }

/// One register of every slave.
template <std::size_t N>
class RegisterOfAll {
 public:
  RegisterOfAll(std::span<const SlaveAddress> slaves, std::uint16_t ado, std::vector<Datagram>& datagrams)
      : bytes_(slaves.size()), all_(datagrams), first_(datagrams.size()) {
    for (std::size_t i = 0; i < slaves.size(); ++i) datagrams.push_back(slaves[i].read(ado, bytes_[i]));
  }
  template <class T>
  [[nodiscard]] T get(std::size_t slave, std::size_t offset = 0) const {
    return load_le<T>(std::span(bytes_[slave]).subspan(offset));
  }
  [[nodiscard]] std::span<const std::uint8_t, N> bytes(std::size_t slave) const { return bytes_[slave]; }
  [[nodiscard]] bool answered(std::size_t slave) const { return all_[first_ + slave].wkc != 0; }

 private:
  std::vector<std::array<std::uint8_t, N>> bytes_;
  const std::vector<Datagram>& all_;
  std::size_t first_;
};

DcCapability capability_of(bool receive_times, bool system_time, std::uint16_t features) {
  if (!system_time) return receive_times ? DcCapability::kReceiveTimesOnly : DcCapability::kNone;
  return (features & kFeatureDc64Bit) != 0 ? DcCapability::kSystemTime64 : DcCapability::kSystemTime32;
}

class Scanner {
 public:
  Scanner(Bus& bus, const ScanOptions& options, const ScanObserver& observer)
      : bus_(bus), options_(options), observer_(observer) {}

  Result<BusScan> run() {
    const auto count = count_slaves(bus_);
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) return fail(ErrorCode::kNoResponse, bus_.exchange().link().describe().name);
    begin(*count);
    SiiAccess access(bus_, addresses_, {.take_ownership = !options_.look_only, .broadcast = !options_.look_only});
    auto status = look(access);
    if (status) status = touch(access);
    if (status) status = read_wiring();
    if (status) status = read_siis(access);
    if (status) status = rescue_identities(access);
    if (status) status = read_device_ids(bus_, addresses_, may_write(), scan_.slaves);
    if (status) status = check_still(*count);
    if (!status) return tl::unexpected(status.error());
    add_scan_findings(wiring_, scan_);
    return std::move(scan_);
  }

 private:
  /// Nothing runs that a write could disturb, and writing is allowed.
  [[nodiscard]] bool may_write() const { return !options_.look_only && scan_.running == 0; }

  void begin(std::size_t count) {
    if (observer_.progress) observer_.progress(0, count);
    scan_.look_only = options_.look_only;
    scan_.slaves.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      scan_.slaves[i].position = static_cast<std::uint16_t>(i);
      addresses_.push_back(SlaveAddress::at_position(static_cast<std::uint16_t>(i)));
    }
  }

  Status look(SiiAccess& access) {
    std::vector<Datagram> datagrams;
    RegisterOfAll<kInformationBytes> information(addresses_, reg::kType, datagrams);
    RegisterOfAll<2> dl_status(addresses_, reg::kDlStatus, datagrams);
    RegisterOfAll<6> al_status(addresses_, reg::kAlStatus, datagrams);
    RegisterOfAll<4> system_time(addresses_, reg::kSystemTime, datagrams);
    RegisterOfAll<SiiAccess::kLookBytes> eeprom(addresses_, reg::kSiiConfiguration, datagrams);
    if (auto status = bus_.transact(datagrams); !status) return status;
    std::vector<std::size_t> without_state;
    for (std::size_t i = 0; i < scan_.slaves.size(); ++i) {
      // Some ESCs and recordings do not have the whole block; what is missing of it reads as zero.
      if (!information.answered(i) && !dl_status.answered(i) && !eeprom.answered(i)) {
        return fail(ErrorCode::kNoResponse, subject_of(i));
      }
      auto& slave = scan_.slaves[i];
      slave.esc_type = information.get<std::uint8_t>(i);
      slave.fmmu_count = information.get<std::uint8_t>(i, reg::kFmmuCount);
      slave.sync_manager_count = information.get<std::uint8_t>(i, reg::kSyncManagerCount);
      slave.features = information.get<std::uint16_t>(i, reg::kFeatures);
      slave.station_address = information.get<std::uint16_t>(i, reg::kStationAddress);
      slave.alias = information.get<std::uint16_t>(i, reg::kStationAlias);
      slave.dl_status.value = dl_status.get<std::uint16_t>(i);
      slave.al_status = al_status.get<std::uint16_t>(i);
      slave.al_status_code = al_status.get<std::uint16_t>(i, reg::kAlStatusCode - reg::kAlStatus);
      slave.dc = capability_of(false, system_time.answered(i), slave.features);
      if (!al_status.answered(i)) without_state.push_back(i);
      access.set_found(i, eeprom.bytes(i));
    }
    if (auto status = read_states(without_state); !status) return status;
    scan_.running = static_cast<std::size_t>(std::ranges::count_if(scan_.slaves, [](const auto& slave) {
      const auto state = al_state_of(slave.al_status);
      return state != AlState::kNone && state != AlState::kInit;
    }));
    return {};
  }

  /// The state alone, where it cannot be read together with the AL status code.
  Status read_states(std::span<const std::size_t> whom) {
    std::vector<std::array<std::uint8_t, 2>> bytes(whom.size());
    std::vector<Datagram> reads;
    for (std::size_t n = 0; n < whom.size(); ++n) reads.push_back(addresses_[whom[n]].read(reg::kAlStatus, bytes[n]));
    if (auto status = bus_.transact(reads); !status) return status;
    for (std::size_t n = 0; n < whom.size(); ++n) scan_.slaves[whom[n]].al_status = load_le<std::uint16_t>(bytes[n]);
    return {};
  }

  /// The writes of a scan, as far as they are allowed.
  Status touch(const SiiAccess& access) {
    if (options_.look_only) return {};
    if (scan_.running > 0) {
      std::size_t eeproms = 0;
      for (std::size_t i = 0; i < access.size(); ++i) eeproms += access.was_assigned_to_pdi(i) ? 1 : 0;
      if (observer_.touching) observer_.touching(scan_.running, eeproms);
    } else if (auto status = assign_addresses(); !status) {
      return status;
    }
    std::array<std::uint8_t, 4> zeros{};
    Datagram latch{Command::kBwr, device_address(0, reg::kReceiveTimePort0), zeros};
    return bus_.transact(latch);
  }

  Status assign_addresses() {
    std::vector<std::array<std::uint8_t, 2>> bytes(addresses_.size());
    std::vector<Datagram> writes;
    // Without the alias enabled a slave listens to one address only.
    std::array<std::uint8_t, 1> no_alias{};
    writes.push_back({Command::kBwr, device_address(0, reg::kDlControlAlias), no_alias});
    for (std::size_t i = 0; i < addresses_.size(); ++i) {
      auto& slave = scan_.slaves[i];
      slave.station_address = usual_station_address(i);
      store_le(bytes[i], slave.station_address);
      writes.push_back(addresses_[i].write(reg::kStationAddress, bytes[i]));
    }
    return bus_.transact(writes);
  }

  Status read_wiring() {
    std::vector<Datagram> datagrams;
    RegisterOfAll<kReceiveTimeBytes> times(addresses_, reg::kReceiveTimePort0, datagrams);
    if (auto status = bus_.transact(datagrams); !status) return status;
    std::vector<PortReport> reports;
    for (std::size_t i = 0; i < scan_.slaves.size(); ++i) {
      auto& slave = scan_.slaves[i];
      PortReport report{slave.dl_status, {}};
      if (times.answered(i)) {
        if (slave.dc == DcCapability::kNone) slave.dc = DcCapability::kReceiveTimesOnly;
        std::array<std::uint32_t, kPortCount> values{};
        for (std::size_t port = 0; port < kPortCount; ++port)
          values[port] = times.template get<std::uint32_t>(i, 4 * port);
        if (plausible(slave.dl_status, values)) report.receive_times = values;
      }
      reports.push_back(report);
    }
    wiring_ = find_wiring(reports);
    for (std::size_t i = 0; i < wiring_.size(); ++i) {
      scan_.slaves[i].previous = wiring_[i].previous;
      scan_.slaves[i].entry_port = wiring_[i].entry_port;
    }
    return {};
  }

  /// Times that were not latched just now may be from different frames, or from none.
  static bool plausible(const DlStatus& status, const std::array<std::uint32_t, kPortCount>& times) {
    std::optional<unsigned> first;
    for (unsigned port = 0; port < kPortCount; ++port) {
      if (!status.active(port)) continue;
      if (!first) first = port;
      const auto ahead = times[port] - times[*first], behind = times[*first] - times[port];
      if (std::min(ahead, behind) > kOneRoundTrip) return false;
      if (port != *first && times[port] == times[*first]) return false;  // never latched
    }
    return true;
  }

  Status read_siis(SiiAccess& access) {
    const auto count = scan_.slaves.size();
    auto contents = read_sii(access, {.share_kinds = options_.share_kinds}, [&](std::size_t done) {
      if (observer_.progress) observer_.progress(done, count);
    });
    if (!contents) return tl::unexpected(contents.error());
    for (std::size_t i = 0; i < count; ++i) take_sii(scan_.slaves[i], std::move((*contents)[i]));
    if (observer_.progress) observer_.progress(count, count);
    return {};
  }

  /// Who a slave is can often still be read when the rest of its EEPROM cannot (damaged categories, a recording
  /// that holds only what its master asked for).
  Status rescue_identities(SiiAccess& access) {
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < scan_.slaves.size(); ++i) {
      if (scan_.slaves[i].sii_error && access.accessible(i)) unknown.push_back(i);
    }
    // Each pair of words by itself where the ESC reads two at a time: the serial number is not always there.
    constexpr std::uint32_t kVendorAndProduct = sii::kVendorIdWord, kProductAndRevision = sii::kVendorIdWord + 2,
                            kRevisionAndSerial = sii::kVendorIdWord + 4;
    for (const auto word : {kVendorAndProduct, kProductAndRevision, kRevisionAndSerial}) {
      std::vector<SiiRequest> requests;
      for (const auto slave : unknown) requests.push_back({slave, word, {}, {}});
      if (requests.empty()) break;
      if (auto status = access.open(); !status) return status;
      auto status = access.read(requests);
      if (auto closed = access.close(); status) status = closed;
      if (!status) return status;
      for (const auto& request : requests) {
        if (!request.error) take_identity(scan_.slaves[request.slave].identity, word, request.data);
      }
    }
    return {};
  }

  static void take_identity(Identity& identity, std::uint32_t word, std::span<const std::uint8_t> data) {
    std::uint32_t* const fields[] = {&identity.vendor_id, &identity.product_code, &identity.revision_no,
                                     &identity.serial_no};
    const auto first = (word - sii::kVendorIdWord) / 2;
    *fields[first] = load_le<std::uint32_t>(data);
    *fields[first + 1] = load_le<std::uint32_t>(data.subspan(4));
  }

  static void take_sii(ScannedSlave& slave, SiiContent content) {
    if (content.error) {
      slave.sii_error = std::move(content.error);
      slave.sii_error->subject = subject_of(slave.position);
      return;
    }
    auto image = sii::decode(content.bytes);
    if (!image) {
      slave.sii_error = image.error();
      slave.sii_error->subject = subject_of(slave.position);
      return;
    }
    slave.identity = {image->vendor_id, image->product_code, image->revision_no, image->serial_no};
    slave.sii = std::move(*image);
    if (content.shared_with) slave.sii_shared_with = static_cast<std::uint16_t>(*content.shared_with);
  }

  /// Places are addresses here: a slave that comes or goes meanwhile would shift the others.
  Status check_still(std::uint16_t before) {
    std::array<std::uint8_t, 1> type{};
    const auto now = bus_.exchange(Command::kBrd, 0, reg::kType, type);
    if (!now) return tl::unexpected(now.error());
    if (*now == before) return {};
    return fail({.code = ErrorCode::kSlaveCount, .expected = before, .received = *now});
  }

  Bus& bus_;
  const ScanOptions& options_;
  const ScanObserver& observer_;
  std::vector<SlaveAddress> addresses_;
  std::vector<SlaveWiring> wiring_;
  BusScan scan_;
};

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
  std::vector<SlaveAddress> slaves;
  for (const auto station : stations) slaves.push_back(SlaveAddress::at_station(station));
  return probe_dc(bus, slaves);
}

Result<std::vector<DcCapability>> probe_dc(Bus& bus, std::span<const SlaveAddress> slaves) {
  std::vector<Datagram> datagrams;
  RegisterOfAll<2> features(slaves, reg::kFeatures, datagrams);
  RegisterOfAll<4> system_time(slaves, reg::kSystemTime, datagrams);
  RegisterOfAll<4> receive_time(slaves, reg::kReceiveTimePort0, datagrams);
  if (auto status = bus.transact(datagrams); !status) return tl::unexpected(status.error());
  std::vector<DcCapability> capabilities;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    capabilities.push_back(
        capability_of(receive_time.answered(i), system_time.answered(i), features.get<std::uint16_t>(i)));
  }
  return capabilities;
}

Result<BusScan> scan_slaves(Bus& bus, const ScanOptions& options, const ScanObserver& observer) {
  return Scanner(bus, options, observer).run();
}

}  // namespace syncline
