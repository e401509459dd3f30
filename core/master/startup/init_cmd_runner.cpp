// SPDX-License-Identifier: Apache-2.0
#include "master/startup/init_cmd_runner.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "check/validate.h"
#include "master/exchange/bus.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "reasons/because.h"

namespace syncline {
namespace {

bool is_al_status(const InitCmd& command) { return command.ado == reg::kAlStatus && !is_logical(command.command); }

/// The slave says no and will not change its mind: waiting longer helps nobody.
bool refused(const InitCmd& command, std::span<const std::uint8_t> read) {
  if (!is_al_status(command) || read.empty() || command.validate->mask.empty()) return false;
  return (command.validate->mask[0] & kAlErrorFlag) != 0 && (read[0] & kAlErrorFlag) != 0;
}

std::string what(const InitCmd& command, const std::string& subject) {
  return command.comment.empty() ? subject : fmt::format("{}, \"{}\"", subject, command.comment);
}

std::string hex_bytes(std::span<const std::uint8_t> bytes) { return fmt::format("{:02x}", fmt::join(bytes, " ")); }

}  // namespace

bool requests_state(const InitCmd& command, AlState state) {
  return command.ado == reg::kAlControl && writes(command.command) && !is_logical(command.command) &&
         !command.data.empty() && al_state_of(command.data[0]) == state;
}

InitCmdWork::InitCmdWork(std::vector<const InitCmd*> commands, InitCmdContext context)
    : commands_(std::move(commands)), context_(std::move(context)) {}

std::uint16_t InitCmdWork::adp() const {
  const bool by_position = is_auto_increment(command().command);
  return by_position && context_.auto_increment_address ? *context_.auto_increment_address : command().adp;
}

std::uint32_t InitCmdWork::address() const {
  return is_logical(command().command) ? command().logical_address : device_address(adp(), command().ado);
}

void InitCmdWork::begin(Nanoseconds now) {
  const auto& cmd = command();
  const auto other = context_.data ? context_.data(cmd) : std::nullopt;
  original_ = other ? *other : cmd.data;
  original_.resize(other ? original_.size() : cmd.length());
  attempt_ = 0;
  end_ = now + (cmd.validate ? cmd.validate->timeout_ms : cmd.timeout_ms.value_or(0)) * kMillisecond;
  step_ = Step::kCommand;
}

Datagram* InitCmdWork::next(Nanoseconds now) {
  if (over() || now < not_before_) return nullptr;
  if (step_ == Step::kBegin) begin(now);
  if (step_ == Step::kStatusCode) {
    status_code_.fill(0);
    datagram_ = {command().command, device_address(adp(), reg::kAlStatusCode), status_code_};
    return &datagram_;
  }
  data_ = original_;
  if (command().validate) std::ranges::fill(data_, std::uint8_t{0});
  datagram_ = {command().command, address(), data_};
  return &datagram_;
}

void InitCmdWork::take(Nanoseconds now) {
  if (step_ == Step::kStatusCode) {
    if (datagram_.wkc > 0) pending_.extra = load_le<std::uint16_t>(status_code_);
    return fail_with(std::move(pending_));
  }
  if (command().validate) return judge_validation(now);
  judge(now);
}

void InitCmdWork::judge(Nanoseconds now) {
  const auto& wanted = command().expected_wkc;
  if (!wanted || datagram_.wkc == *wanted) return succeed();
  if (attempt_++ >= command().retries && now >= end_) return fail_with(counter_error(*wanted));
  try_again(now);
}

void InitCmdWork::judge_validation(Nanoseconds now) {
  const auto wanted = command().expected_wkc.value_or(1);
  const bool answered = datagram_.wkc >= wanted;
  if (answered && satisfies(*command().validate, data_)) return succeed();
  if (answered && refused(command(), data_)) return fail_validation();
  if (now < end_) return try_again(now);
  if (!answered) return fail_with(counter_error(wanted));
  fail_validation();
}

void InitCmdWork::try_again(Nanoseconds now) { not_before_ = now + context_.pause; }

void InitCmdWork::succeed() {
  ++index_;
  step_ = Step::kBegin;
}

void InitCmdWork::fail_with(Error error) {
  failed_ = true;
  result_ = fail(std::move(error));
}

Error InitCmdWork::counter_error(std::uint16_t wanted) const {
  Error error{ErrorCode::kWorkingCounter, what(command(), context_.subject)};
  error.expected = wanted;
  error.received = datagram_.wkc;
  return error;
}

void InitCmdWork::fail_validation() {
  const auto& wanted = command().validate->data;
  const std::span<const std::uint8_t> read(data_);
  if (is_al_status(command()) && !wanted.empty() && !read.empty()) {
    Error error{refused(command(), read) ? ErrorCode::kAlState : ErrorCode::kAlTimeout, context_.subject};
    error.expected = wanted[0] & 0x0F;
    error.received = read.size() >= 2 ? load_le<std::uint16_t>(read) : read[0];
    if (read.size() >= 6) {
      error.extra = load_le<std::uint16_t>(read.subspan(4));
      return fail_with(std::move(error));
    }
    pending_ = std::move(error);
    step_ = Step::kStatusCode;
    return;
  }
  const bool identity = command().ado == reg::kSiiData;
  Error error{identity ? ErrorCode::kIdentityMismatch : ErrorCode::kInitCmdValidation,
              identity ? context_.subject : what(command(), context_.subject)};
  const auto shown = [identity](std::span<const std::uint8_t> bytes) {
    return identity && bytes.size() == 4 ? fmt::format("0x{:08X}", load_le<std::uint32_t>(bytes)) : hex_bytes(bytes);
  };
  const auto due = fmt::format("{}{}", relation(command().validate->type), shown(wanted));
  const auto found = shown(read.first(std::min(read.size(), wanted.size())));
  const auto& comment = command().comment;
  error.detail = identity && !comment.empty()
                     ? because("{comment}: expected {wanted}, read {read}", comment, due, found)
                     : because("expected {wanted}, read {read}", due, found);
  fail_with(std::move(error));
}

Nanoseconds init_cmd_pause(const Bus& bus) { return bus.cyclic() ? 0 : kMillisecond; }

Status run_init_cmd(Bus& bus, const InitCmd& command, const std::string& subject) {
  InitCmdWork work({&command}, {subject, init_cmd_pause(bus), std::nullopt, {}});
  return run_to_end(bus, work);
}

}  // namespace syncline
