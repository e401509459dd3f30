// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/init_cmd.h"
#include "master/exchange/frame_exchange.h"
#include "master/exchange/slave_batch.h"
#include "protocol/al_state.h"

namespace syncline {

class Bus;

/// What a list of init commands (ETG.2100 InitCmd) needs beside the commands.
struct InitCmdContext {
  std::string subject;    // names the slave in errors
  Nanoseconds pause = 0;  // at least this long between two tries of a command
  /// Where the slave really is, for commands that address by position; empty: as configured.
  std::optional<std::uint16_t> auto_increment_address;
  /// Other data than the configuration's (DC start time), asked for when the command's turn comes.
  std::function<std::optional<std::vector<std::uint8_t>>(const InitCmd& command)> data;
};

/// Init commands of one slave in their order. Each is sent until its working counter is the expected one
/// (Cnt, at most Retries more times, or until Timeout) and, with Validate, until the read data fit or
/// its time-out has passed. The first one that fails ends the list: kWorkingCounter, kInitCmdValidation,
/// kIdentityMismatch (SII data), kAlState and kAlTimeout (AL status).
class InitCmdWork final : public SlaveWork {
 public:
  /// The commands must outlive the work.
  InitCmdWork(std::vector<const InitCmd*> commands, InitCmdContext context);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return failed_ || index_ >= commands_.size(); }
  [[nodiscard]] Status result() const override { return result_; }

 private:
  enum class Step : std::uint8_t { kBegin, kCommand, kStatusCode };
  void begin(Nanoseconds now);
  void judge(Nanoseconds now);
  void judge_validation(Nanoseconds now);
  void try_again(Nanoseconds now);
  void succeed();
  void fail_with(Error error);
  void fail_validation();
  [[nodiscard]] const InitCmd& command() const { return *commands_[index_]; }
  [[nodiscard]] std::uint16_t adp() const;
  [[nodiscard]] std::uint32_t address() const;
  [[nodiscard]] Error counter_error(std::uint16_t wanted) const;

  std::vector<const InitCmd*> commands_;
  InitCmdContext context_;
  std::size_t index_ = 0;
  Step step_ = Step::kBegin;
  bool failed_ = false;
  std::uint32_t attempt_ = 0;
  Nanoseconds end_ = 0, not_before_ = 0;
  std::vector<std::uint8_t> original_, data_;
  std::array<std::uint8_t, 2> status_code_{};
  Error pending_;  // waits for the AL status code
  Datagram datagram_;
  Status result_;
};

/// One init command in blocking style; `subject` as in InitCmdContext, errors as of InitCmdWork and of the bus.
Status run_init_cmd(Bus& bus, const InitCmd& command, const std::string& subject);
/// Time between two tries: cycles bring their own, without them a millisecond.
[[nodiscard]] Nanoseconds init_cmd_pause(const Bus& bus);

/// Writes AL control with this state (the error acknowledge bit does not matter).
[[nodiscard]] bool requests_state(const InitCmd& command, AlState state);

}  // namespace syncline
