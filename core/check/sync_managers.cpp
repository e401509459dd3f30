// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "check/network_view.h"
#include "config/network_config.h"
#include "config/slave_config.h"

namespace syncline::checker {
namespace {

constexpr std::uint16_t kProcessMemory = 0x1000;
constexpr unsigned kDigitalInputs = 4;
constexpr unsigned kBuffers = 3;  // of a SyncManager that buffers

bool is_output(SyncManagerType type) {
  return type == SyncManagerType::kOutputs || type == SyncManagerType::kMailboxOut;
}

/// Memory that a SyncManager occupies: three buffers in buffered mode, except for the registers of digital I/O (outputs
/// at 0x0F00, inputs at 0x1000 to 0x1003).
Range occupied(const SyncManager& manager) {
  const bool digital = manager.start + manager.length <= kProcessMemory + kDigitalInputs;
  const unsigned buffers = manager.is_mailbox() || digital ? 1 : kBuffers;
  return {manager.start, manager.start + std::uint64_t{manager.length} * buffers};
}

class SyncManagerCheck {
 public:
  SyncManagerCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : slave_(slave), config_(view.config.slaves[slave]), registers_(view.registers[slave]), findings_(findings) {
    for (const auto& pdo : config_.pdos) bits_of_pdo_.emplace(pdo.pdo.index, pdo.pdo.bit_length());
  }

  void run() {
    for (std::size_t m = 0; m < config_.sync_managers.size(); ++m) {
      const ConfiguredSyncManager& manager = config_.sync_managers[m];
      check_size_limits(m, manager);
      if (const SyncManagerWrite* write = registers_.manager(manager.number)) {
        check_write(m, manager, *write);
      } else if (manager.description.enable && assigned_bits(manager).value_or(0) > 0 && !config_.init_cmds.empty()) {
        findings_.add("ENI-SM-01", {PlaceKind::kSyncManager, slave_, m}, fig::number<"manager">(manager.number));
      }
    }
    check_memory();
    check_ranges(config_.send, SyncManagerType::kOutputs, "Send");
    check_ranges(config_.receive, SyncManagerType::kInputs, "Recv");
  }

 private:
  /// Bits of all assigned PDOs; nothing where one of them is not described.
  [[nodiscard]] std::optional<std::uint64_t> assigned_bits(const ConfiguredSyncManager& manager) const {
    std::uint64_t bits = 0;
    for (const std::uint16_t pdo : manager.pdos) {
      const auto found = bits_of_pdo_.find(pdo);
      if (found == bits_of_pdo_.end()) return std::nullopt;
      bits += found->second;
    }
    return bits;
  }

  void check_size_limits(std::size_t m, const ConfiguredSyncManager& manager) {
    const auto bits = assigned_bits(manager);
    const SyncManagerDescription& description = manager.description;
    if (!bits || *bits == 0) return;
    const std::uint64_t bytes = (*bits + 7) / 8;
    // A maximum of 0 is how tools write "no limit".
    if (bytes < description.min_size.value_or(0) ||
        (description.max_size.value_or(0) != 0 && bytes > *description.max_size)) {
      findings_.add("ENI-SM-02", {PlaceKind::kSyncManager, slave_, m}, fig::number<"manager">(manager.number),
                    fig::count<"bytes">(bytes), fig::count<"least">(description.min_size.value_or(0)),
                    fig::count<"most">(description.max_size.value_or(0)));
    }
  }

  void check_write(std::size_t m, const ConfiguredSyncManager& manager, const SyncManagerWrite& write) {
    const ConfigPlace place{PlaceKind::kSlaveInitCmd, slave_, write.cmd};
    const SyncManagerDescription& description = manager.description;
    if (write.manager.start != description.start_address) {
      findings_.add("ENI-SM-03", place, fig::number<"manager">(manager.number), fig::hex<"start">(write.manager.start),
                    fig::hex<"said">(description.start_address));
    }
    const bool process_data =
        description.type == SyncManagerType::kOutputs || description.type == SyncManagerType::kInputs;
    // Process data in one buffer (mailbox mode) are unusual, but several digital terminals have them.
    const bool wrong_mode = !process_data && !write.manager.is_mailbox();
    if (write.manager.ecat_writes() != is_output(description.type) || wrong_mode) {
      findings_.add("ENI-SM-04", place, fig::hex<"control">(write.manager.control, 2),
                    fig::number<"manager">(manager.number), fig::phrase<"kind">(kind(write.manager)),
                    fig::text<"type">(type_name(description.type)));
    }
    const auto bits = assigned_bits(manager);
    if (process_data && bits && !manager.pdos.empty() && write.manager.length != (*bits + 7) / 8) {
      findings_.add("ENI-SM-05", place, fig::number<"manager">(manager.number),
                    fig::count<"bytes">(write.manager.length), fig::count<"expected">((*bits + 7) / 8));
    }
    if (process_data && !description.enable && !manager.pdos.empty()) {
      findings_.add("ENI-SM-08", {PlaceKind::kSyncManager, slave_, m}, fig::number<"manager">(manager.number));
    }
  }

  /// Enabled SyncManagers lie in data memory and do not share it.
  void check_memory() {
    std::vector<OwnedRange> plain, buffers;
    for (std::size_t i = 0; i < registers_.managers.size(); ++i) {
      const SyncManagerWrite& write = registers_.managers[i];
      const Range bytes{write.manager.start, std::uint64_t{write.manager.start} + write.manager.length};
      plain.push_back({bytes, i});
      buffers.push_back({occupied(write.manager), i});
      if (write.manager.length == 0 || bytes.begin < kFirstDataAddress || occupied(write.manager).end > 0x10000) {
        findings_.add("ENI-SM-06", {PlaceKind::kSlaveInitCmd, slave_, write.cmd}, fig::number<"manager">(write.number),
                      fig::count<"bytes">(write.manager.length), fig::hex<"start">(write.manager.start));
      }
    }
    const auto found = overlaps(plain);
    for (const auto& [first, second] : found.empty() ? overlaps(buffers) : found) {
      const SyncManagerWrite& write = registers_.managers[second];
      const ConfigPlace place{PlaceKind::kSlaveInitCmd, slave_, write.cmd};
      const auto manager = fig::number<"manager">(write.number);
      const auto other = fig::number<"other">(registers_.managers[first].number);
      found.empty() ? findings_.add("ENI-SM-07/buffers", place, manager, other)
                    : findings_.add("ENI-SM-07", place, manager, other);
    }
  }

  /// Send and Recv have the bits of the PDOs that their SyncManagers carry.
  void check_ranges(const std::optional<ImageRange>& range, SyncManagerType type, const char* name) {
    if (config_.pdos.empty()) return;  // a file without descriptions of PDOs
    std::uint64_t bits = 0;
    for (const auto& manager : config_.sync_managers) {
      if (manager.description.type != type) continue;
      const auto assigned = assigned_bits(manager);
      if (!assigned) return;
      bits += *assigned;
    }
    const std::uint64_t said = range ? range->bit_length : 0;
    // Byte-oriented slaves take whole bytes of the image.
    if (said != bits && said != (bits + 7) / 8 * 8) {
      findings_.add("ENI-SM-09", {PlaceKind::kSlave, slave_}, fig::text<"element">(name), fig::count<"bits">(said),
                    fig::count<"expected">(bits));
    }
  }

  static const char* kind(const SyncManager& manager) {
    if (manager.is_mailbox()) return manager.ecat_writes() ? "a mailbox for requests" : "a mailbox for answers";
    return manager.ecat_writes() ? "a buffer for outputs" : "a buffer for inputs";
  }
  static std::string type_name(SyncManagerType type) {
    const auto word = sync_manager_word(type);
    return std::string(word.empty() ? "nothing" : word);
  }

  std::size_t slave_;
  const SlaveConfig& config_;
  const SlaveRegisters& registers_;
  Findings& findings_;
  std::unordered_map<std::uint16_t, std::uint32_t> bits_of_pdo_;
};

}  // namespace

void check_sync_managers(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    SyncManagerCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
