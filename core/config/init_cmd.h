// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/al_state.h"
#include "protocol/command.h"

/// Register access of the master at a state transition (ETG.2100, InitCmd).
namespace syncline {

/// ENI Validate@Type: how the answer has to stand to the expected value for the command to be done.
enum class ValidateType : std::uint8_t {
  kEqual,
  kNotEqual,
  kGreaterOrEqual,
  kLessOrEqual,
  kGreater,
  kLess,
  kNone  // kNone: any answer will do
};

struct InitCmdValidate {
  std::vector<std::uint8_t> data;
  std::vector<std::uint8_t> mask;  // empty = compare all
  std::uint32_t timeout_ms = 0;
  ValidateType type = ValidateType::kEqual;
  bool is_signed = false;  // Validate@Signed: of the comparisons by size
  bool operator==(const InitCmdValidate&) const = default;
};

struct InitCmd {
  std::vector<Transition> transitions;
  bool before_slave = false;
  std::string comment;
  bool requires_cycle = false;  // Requires = cycle | (absent)
  Command command = Command::kNop;
  std::uint16_t adp = 0;
  std::uint16_t ado = 0;
  std::uint32_t logical_address = 0;          // instead of adp/ado for LRD, LWR, LRW
  std::vector<std::uint8_t> data;             // bytes in wire order
  std::optional<std::uint16_t> data_length;   // ENI DataLength: that many zero bytes instead of data
  std::optional<std::uint16_t> expected_wkc;  // Cnt
  std::uint32_t retries = 0;
  std::optional<InitCmdValidate> validate;
  std::optional<std::uint32_t> timeout_ms;
  bool operator==(const InitCmd&) const = default;
  [[nodiscard]] std::uint16_t length() const {
    return data_length ? *data_length : static_cast<std::uint16_t>(data.size());
  }
  bool requires_frame = false;  // Requires = frame: not together with others in one frame
};

/// Of an InitCmd, or of any other command that has a list of transitions.
template <class Cmd>
[[nodiscard]] bool has_transition(const Cmd& cmd, Transition transition) {
  return std::ranges::find(cmd.transitions, transition) != cmd.transitions.end();
}

}  // namespace syncline
