// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <set>
#include <unordered_map>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/entry_ports.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/previous_port.h"
#include "support/types.h"

namespace syncline::checker {
namespace {

void check_addresses(const NetworkView& view, Findings& findings) {
  const auto& slaves = view.config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const ConfigPlace place{PlaceKind::kSlave, i};
    const std::uint16_t address = slaves[i].station_address;
    if (address == 0) {
      findings.add("ENI-REF-04", place);
    } else if (const auto first = view.with_address(address); first && *first != i) {
      findings.add("ENI-REF-03", place, fig::number<"address">(address), view.slave<"slave">(*first));
    }
    const std::uint16_t expected = Position{static_cast<std::uint16_t>(i)}.auto_increment_address();
    if (slaves[i].auto_increment_address != expected) {
      findings.add("ENI-REF-05", place, fig::number<"said">(slaves[i].auto_increment_address),
                   fig::number<"expected">(expected));
    }
  }
}

void check_names(const NetworkView& view, Findings& findings) {
  std::unordered_map<std::string_view, std::size_t> first;
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const std::string& name = view.config.slaves[i].name;
    if (name.empty()) continue;
    if (const auto [it, is_new] = first.emplace(name, i); !is_new) {
      findings.add("ENI-REF-06", {PlaceKind::kSlave, i}, fig::text<"name">(name), fig::number<"slave">(it->second));
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
        findings.add("ENI-REF-07/broadcast", {PlaceKind::kSlaveInitCmd, i, c}, fig::text<"command">(address_text(cmd)));
      }
      if (other_address) {
        findings.add("ENI-REF-07", {PlaceKind::kSlaveInitCmd, i, c}, fig::text<"command">(address_text(cmd)),
                     fig::number<"address">(slaves[i].station_address));
      } else if (other_place) {
        findings.add("ENI-REF-07/place", {PlaceKind::kSlaveInitCmd, i, c}, fig::text<"command">(address_text(cmd)),
                     fig::number<"address">(slaves[i].auto_increment_address));
      }
    }
  }
  for (const CyclicPlace& cyclic : view.cyclic) {
    const Command command = cyclic.cmd->command;
    if ((is_fixed_address(command) || is_auto_increment(command)) && !view.addressee(command, cyclic.cmd->adp)) {
      findings.add("ENI-REF-08", cyclic.place(), fig::text<"command">(address_text(*cyclic.cmd)));
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
  std::map<std::uint16_t, int> with_address;
  for (const auto& slave : slaves) ++with_address[slave.station_address];
  std::size_t group_end = 0;  // slaves of hot-connect groups may be plugged in anywhere
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (slaves[i].hot_connect) group_end = i + slaves[i].hot_connect->member_count;
    const auto& previous = slaves[i].previous;
    if (!previous) continue;
    const ConfigPlace place{PlaceKind::kSlave, i};
    if (previous->position >= i && (previous->position >= slaves.size() || !entries[previous->position])) {
      findings.add("ENI-REF-02", place, view.slave<"slave">(previous->position));
      continue;
    }
    if (previous->position > i) {
      findings.add("ENI-REF-11", place, view.slave<"slave">(previous->position));
    }
    // Whose port it is an address that two have does not say; that there are two is said.
    const bool known =
        previous->position >= slaves.size() || with_address[slaves[previous->position].station_address] == 1;
    if (i >= group_end && known && !used.emplace(previous->position, previous->port).second) {
      findings.add("ENI-REF-09", place, fig::text<"port">(std::string(1, static_cast<char>('A' + previous->port))),
                   view.slave<"slave">(previous->position));
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
