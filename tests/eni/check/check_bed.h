// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <set>
#include <string>

#include "compile/compile.h"
#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "tests/support/sample_devices.h"

/// A machine whose ENI is without finding, and the means to break it in one place.
namespace syncline::test {

enum : std::size_t { kCoupler, kInput, kOutput, kDrive, kLastDrive };

/// Coupler, inputs, outputs and two drives with mailbox state bits, distributed clocks, bus shift and sync window.
inline NetworkConfig checked_machine(EniDialect dialect = EniDialect::kEcEngineer) {
  DeviceDescription drive = sample::servo();
  drive.fmmus.push_back(FmmuUse::kMailboxState);
  Project project =
      sample::project({sample::coupler(), sample::digital_input(), sample::digital_output(), drive, drive});
  project.master.dc.dcm.mode = DcmMode::kBusShift;
  project.master.dc.sync_window.enabled = true;
  return compile(project, {dialect})->config;
}

inline std::set<std::string> codes(const std::string& text) {
  std::set<std::string> out;
  const auto check = eni::check_eni_text(text, "test.xml");
  if (!check) return {"not checked"};
  for (const auto& finding : check->findings) out.emplace(finding.code);
  return out;
}

inline bool has(const InitCmd& cmd, Transition transition) {
  return std::ranges::find(cmd.transitions, transition) != cmd.transitions.end();
}

/// Last init command on a transition that writes or reads a register.
inline InitCmd& command(NetworkConfig& config, std::size_t slave, Transition transition, std::uint16_t ado,
                        bool write = true) {
  auto& commands = config.slaves[slave].init_cmds;
  const auto found = std::find_if(commands.rbegin(), commands.rend(), [&](const InitCmd& cmd) {
    return has(cmd, transition) && cmd.ado == ado && writes(cmd.command) == write;
  });
  return *found;
}

inline void erase_commands(NetworkConfig& config, std::size_t slave, Transition transition, std::uint16_t ado) {
  std::erase_if(config.slaves[slave].init_cmds,
                [&](const InitCmd& cmd) { return has(cmd, transition) && cmd.ado == ado; });
}

inline void erase_command(NetworkConfig& config, std::size_t slave, const InitCmd& command) {
  std::erase_if(config.slaves[slave].init_cmds, [&](const InitCmd& cmd) { return &cmd == &command; });
}

inline void move_to_end(NetworkConfig& config, std::size_t slave, Transition transition, std::uint16_t ado) {
  InitCmd moved = command(config, slave, transition, ado);
  erase_command(config, slave, command(config, slave, transition, ado));
  config.slaves[slave].init_cmds.push_back(std::move(moved));
}

inline std::vector<CyclicCmd>& frame(NetworkConfig& config) { return config.cyclic.front().frames.front().commands; }

inline CyclicCmd& cyclic(NetworkConfig& config, Command command, std::uint16_t ado = 0) {
  return *std::ranges::find_if(frame(config),
                               [&](const CyclicCmd& cmd) { return cmd.command == command && cmd.ado == ado; });
}

inline void erase_cyclic(NetworkConfig& config, Command command, std::uint16_t ado) {
  std::erase_if(frame(config), [&](const CyclicCmd& cmd) { return cmd.command == command && cmd.ado == ado; });
}

inline InitCmd write(const SlaveConfig& slave, Transition transition, std::uint16_t ado,
                     std::vector<std::uint8_t> data) {
  InitCmd cmd;
  cmd.transitions = {transition};
  cmd.command = Command::kFpwr;
  cmd.adp = slave.station_address;
  cmd.ado = ado;
  cmd.data = std::move(data);
  return cmd;
}

/// Puts a command before all others of the slave on PS.
inline void insert_on_ps(NetworkConfig& config, std::size_t slave, std::uint16_t ado, std::vector<std::uint8_t> data) {
  auto& commands = config.slaves[slave].init_cmds;
  const auto first = std::ranges::find_if(commands, [](const InitCmd& cmd) { return has(cmd, Transition::kPS); });
  commands.insert(first, write(config.slaves[slave], Transition::kPS, ado, std::move(data)));
}

inline Fmmu fmmu(NetworkConfig& config, std::size_t slave, unsigned number) {
  const auto& data = command(config, slave, Transition::kPS, reg::fmmu(number)).data;
  return Fmmu::decode(std::span<const std::uint8_t, Fmmu::kSize>(data.data(), Fmmu::kSize));
}

inline std::vector<std::uint8_t> bytes(const Fmmu& fmmu) {
  const auto encoded = fmmu.encode();
  return {encoded.begin(), encoded.end()};
}

/// Another station address in everything that names it.
inline void readdress(SlaveConfig& slave, std::uint16_t address) {
  for (InitCmd& cmd : slave.init_cmds) {
    if (is_fixed_address(cmd.command)) cmd.adp = address;
    if (cmd.ado == reg::kStationAddress)
      cmd.data = {static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(address >> 8)};
  }
  slave.station_address = address;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  return at == std::string::npos ? "<not-found/>" : text.replace(at, from.size(), to);
}

}  // namespace syncline::test
