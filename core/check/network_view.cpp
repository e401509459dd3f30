// SPDX-License-Identifier: Apache-2.0
#include "check/network_view.h"

#include <algorithm>
#include <map>

#include "config/init_cmd.h"
#include "config/network_config.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

constexpr unsigned kMaxUnits = 16;  // FMMUs or SyncManagers of an ESC

/// Calls `take` for each whole record of `size` bytes that the command writes into an array of registers at `base`.
template <std::size_t kSize, class Take>
void for_each_record(const InitCmd& cmd, std::uint16_t base, Take take) {
  if (!writes(cmd.command) || is_logical(cmd.command) || cmd.ado < base || (cmd.ado - base) % kSize != 0) {
    return;
  }
  const unsigned first = (cmd.ado - base) / kSize;
  for (unsigned i = 0; first + i < kMaxUnits && (i + 1) * kSize <= cmd.length(); ++i) {
    std::array<std::uint8_t, kSize> bytes{};
    if (!cmd.data_length) {
      std::copy_n(cmd.data.begin() + i * kSize, kSize, bytes.begin());
    }
    take(first + i, std::span<const std::uint8_t, kSize>(bytes));
  }
}

/// Start bits, type and activation use a part of their bytes, the last three none.
bool has_reserved_bits(std::span<const std::uint8_t, Fmmu::kSize> bytes) {
  constexpr std::array<std::uint8_t, Fmmu::kSize> kUsed = {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x07, 0x07,
                                                           0xFF, 0xFF, 0x07, 0x03, 0x01, 0x00, 0x00, 0x00};
  return !std::ranges::equal(bytes, kUsed, [](std::uint8_t byte, std::uint8_t used) { return (byte & ~used) == 0; });
}

SlaveRegisters read_registers(const SlaveConfig& slave) {
  std::map<unsigned, FmmuWrite> fmmus;
  std::map<unsigned, SyncManagerWrite> managers;
  for (const Transition transition : {Transition::kIP, Transition::kPS, Transition::kSO}) {
    for (std::size_t i = 0; i < slave.init_cmds.size(); ++i) {
      const InitCmd& cmd = slave.init_cmds[i];
      if (!has_transition(cmd, transition)) {
        continue;
      }
      for_each_record<Fmmu::kSize>(cmd, reg::kFmmu, [&](unsigned number, auto bytes) {
        fmmus[number] = {i, number, Fmmu::decode(bytes), has_reserved_bits(bytes)};
      });
      for_each_record<SyncManager::kSize>(cmd, reg::kSyncManager, [&](unsigned number, auto bytes) {
        managers[number] = {i, number, SyncManager::decode(bytes)};
      });
    }
  }
  SlaveRegisters out;
  for (const auto& [number, write] : fmmus) {
    if (write.fmmu.active) out.fmmus.push_back(write);
    // Tools write an FMMU without data inactive, with its direction and no length.
    else if (write.fmmu.length != 0)
      out.idle_fmmus.push_back(write);
  }
  for (const auto& [number, write] : managers) {
    if (write.manager.enabled()) out.managers.push_back(write);
  }
  return out;
}

}  // namespace

const SyncManagerWrite* SlaveRegisters::manager(unsigned number) const {
  const auto found = std::ranges::find(managers, number, &SyncManagerWrite::number);
  return found == managers.end() ? nullptr : &*found;
}

NetworkView::NetworkView(const NetworkConfig& network) : config(network) {
  for (std::size_t i = 0; i < network.slaves.size(); ++i) {
    registers.push_back(read_registers(network.slaves[i]));
    by_address_.emplace(network.slaves[i].station_address, i);
  }
  for (std::size_t t = 0; t < network.cyclic.size(); ++t) {
    for (std::size_t f = 0; f < network.cyclic[t].frames.size(); ++f) {
      const auto& commands = network.cyclic[t].frames[f].commands;
      for (std::size_t c = 0; c < commands.size(); ++c) {
        cyclic.push_back({&commands[c], t, f, c});
        const Command command = commands[c].command;
        if (!drift_compensation && commands[c].ado == reg::kSystemTime &&
            (command == Command::kArmw || command == Command::kFrmw)) {
          drift_compensation = cyclic.back();
        }
      }
    }
  }
}

std::optional<std::size_t> NetworkView::with_address(std::uint16_t station_address) const {
  const auto found = by_address_.find(station_address);
  return found == by_address_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> NetworkView::addressee(Command command, std::uint16_t adp) const {
  if (is_fixed_address(command)) {
    return with_address(adp);
  }
  const std::size_t position = static_cast<std::uint16_t>(0U - adp);
  return is_auto_increment(command) && position < config.slaves.size() ? std::optional(position) : std::nullopt;
}

std::uint16_t NetworkView::assign_activate(std::size_t slave) const {
  std::uint16_t value = 0;
  for (const InitCmd& cmd : config.slaves[slave].init_cmds) {
    if (!has_transition(cmd, Transition::kPS)) continue;
    if (const auto written = written_number(cmd, reg::kCyclicUnitControl, 2)) {
      value = static_cast<std::uint16_t>(*written);
    }
  }
  return value;
}

bool has(const CyclicCmd& cmd, AlState state) { return std::ranges::find(cmd.states, state) != cmd.states.end(); }

bool writes_register(const InitCmd& cmd, std::uint16_t ado) {
  return writes(cmd.command) && !is_logical(cmd.command) && cmd.ado <= ado && ado < cmd.ado + cmd.length();
}

std::optional<std::uint32_t> written_number(const InitCmd& cmd, std::uint16_t ado, std::size_t bytes) {
  if (!writes_register(cmd, ado) || ado + bytes > std::size_t{cmd.ado} + cmd.length()) {
    return std::nullopt;
  }
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes && !cmd.data_length; ++i) {
    value |= std::uint32_t{cmd.data[ado - cmd.ado + i]} << (8 * i);
  }
  return value;
}

std::vector<Overlap> overlaps(const std::vector<OwnedRange>& ranges) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!ranges[i].range.empty()) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ranges[i].range.begin; });
  std::vector<Overlap> out;
  std::size_t farthest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Range& range = ranges[order[k]].range;
    if (k > 0 && ranges[farthest].range.end > range.begin) {
      out.push_back({farthest, order[k]});
    }
    if (k == 0 || range.end > ranges[farthest].range.end) {
      farthest = order[k];
    }
  }
  return out;
}

std::vector<Range> merged(std::vector<Range> ranges) {
  std::erase_if(ranges, [](const Range& range) { return range.empty(); });
  std::ranges::sort(ranges, {}, &Range::begin);
  std::vector<Range> out;
  for (const Range& range : ranges) {
    if (!out.empty() && range.begin <= out.back().end) {
      out.back().end = std::max(out.back().end, range.end);
    } else {
      out.push_back(range);
    }
  }
  return out;
}

bool covered(const Range& whole, const std::vector<Range>& pieces) {
  const auto behind = std::ranges::upper_bound(pieces, whole.begin, {}, &Range::begin);
  return behind != pieces.begin() && std::prev(behind)->contains(whole);
}

}  // namespace syncline::checker
