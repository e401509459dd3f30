// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "config/init_cmd.h"
#include "protocol/command.h"

namespace syncline::compiler {

using Bytes = std::vector<std::uint8_t>;
using Transitions = std::vector<Transition>;

/// Edits a command that was just appended to a list; valid until the next append.
class InitCmdEdit {
 public:
  explicit InitCmdEdit(InitCmd& cmd) : cmd_(cmd) {}
  /// Own cycle: what follows may rely on its effect.
  InitCmdEdit& cycle() {
    cmd_.requires_cycle = true;
    return *this;
  }
  /// Exactly one slave must answer.
  InitCmdEdit& answered() {
    cmd_.expected_wkc = 1;
    return *this;
  }
  InitCmdEdit& retries(std::uint32_t count) {
    cmd_.retries = count;
    return *this;
  }
  InitCmdEdit& timeout(std::uint32_t ms) {
    cmd_.timeout_ms = ms;
    return *this;
  }
  InitCmdEdit& validate(Bytes data, Bytes mask, std::uint32_t timeout_ms, ValidateType type = ValidateType::kEqual) {
    cmd_.validate = InitCmdValidate{std::move(data), std::move(mask), timeout_ms, type, false};
    return *this;
  }

 private:
  InitCmd& cmd_;
};

/// Appends the commands of one slave, addressed by position (auto-increment) before it has its station address.
class InitCmdBuilder {
 public:
  static constexpr std::uint32_t kDefaultRetries = 3;

  InitCmdBuilder(std::vector<InitCmd>& out, std::uint16_t auto_increment, std::uint16_t station)
      : out_(out), auto_increment_(auto_increment), station_(station) {}

  InitCmdEdit apwr(Transitions when, std::string comment, std::uint16_t ado, Bytes data) {
    return append(std::move(when), std::move(comment), Command::kApwr, auto_increment_, ado, std::move(data));
  }
  InitCmdEdit aprd(Transitions when, std::string comment, std::uint16_t ado, std::size_t length) {
    return append(std::move(when), std::move(comment), Command::kAprd, auto_increment_, ado, Bytes(length));
  }
  InitCmdEdit fpwr(Transitions when, std::string comment, std::uint16_t ado, Bytes data) {
    return append(std::move(when), std::move(comment), Command::kFpwr, station_, ado, std::move(data));
  }
  InitCmdEdit fprd(Transitions when, std::string comment, std::uint16_t ado, std::size_t length) {
    return append(std::move(when), std::move(comment), Command::kFprd, station_, ado, Bytes(length));
  }
  /// Zero bytes, written as ENI DataLength.
  InitCmdEdit fpwr_zeros(Transitions when, std::string comment, std::uint16_t ado, std::uint16_t length) {
    auto edit = fpwr(std::move(when), std::move(comment), ado, {});
    out_.back().data_length = length;
    return edit;
  }

 private:
  InitCmdEdit append(Transitions when, std::string comment, Command command, std::uint16_t adp, std::uint16_t ado,
                     Bytes data) {
    InitCmd& cmd = out_.emplace_back();
    cmd.transitions = std::move(when);
    cmd.comment = std::move(comment);
    cmd.command = command;
    cmd.adp = adp;
    cmd.ado = ado;
    cmd.data = std::move(data);
    cmd.retries = kDefaultRetries;
    return InitCmdEdit(cmd);
  }

  std::vector<InitCmd>& out_;
  std::uint16_t auto_increment_;
  std::uint16_t station_;
};

}  // namespace syncline::compiler
