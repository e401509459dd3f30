// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/network_config.h"
#include "master/bus.h"

namespace syncline {

/// Executes init commands (ETG.2100 InitCmd) one by one.
class InitCmdRunner {
 public:
  explicit InitCmdRunner(Bus& bus) : bus_(bus) {}

  /// Sends the command until its working counter is the expected one (Cnt, at most Retries more times,
  /// or until Timeout) and, with Validate, until the read data fit or its time-out has passed.
  /// `subject` names the slave in errors: kWorkingCounter, kInitCmdValidation, kIdentityMismatch (SII
  /// data), kAlState and kAlTimeout (AL status).
  Status run(const InitCmd& command, const std::string& subject);
  /// The same with other data than the configuration's (DC start time).
  Status run(const InitCmd& command, std::vector<std::uint8_t> data, const std::string& subject);

 private:
  Result<std::uint16_t> send(const InitCmd& command, std::span<std::uint8_t> data);
  Status validate(const InitCmd& command, std::span<std::uint8_t> data, const std::string& subject);
  Error validation_error(const InitCmd& command, std::span<const std::uint8_t> read, const std::string& subject);

  Bus& bus_;
};

[[nodiscard]] bool has_transition(const InitCmd& command, Transition transition);
/// Writes AL control with this state (the error acknowledge bit does not matter).
[[nodiscard]] bool requests_state(const InitCmd& command, AlState state);

}  // namespace syncline
