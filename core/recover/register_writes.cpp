// SPDX-License-Identifier: Apache-2.0
#include "recover/register_writes.h"

#include <algorithm>

#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::recover {
namespace {

constexpr unsigned kMaxUnits = 16;

bool on_the_way_up(const InitCmd& cmd) {
  return std::ranges::any_of(cmd.transitions, [](Transition transition) {
    return transition == Transition::kIP || transition == Transition::kPS || transition == Transition::kSO;
  });
}

bool writes(const InitCmd& cmd) {
  return cmd.command == Command::kFpwr || cmd.command == Command::kApwr || cmd.command == Command::kFprw ||
         cmd.command == Command::kAprw;
}

/// The records of `Size` bytes that a write covers, called with number and bytes; one write may set several.
template <std::size_t Size, class Take>
void each_record(const InitCmd& cmd, std::uint16_t base, Take take) {
  for (unsigned number = 0; number < kMaxUnits; ++number) {
    const std::size_t at = base + number * Size;
    if (at < cmd.ado || at + Size > std::size_t{cmd.ado} + cmd.data.size()) continue;
    const auto record = std::span(cmd.data).subspan(at - cmd.ado).template first<Size>();
    // Zeros clear what an earlier run has left.
    if (std::ranges::any_of(record, [](std::uint8_t byte) { return byte != 0; })) {
      take(static_cast<std::uint8_t>(number), record);
    }
  }
}

void take_word(const InitCmd& cmd, std::uint16_t reg, std::optional<std::uint16_t>& word) {
  if (cmd.ado == reg && cmd.data.size() == 2) word = load_le<std::uint16_t>(cmd.data);
}

}  // namespace

RegisterWrites register_writes(const std::vector<InitCmd>& commands) {
  RegisterWrites found;
  for (const InitCmd& cmd : commands) {
    if (cmd.ado == reg::kPdiControl && cmd.validate && cmd.validate->type == ValidateType::kEqual) {
      found.pdi = cmd.validate->data;
    }
    if (!writes(cmd) || !on_the_way_up(cmd)) continue;
    each_record<SyncManager::kSize>(cmd, reg::kSyncManager, [&](std::uint8_t number, auto record) {
      found.sync_managers[number] = SyncManager::decode(record);
    });
    each_record<Fmmu::kSize>(cmd, reg::kFmmu,
                             [&](std::uint8_t number, auto record) { found.fmmus[number] = Fmmu::decode(record); });
    take_word(cmd, reg::kWatchdogDivider, found.reg_0400);
    take_word(cmd, reg::kWatchdogPdi, found.reg_0410);
    take_word(cmd, reg::kWatchdogProcessData, found.reg_0420);
    const bool preop = cmd.ado == reg::kAlControl && !cmd.data.empty() && al_state_of(cmd.data[0]) == AlState::kPreop;
    if (preop && !found.state_request) found.state_request = cmd.data[0];
  }
  return found;
}

std::vector<SiiCheck> sii_checks(const std::vector<InitCmd>& commands) {
  constexpr std::size_t kRequestSize = 6;  // control word and word address
  constexpr std::uint16_t kReadCommand = 0x0100;
  std::vector<SiiCheck> checks;
  std::uint16_t word = 0;
  bool asked = false;
  for (const InitCmd& cmd : commands) {
    if (!std::ranges::count(cmd.transitions, Transition::kIP)) continue;
    if (writes(cmd) && cmd.ado == reg::kSiiControl && cmd.data.size() >= kRequestSize) {
      asked = (load_le<std::uint16_t>(cmd.data) & kReadCommand) != 0;
      word = load_le<std::uint16_t>(std::span(cmd.data).subspan(2));
    } else if (asked && cmd.ado == reg::kSiiData && cmd.validate && !cmd.validate->data.empty()) {
      checks.push_back({word, cmd.validate->data, cmd.validate->type});
    } else if (asked && cmd.ado == reg::kSiiData + 2 && cmd.validate && !cmd.validate->data.empty()) {
      checks.push_back({static_cast<std::uint16_t>(word + 1), cmd.validate->data, cmd.validate->type});
    }
  }
  return checks;
}

}  // namespace syncline::recover
