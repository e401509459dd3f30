// SPDX-License-Identifier: Apache-2.0
#include "fuzz/targets.h"

#include <algorithm>
#include <array>

#include "fuzz/bus_targets.h"
#include "fuzz/catalogue_target.h"
#include "fuzz/command_target.h"
#include "fuzz/import_targets.h"
#include "fuzz/recording_target.h"
#include "fuzz/text_targets.h"
#include "fuzz/wire_targets.h"
#include "fuzz/xml_targets.h"

namespace syncline::fuzz {
namespace {

constexpr std::array kTargets{Target{"frame", run_frame, frames, damage_frame, 30'000},
                              Target{"sii", run_sii, siis, damage_bytes, 10'000},
                              Target{"mailbox", run_mailbox, mailboxes, damage_bytes, 20'000},
                              Target{"pcap", run_pcap, captures, damage_bytes, 10'000},
                              Target{"esi", run_esi, esis, damage_xml_bytes, 1'500},
                              Target{"eni", run_eni, enis, damage_xml_bytes, 4'000},
                              Target{"project", run_project, projects, damage_xml_bytes, 1'000},
                              Target{"scenario", run_scenario, scenarios, damage_lines, 3'000},
                              Target{"dcmlog", run_dcm_log, dcm_logs, damage_lines, 10'000},
                              Target{"table", run_table, tables, damage_lines, 6'000},
                              Target{"import", run_import, captured_runs, damage_bytes, 6'000},
                              Target{"bus", run_bus, bus_scripts, damage_bytes, 1'500},
                              Target{"master", run_master, master_scripts, damage_bytes, 100},
                              Target{"clients", run_clients, client_scripts, damage_bytes, 3'000},
                              Target{"catalogue", run_catalogue, catalogues, damage_database, 400},
                              Target{"recording", run_recording, recordings, damage_database, 300},
                              Target{"command", run_command, commands, damage_words, 500}};

}  // namespace

std::span<const Target> targets() { return kTargets; }

const Target* find_target(std::string_view name) {
  const auto found =
      std::ranges::find(kTargets, name, [](const Target& target) { return std::string_view(target.name); });
  return found == kTargets.end() ? nullptr : &*found;
}

}  // namespace syncline::fuzz
