// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_compare.h"

#include <fmt/format.h>

#include "channels/values/bus_scan.h"
#include "check/network_view.h"
#include "compare/difference_list.h"
#include "compare/slave_pairing.h"
#include "config/network_config.h"
#include "master/exchange/bus.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

using comparison::DifferenceList;
using Group = DifferenceGroup;

bool runs(const ScannedSlave& slave) { return has_process_data_communication(al_state_of(slave.al_status)); }

class BusComparison {
 public:
  BusComparison(const NetworkConfig& config, const BusScan& scan,
                std::span<const std::optional<RunningRegisters>> running)
      : view_(config), config_(config), scan_(scan), running_(running) {
    std::vector<SlaveKey> wanted, found;
    for (const auto& slave : config.slaves) wanted.push_back({slave.identity, ""});
    for (const auto& slave : scan.slaves) found.push_back({slave.identity, ""});
    pairing_ = pair_slaves(wanted, found);
  }

  std::vector<ConfigDifference> run() {
    for (std::size_t l = 0; l < config_.slaves.size(); ++l) {
      if (pairing_.right_of[l]) {
        compare(l, *pairing_.right_of[l]);
      } else {
        DifferenceList(out_, l, std::nullopt, config_.slaves[l].name)
            .add(Group::kSlaves, "difference-device", to_string(config_.slaves[l].identity), "missing");
      }
    }
    for (std::size_t r = 0; r < scan_.slaves.size(); ++r) {
      if (pairing_.left_of[r]) continue;
      DifferenceList(out_, std::nullopt, r, "")
          .add(Group::kSlaves, "difference-device", "not configured", to_string(scan_.slaves[r].identity));
    }
    return std::move(out_);
  }

 private:
  void compare(std::size_t l, std::size_t r) {
    const SlaveConfig& wanted = config_.slaves[l];
    const ScannedSlave& found = scan_.slaves[r];
    DifferenceList out(out_, l, r, wanted.name);
    if (pairing_.moved[l]) out.add(Group::kSlaves, "difference-place", fmt::format("{}", l), fmt::format("{}", r));
    compare_identity(wanted, found, out);
    compare_wiring(l, found, out);
    if (wanted.dc && wanted.dc->cycle_time0 > 0 && found.dc == DcCapability::kNone) {
      out.add(Group::kClocks, "difference-distributed-clocks", "used", "the device has none");
    }
    if (found.sii) compare_mailbox(wanted, *found.sii, out);
    if (r < running_.size() && running_[r]) compare_registers(l, *running_[r], out);
  }

  static void compare_identity(const SlaveConfig& wanted, const ScannedSlave& found, DifferenceList& out) {
    const auto product = [](const Identity& id) {
      return fmt::format("0x{:08x}:0x{:08x}", id.vendor_id, id.product_code);
    };
    out.field(Group::kSlaves, "difference-device", product(wanted.identity), product(found.identity));
    out.field(Group::kSlaves, "difference-revision", fmt::format("0x{:08x}", wanted.identity.revision_no),
              fmt::format("0x{:08x}", found.identity.revision_no));
    if (wanted.identity.serial_no != 0) {
      out.number(Group::kSlaves, "difference-serial-number", wanted.identity.serial_no, found.identity.serial_no);
    }
    if (wanted.alias != 0) out.number(Group::kWiring, "difference-alias", wanted.alias, found.alias);
  }

  void compare_wiring(std::size_t l, const ScannedSlave& found, DifferenceList& out) const {
    const auto& wanted = config_.slaves[l].previous;
    // Members of hot-connect groups may be plugged in anywhere; a scan that only looks knows no wiring.
    if (!wanted || !found.previous || config_.hot_connect_head(l) || wanted->position >= pairing_.right_of.size())
      return;
    const auto behind = pairing_.right_of[wanted->position];
    if (wanted->port == found.previous->port && behind == std::optional<std::size_t>(found.previous->position)) return;
    const auto words = [](const PreviousPort& previous) {
      return fmt::format("port {} of slave {}", static_cast<char>('A' + previous.port), previous.position);
    };
    out.add(Group::kWiring, "difference-hangs-on", words(*wanted), words(*found.previous));
  }

  static void compare_mailbox(const SlaveConfig& wanted, const sii::Image& sii, DifferenceList& out) {
    if (wanted.mailbox && sii.mailbox_protocols == 0) {
      out.add(Group::kMailbox, "difference-mailbox", "used", "the device has none");
    }
  }

  void compare_registers(std::size_t l, const RunningRegisters& found, DifferenceList& out) const {
    for (std::size_t n = 0; n < RunningRegisters::kManagers; ++n) {
      const auto* write = view_.registers[l].manager(static_cast<unsigned>(n));
      const SyncManager& there = found.managers[n];
      const std::string wanted = write ? words(write->manager) : "off";
      const std::string is = there.enabled() ? words(there) : "off";
      if (wanted != is)
        out.add(Group::kProcessData, comparison::what("difference-sm", fig::number<"sm">(n)), wanted, is);
    }
    const auto& dc = config_.slaves[l].dc;
    const std::uint16_t activation = view_.assign_activate(l);
    out.field(Group::kClocks, "difference-activation", fmt::format("0x{:04x}", activation),
              fmt::format("0x{:04x}", found.activation));
    if (dc && activation != 0 && found.activation != 0) {
      out.time(Group::kClocks, "difference-sync0-cycle", dc->cycle_time0, found.cycle_time0);
      // A difference to SYNC0, kept as 32 bits.
      out.time(Group::kClocks, "difference-sync1-behind-sync0", static_cast<std::int32_t>(dc->cycle_time1),
               static_cast<std::int32_t>(found.cycle_time1));
    }
  }

  static std::string words(const SyncManager& manager) {
    return fmt::format("{} bytes at 0x{:04x}, control 0x{:02x}", manager.length, manager.start, manager.control);
  }

  checker::NetworkView view_;
  const NetworkConfig& config_;
  const BusScan& scan_;
  std::span<const std::optional<RunningRegisters>> running_;
  SlavePairing pairing_;
  std::vector<ConfigDifference> out_;
};

Result<RunningRegisters> read_registers(Bus& bus, std::uint16_t position) {
  const std::uint16_t address = Position{position}.auto_increment_address();
  std::array<std::uint8_t, RunningRegisters::kManagers * SyncManager::kSize> managers{};
  std::array<std::uint8_t, 8> cycles{};
  std::array<std::uint8_t, 2> activation{};
  const auto wkc = bus.exchange(Command::kAprd, address, reg::kSyncManager, managers);
  if (!wkc) return tl::unexpected(wkc.error());
  if (*wkc == 0) return fail(ErrorCode::kNoResponse, fmt::format("slave {}", position));
  // A device without clocks does not answer there: the zeros stay.
  for (const auto& [ado, bytes] :
       {std::pair<std::uint16_t, std::span<std::uint8_t>>{reg::kSync0CycleTime, cycles},
        std::pair<std::uint16_t, std::span<std::uint8_t>>{reg::kCyclicUnitControl, activation}}) {
    if (const auto answered = bus.exchange(Command::kAprd, address, ado, bytes); !answered) {
      return tl::unexpected(answered.error());
    }
  }
  RunningRegisters out;
  for (std::size_t n = 0; n < RunningRegisters::kManagers; ++n) {
    out.managers[n] = SyncManager::decode(
        std::span<const std::uint8_t>(managers).subspan(n * SyncManager::kSize).first<SyncManager::kSize>());
  }
  out.activation = load_le<std::uint16_t>(activation);
  out.cycle_time0 = load_le<std::uint32_t>(cycles);
  out.cycle_time1 = load_le<std::uint32_t>(std::span<const std::uint8_t>(cycles).subspan(4));
  return out;
}

}  // namespace

Result<std::vector<std::optional<RunningRegisters>>> read_running_registers(Bus& bus, const BusScan& scan) {
  std::vector<std::optional<RunningRegisters>> out(scan.slaves.size());
  for (std::size_t i = 0; i < scan.slaves.size(); ++i) {
    if (!runs(scan.slaves[i])) continue;
    auto found = read_registers(bus, scan.slaves[i].position);
    if (!found) return tl::unexpected(found.error());
    out[i] = *found;
  }
  return out;
}

std::vector<ConfigDifference> compare_with_bus(const NetworkConfig& config, const BusScan& scan,
                                               std::span<const std::optional<RunningRegisters>> running) {
  return BusComparison(config, scan, running).run();
}

}  // namespace syncline
