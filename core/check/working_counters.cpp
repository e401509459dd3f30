// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/master_config.h"
#include "config/network_config.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

struct Mapping {
  Range logical;
  std::size_t slave = 0;
};

/// FMMUs of one direction, to be asked which slaves a range of logical bytes concerns.
class Mappings {
 public:
  Mappings(const NetworkView& view, bool inputs) {
    for (std::size_t i = 0; i < view.registers.size(); ++i) {
      for (const FmmuWrite& write : view.registers[i].fmmus) {
        if (inputs ? write.fmmu.read : write.fmmu.write) mappings_.push_back({logical_bytes(write.fmmu), i});
      }
    }
    std::ranges::stable_sort(mappings_, {}, [](const Mapping& mapping) { return mapping.logical.begin; });
    for (const Mapping& mapping : mappings_) longest_ = std::max(longest_, mapping.logical.end - mapping.logical.begin);
  }

  [[nodiscard]] std::size_t slaves_in(const Range& bytes) const {
    const std::uint64_t earliest = bytes.begin > longest_ ? bytes.begin - longest_ : 0;
    auto it =
        std::ranges::lower_bound(mappings_, earliest, {}, [](const Mapping& mapping) { return mapping.logical.begin; });
    std::vector<std::size_t> slaves;
    for (; it != mappings_.end() && it->logical.begin < bytes.end; ++it) {
      if (it->logical.overlaps(bytes)) slaves.push_back(it->slave);
    }
    std::ranges::sort(slaves);
    // Not std::ranges::unique: clang 14 cannot compile what libstdc++ 12 makes of it.
    return static_cast<std::size_t>(std::unique(slaves.begin(), slaves.end()) - slaves.begin());
  }

 private:
  std::vector<Mapping> mappings_;
  std::uint64_t longest_ = 0;
};

/// Slaves that are always there.
std::size_t fixed_slaves(const NetworkConfig& config) {
  std::size_t fixed = 0;
  std::size_t group_end = 0;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (config.slaves[i].hot_connect) group_end = i + config.slaves[i].hot_connect->member_count;
    if (i >= group_end) ++fixed;
  }
  return fixed;
}

class CounterCheck {
 public:
  CounterCheck(const NetworkView& view, Findings& findings)
      : view_(view),
        findings_(findings),
        inputs_(view, true),
        outputs_(view, false),
        fixed_(fixed_slaves(view.config)) {}

  void run() {
    for (const CyclicPlace& cyclic : view_.cyclic) {
      if (is_logical(cyclic.cmd->command)) {
        check_logical(cyclic);
      } else if (is_broadcast(cyclic.cmd->command)) {
        check_broadcast(cyclic);
      } else if (const auto& count = cyclic.cmd->expected_wkc) {
        check_single(cyclic.place(), cyclic.cmd->command, *count);
      }
    }
    for (std::size_t i = 0; i < view_.config.slaves.size(); ++i) {
      const auto& commands = view_.config.slaves[i].init_cmds;
      for (std::size_t c = 0; c < commands.size(); ++c) {
        if (commands[c].expected_wkc && !is_logical(commands[c].command) && !is_broadcast(commands[c].command)) {
          check_single({PlaceKind::kSlaveInitCmd, i, c}, commands[c].command, *commands[c].expected_wkc);
        }
      }
    }
  }

 private:
  void check_logical(const CyclicPlace& cyclic) {
    const CyclicCmd& cmd = *cyclic.cmd;
    const Range bytes = logical_bytes(cmd);
    const std::size_t readers = cmd.command == Command::kLwr ? 0 : inputs_.slaves_in(bytes);
    const std::size_t writers = cmd.command == Command::kLrd ? 0 : outputs_.slaves_in(bytes);
    const std::size_t computed = readers + (cmd.command == Command::kLrw ? 2 : 1) * writers;
    if (cmd.expected_wkc && *cmd.expected_wkc != computed) {
      findings_.add("ENI-WKC-01", cyclic.place(), fig::text<"command">(address_text(cmd)),
                    fig::count<"count">(*cmd.expected_wkc), fig::count<"computed">(computed),
                    fig::count<"readers">(readers), fig::count<"writers">(writers));
    } else if (!cmd.expected_wkc && computed > 0 && !is_mailbox_state(bytes)) {
      findings_.add("ENI-WKC-03", cyclic.place(), fig::text<"command">(address_text(cmd)),
                    fig::count<"computed">(computed));
    }
  }

  [[nodiscard]] bool is_mailbox_state(const Range& bytes) const {
    const MasterConfig& master = view_.config.master;
    return master.mailbox_state_count &&
           bytes.contains({master.mailbox_state_start, master.mailbox_state_start + 1ULL});
  }

  void check_broadcast(const CyclicPlace& cyclic) {
    const CyclicCmd& cmd = *cyclic.cmd;
    // Registers of the distributed clocks are not in every ESC.
    const bool everywhere = cmd.ado < reg::kReceiveTimePort0;
    const std::size_t factor = cmd.command == Command::kBrw ? 3 : 1;
    const std::size_t most = view_.config.slaves.size() * factor;
    if (!cmd.expected_wkc || !everywhere) return;
    if (*cmd.expected_wkc > most || *cmd.expected_wkc < fixed_ * factor) {
      findings_.add("ENI-WKC-02", cyclic.place(), fig::text<"command">(address_text(cmd)),
                    fig::count<"count">(*cmd.expected_wkc), fig::count<"slaves">(view_.config.slaves.size()));
    }
  }

  /// One slave answers with 1, or 3 when it is read and written.
  void check_single(const ConfigPlace& place, Command command, std::uint16_t count) {
    const bool both = command == Command::kAprw || command == Command::kFprw;
    const bool at_clock = command == Command::kArmw || command == Command::kFrmw;
    if (command == Command::kNop ? count != 0 : !at_clock && count != (both ? 3 : 1)) {
      findings_.add("ENI-WKC-04", place, fig::text<"command">(std::string(command_name(command))),
                    fig::count<"count">(count),
                    fig::count<"computed">(command == Command::kNop ? 0
                                           : both                   ? 3
                                                                    : 1));
    }
  }

  const NetworkView& view_;
  Findings& findings_;
  Mappings inputs_, outputs_;
  std::size_t fixed_;
};

}  // namespace

void check_working_counters(const NetworkView& view, Findings& findings) { CounterCheck(view, findings).run(); }

}  // namespace syncline::checker
