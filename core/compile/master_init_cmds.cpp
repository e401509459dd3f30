// SPDX-License-Identifier: Apache-2.0
#include "compile/master_init_cmds.h"

#include "config/init_cmd.h"
#include "protocol/command.h"
#include "protocol/registers.h"
#include "protocol/speed_counter.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint16_t kAllFmmusLength = 256;         // 16 FMMUs of 16 bytes
constexpr std::uint16_t kAllSyncManagersLength = 256;  // as the field's tools write it: the whole page 0x0800..0x08FF
constexpr std::uint16_t kSystemTimeUnitLength = 32;    // 0x0910..0x092F
constexpr std::uint16_t kDlStatusEvent = 0x0004;
constexpr std::uint16_t kFilterDepths = 0x0C00;  // difference 0, speed counter 12

InitCmd broadcast(Command command, std::uint16_t ado, std::string comment, std::vector<std::uint8_t> data) {
  InitCmd cmd;
  cmd.transitions = {Transition::kIP};
  cmd.before_slave = true;
  cmd.comment = std::move(comment);
  cmd.requires_cycle = true;
  cmd.command = command;
  cmd.ado = ado;
  cmd.data = std::move(data);
  cmd.retries = command == Command::kBrd ? 0 : 3;
  return cmd;
}

InitCmd clear(std::uint16_t ado, std::string comment, std::uint16_t length) {
  InitCmd cmd = broadcast(Command::kBwr, ado, std::move(comment), {});
  cmd.data_length = length;
  return cmd;
}

}  // namespace

std::vector<InitCmd> master_init_cmds() {
  const auto write = [](std::uint16_t ado, std::string comment, std::vector<std::uint8_t> data) {
    return broadcast(Command::kBwr, ado, std::move(comment), std::move(data));
  };
  const std::vector<std::uint8_t> word_zero(2);
  std::vector<InitCmd> cmds;
  // Twice: the first frame after power-on may be lost while PHYs settle.
  cmds.push_back(broadcast(Command::kBrd, reg::kAlStatus, "count slaves", word_zero));
  cmds.push_back(broadcast(Command::kBrd, reg::kAlStatus, "count slaves", word_zero));
  cmds.push_back(write(reg::kEcatEventMask, "report link changes in the IRQ field", le_bytes(kDlStatusEvent)));
  cmds.push_back(write(reg::kStationAddress, "clear station addresses", word_zero));
  cmds.push_back(write(reg::kRxErrorCounter, "clear receive error counters", std::vector<std::uint8_t>(8)));
  cmds.push_back(clear(reg::kFmmu, "clear FMMUs", kAllFmmusLength));
  cmds.back().transitions = {Transition::kIP, Transition::kPI, Transition::kBI, Transition::kSI, Transition::kOI};
  cmds.push_back(clear(reg::kSyncManager, "clear SyncManagers", kAllSyncManagersLength));
  cmds.push_back(clear(reg::kSystemTime, "clear system time unit", kSystemTimeUnitLength));
  cmds.push_back(write(reg::kActivation, "stop SYNC signals", {0}));
  cmds.push_back(write(reg::kSpeedCounterStart, "reset speed counter", le_bytes(kSpeedCounterDefault)));
  cmds.push_back(write(reg::kFilterDepthDifference, "set DC filter depths", le_bytes(kFilterDepths)));
  cmds.push_back(write(reg::kDlControlAlias, "address slaves by station address only", {0}));
  return cmds;
}

}  // namespace syncline::compiler
