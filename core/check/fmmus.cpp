// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "check/network_view.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

bool maps_process_data(const Fmmu& fmmu) { return fmmu.physical_start >= kFirstDataAddress; }

/// Logical bytes that cyclic commands of one direction carry in a state.
std::vector<Range> carried(const NetworkView& view, bool inputs, AlState state) {
  std::vector<Range> ranges;
  for (const CyclicPlace& cyclic : view.cyclic) {
    const Command command = cyclic.cmd->command;
    if (has(*cyclic.cmd, state) && (command == Command::kLrw || command == (inputs ? Command::kLrd : Command::kLwr))) {
      ranges.push_back(logical_bytes(*cyclic.cmd));
    }
  }
  return merged(std::move(ranges));
}

class FmmuCheck {
 public:
  FmmuCheck(const NetworkView& view, Findings& findings)
      : view_(view),
        findings_(findings),
        inputs_safeop_(carried(view, true, AlState::kSafeop)),
        inputs_op_(carried(view, true, AlState::kOp)),
        outputs_op_(carried(view, false, AlState::kOp)) {}

  void run() {
    for (std::size_t i = 0; i < view_.config.slaves.size(); ++i) {
      for (const FmmuWrite& write : view_.registers[i].fmmus) {
        check(i, write);
      }
      for (const FmmuWrite& write : view_.registers[i].idle_fmmus) {
        add("ENI-FMMU-01/idle", i, write, fig::count<"bytes">(write.fmmu.length),
            fig::hex<"logical">(write.fmmu.logical_start, 8));
      }
    }
    check_shared();
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<"fmmu", kNames...> code, std::size_t slave, const FmmuWrite& write, Named<kNames>... figures) {
    findings_.add<"fmmu", kNames...>(code, {PlaceKind::kSlaveInitCmd, slave, write.cmd},
                                     fig::number<"fmmu">(write.number), std::move(figures)...);
  }

  void check(std::size_t slave, const FmmuWrite& write) {
    const Fmmu& fmmu = write.fmmu;
    if (fmmu.bit_length() == 0 || (!fmmu.read && !fmmu.write) || logical_bytes(fmmu).end > std::uint64_t{1} << 32) {
      return add(
          "ENI-FMMU-01", slave, write, fig::count<"bytes">(fmmu.length),
          fig::number<"first_bit">(fmmu.logical_start_bit), fig::number<"last_bit">(fmmu.logical_stop_bit),
          fig::hex<"logical">(fmmu.logical_start, 8),
          fig::phrase<"activity">(fmmu.read || fmmu.write ? "active" : "active for neither reading nor writing"));
    }
    if (write.reserved_bits) {
      add("ENI-FMMU-01/reserved", slave, write);
    }
    check_carried(slave, write);
    if (maps_process_data(fmmu)) {
      check_memory(slave, write);
    }
  }

  void check_carried(std::size_t slave, const FmmuWrite& write) {
    const Range bytes = logical_bytes(write.fmmu);
    const auto first = fig::hex<"first">(bytes.begin, 8);
    const auto last = fig::hex<"last">(bytes.end - 1, 8);
    if (write.fmmu.read && !covered(bytes, inputs_op_)) {
      add("ENI-FMMU-02", slave, write, first, last);
    } else if (write.fmmu.read && !covered(bytes, inputs_safeop_)) {
      add("ENI-FMMU-03", slave, write, first, last);
    }
    if (write.fmmu.write && !covered(bytes, outputs_op_)) {
      add("ENI-FMMU-02/outputs", slave, write, first, last);
    }
  }

  /// The mapped memory is a SyncManager's buffer in the right direction, and all of it.
  void check_memory(std::size_t slave, const FmmuWrite& write) {
    const Fmmu& fmmu = write.fmmu;
    const std::uint32_t bits = fmmu.physical_start_bit + fmmu.bit_length();
    const Range memory{fmmu.physical_start, std::uint64_t{fmmu.physical_start} + (bits + 7) / 8};
    const auto& managers = view_.registers[slave].managers;
    const auto touched = std::ranges::find_if(managers, [&](const SyncManagerWrite& manager) {
      return memory.overlaps({manager.manager.start, std::uint64_t{manager.manager.start} + manager.manager.length});
    });
    if (touched == managers.end()) {
      if (is_described(slave, memory)) return;  // that the SyncManager is off is said where it is described
      add("ENI-FMMU-04", slave, write, fig::hex<"first">(memory.begin), fig::hex<"last">(memory.end - 1));
      return;
    }
    const SyncManager& manager = touched->manager;
    const Range buffer = with_neighbours(slave, manager);
    if (contradicts_itself(slave, *touched)) return;
    if (manager.is_mailbox() || manager.ecat_writes() != fmmu.write) {
      add("ENI-FMMU-05", slave, write, fig::phrase<"does">(fmmu.write ? "writes" : "reads"),
          fig::number<"manager">(touched->number),
          fig::phrase<"kind">(manager.is_mailbox()    ? "a mailbox"
                              : manager.ecat_writes() ? "for outputs"
                                                      : "for inputs"));
    } else if (memory != buffer) {
      add("ENI-FMMU-06", slave, write, fig::hex<"first">(memory.begin), fig::hex<"last">(memory.end - 1),
          fig::number<"manager">(touched->number), fig::hex<"begin">(buffer.begin), fig::hex<"end">(buffer.end - 1));
    }
  }

  /// A SyncManager's memory, and that of those in the same direction that begin where it ends: one FMMU may map them
  /// all.
  [[nodiscard]] Range with_neighbours(std::size_t slave, const SyncManager& first) const {
    Range memory{first.start, std::uint64_t{first.start} + first.length};
    for (const SyncManagerWrite& write : view_.registers[slave].managers) {
      const SyncManager& next = write.manager;
      const bool joins = !next.is_mailbox() && next.ecat_writes() == first.ecat_writes() && next.start == memory.end;
      if (joins && maps_beyond(slave, memory)) memory.end += next.length;
    }
    return memory;
  }

  /// Some FMMU of the slave begins with that memory and goes on behind it.
  [[nodiscard]] bool maps_beyond(std::size_t slave, const Range& memory) const {
    return std::ranges::any_of(view_.registers[slave].fmmus, [&](const FmmuWrite& write) {
      const std::uint32_t bits = write.fmmu.physical_start_bit + write.fmmu.bit_length();
      return write.fmmu.physical_start == memory.begin && memory.begin + (bits + 7) / 8 > memory.end;
    });
  }

  [[nodiscard]] bool is_described(std::size_t slave, const Range& memory) const {
    return std::ranges::any_of(view_.config.slaves[slave].sync_managers, [&](const ConfiguredSyncManager& manager) {
      return manager.description.start_address == memory.begin;
    });
  }

  /// The control byte says another direction than the SyncManager's element: that is the mistake, not the FMMU.
  [[nodiscard]] bool contradicts_itself(std::size_t slave, const SyncManagerWrite& write) const {
    const auto& managers = view_.config.slaves[slave].sync_managers;
    const auto manager = std::ranges::find(managers, write.number, &ConfiguredSyncManager::number);
    if (manager == managers.end()) return false;
    const SyncManagerType type = manager->description.type;
    return type == SyncManagerType::kOutputs  ? write.manager.is_mailbox() || !write.manager.ecat_writes()
           : type == SyncManagerType::kInputs ? write.manager.is_mailbox() || write.manager.ecat_writes()
                                              : false;
  }

  struct Mapping {
    std::size_t slave = 0;
    const FmmuWrite* write = nullptr;
  };

  void collect(std::vector<OwnedRange>& ranges, std::vector<Mapping>& mappings, bool inputs) const {
    for (std::size_t i = 0; i < view_.config.slaves.size(); ++i) {
      for (const FmmuWrite& write : view_.registers[i].fmmus) {
        if (inputs ? write.fmmu.read : write.fmmu.write) {
          ranges.push_back({logical_bits(write.fmmu), mappings.size()});
          mappings.push_back({i, &write});
        }
      }
    }
  }

  /// No two slaves give the same input bits, or take the same output bits.
  void check_shared() {
    for (const bool inputs : {true, false}) {
      std::vector<OwnedRange> ranges;
      std::vector<Mapping> mappings;
      collect(ranges, mappings, inputs);
      for (const auto& [first, second] : overlaps(ranges)) {
        const Mapping& mapping = mappings[second];
        const auto number = fig::number<"number">(mappings[first].write->number);
        const auto other = view_.slave<"other">(mappings[first].slave);
        inputs ? add("ENI-FMMU-07", mapping.slave, *mapping.write, number, other)
               : add("ENI-FMMU-08", mapping.slave, *mapping.write, number, other);
      }
    }
  }

  const NetworkView& view_;
  Findings& findings_;
  std::vector<Range> inputs_safeop_, inputs_op_, outputs_op_;
};

/// Process data that a SyncManager has and no FMMU maps.
void check_unmapped(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const SlaveConfig& slave = view.config.slaves[i];
    for (std::size_t m = 0; m < slave.sync_managers.size(); ++m) {
      const SyncManagerWrite* write = view.registers[i].manager(slave.sync_managers[m].number);
      if (write == nullptr || write->manager.is_mailbox() || write->manager.length == 0) continue;
      const Range buffer{write->manager.start, std::uint64_t{write->manager.start} + write->manager.length};
      const bool mapped = std::ranges::any_of(view.registers[i].fmmus, [&](const FmmuWrite& fmmu) {
        return buffer.overlaps(
            {fmmu.fmmu.physical_start, std::uint64_t{fmmu.fmmu.physical_start} +
                                           (fmmu.fmmu.physical_start_bit + fmmu.fmmu.bit_length() + 7) / 8});
      });
      if (!mapped) {
        findings.add("ENI-FMMU-09", {PlaceKind::kSyncManager, i, m}, fig::number<"manager">(write->number),
                     fig::count<"bytes">(write->manager.length));
      }
    }
  }
}

}  // namespace

void check_fmmus(const NetworkView& view, Findings& findings) {
  FmmuCheck(view, findings).run();
  check_unmapped(view, findings);
}

}  // namespace syncline::checker
