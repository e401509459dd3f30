// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>
#include <unordered_map>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/entry_ports.h"
#include "support/types.h"

namespace syncline::checker {
namespace {

void check_addresses(const NetworkView& view, Findings& findings) {
  const auto& slaves = view.config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const ConfigPlace place{PlaceKind::kSlave, i};
    const std::uint16_t address = slaves[i].station_address;
    if (address == 0) {
      findings.add("ENI-REF-04", place, "the station address is 0");
    } else if (const auto first = view.with_address(address); first && *first != i) {
      findings.add("ENI-REF-03", place,
                   fmt::format("station address {} belongs to {}, too", address, view.name(*first)));
    }
    const std::uint16_t expected = Position{static_cast<std::uint16_t>(i)}.auto_increment_address();
    if (slaves[i].auto_increment_address != expected) {
      findings.add("ENI-REF-05", place,
                   fmt::format("AutoIncAddr is {}, the place in the file makes it {}", slaves[i].auto_increment_address,
                               expected));
    }
  }
}

void check_names(const NetworkView& view, Findings& findings) {
  std::unordered_map<std::string_view, std::size_t> first;
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const std::string& name = view.config.slaves[i].name;
    if (name.empty()) continue;
    if (const auto [it, is_new] = first.emplace(name, i); !is_new) {
      findings.add("ENI-REF-06", {PlaceKind::kSlave, i},
                   fmt::format("\"{}\" is the name of slave {}, too", name, it->second));
    }
  }
}

/// Each slave's init commands go to that slave.
void check_addressees(const NetworkView& view, Findings& findings) {
  const auto& slaves = view.config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    for (std::size_t c = 0; c < slaves[i].init_cmds.size(); ++c) {
      const InitCmd& cmd = slaves[i].init_cmds[c];
      const bool other_address = is_fixed_address(cmd.command) && cmd.adp != slaves[i].station_address;
      const bool other_place = is_auto_increment(cmd.command) && cmd.adp != slaves[i].auto_increment_address;
      if (is_broadcast(cmd.command)) {
        findings.add("ENI-REF-07", {PlaceKind::kSlaveInitCmd, i, c},
                     fmt::format("{} goes to all slaves", address_text(cmd)));
      }
      if (other_address || other_place) {
        findings.add("ENI-REF-07", {PlaceKind::kSlaveInitCmd, i, c},
                     fmt::format("{} does not go to this slave ({} {})", address_text(cmd),
                                 other_address ? "station address" : "auto-increment address",
                                 other_address ? slaves[i].station_address : slaves[i].auto_increment_address));
      }
    }
  }
  for (const CyclicPlace& cyclic : view.cyclic) {
    const Command command = cyclic.cmd->command;
    if ((is_fixed_address(command) || is_auto_increment(command)) && !view.addressee(command, cyclic.cmd->adp)) {
      findings.add("ENI-REF-08", cyclic.place(),
                   fmt::format("{} addresses no slave of the file", address_text(*cyclic.cmd)));
    }
  }
}

/// The wiring: each slave hangs on one before it, or on one whose cables are swapped; no port carries two.
void check_wiring(const NetworkView& view, Findings& findings) {
  std::set<std::pair<std::uint16_t, std::uint8_t>> used;
  const auto& slaves = view.config.slaves;
  std::vector<std::optional<PreviousPort>> wiring;
  for (const auto& slave : slaves) wiring.push_back(slave.previous);
  const auto entries = entry_ports(wiring);
  std::size_t group_end = 0;  // slaves of hot-connect groups may be plugged in anywhere
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (slaves[i].hot_connect) group_end = i + slaves[i].hot_connect->member_count;
    const auto& previous = slaves[i].previous;
    if (!previous) continue;
    const ConfigPlace place{PlaceKind::kSlave, i};
    if (previous->position >= i && (previous->position >= slaves.size() || !entries[previous->position])) {
      findings.add("ENI-REF-02", place,
                   fmt::format("it hangs on {}, which does not stand before it", view.name(previous->position)));
      continue;
    }
    if (previous->position > i) {
      findings.add("ENI-REF-11", place,
                   fmt::format("it hangs on {}, which stands behind it", view.name(previous->position)));
    }
    if (i >= group_end && !used.emplace(previous->position, previous->port).second) {
      findings.add("ENI-REF-09", place,
                   fmt::format("port {} of {} carries another slave already", static_cast<char>('A' + previous->port),
                               view.name(previous->position)));
    }
  }
}

}  // namespace

void check_references(const NetworkView& view, Findings& findings) {
  check_addresses(view, findings);
  check_names(view, findings);
  check_addressees(view, findings);
  check_wiring(view, findings);
}

}  // namespace syncline::checker
