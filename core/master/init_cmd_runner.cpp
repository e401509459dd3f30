// SPDX-License-Identifier: Apache-2.0
#include "master/init_cmd_runner.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "protocol/registers.h"

namespace syncline {
namespace {

std::uint32_t address_of(const InitCmd& command) {
  return is_logical(command.command) ? command.logical_address : device_address(command.adp, command.ado);
}

bool matches(const InitCmdValidate& validate, std::span<const std::uint8_t> read) {
  for (std::size_t i = 0; i < validate.data.size(); ++i) {
    const std::uint8_t mask = i < validate.mask.size() ? validate.mask[i] : std::uint8_t{0xFF};
    const std::uint8_t got = i < read.size() ? read[i] : std::uint8_t{0};
    if (((got ^ validate.data[i]) & mask) != 0) return false;
  }
  return true;
}

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

bool has_transition(const InitCmd& command, Transition transition) {
  return std::ranges::find(command.transitions, transition) != command.transitions.end();
}

bool requests_state(const InitCmd& command, AlState state) {
  return command.ado == reg::kAlControl && writes(command.command) && !is_logical(command.command) &&
         !command.data.empty() && al_state_of(command.data[0]) == state;
}

Status InitCmdRunner::run(const InitCmd& command, const std::string& subject) {
  auto data = command.data;
  data.resize(command.length());
  return run(command, std::move(data), subject);
}

Status InitCmdRunner::run(const InitCmd& command, std::vector<std::uint8_t> data, const std::string& subject) {
  if (command.validate) return validate(command, data, subject);
  const auto original = data;
  const auto end = bus_.clock().now() + command.timeout_ms.value_or(0) * kMillisecond;
  std::uint16_t received = 0;
  for (std::uint32_t attempt = 0;; ++attempt) {
    data = original;
    const auto wkc = send(command, data);
    if (!wkc) return tl::unexpected(wkc.error());
    received = *wkc;
    if (!command.expected_wkc || received == *command.expected_wkc) return {};
    if (attempt >= command.retries && bus_.clock().now() >= end) break;
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  Error error{ErrorCode::kWorkingCounter, what(command, subject)};
  error.expected = *command.expected_wkc;
  error.received = received;
  return fail(std::move(error));
}

Result<std::uint16_t> InitCmdRunner::send(const InitCmd& command, std::span<std::uint8_t> data) {
  Datagram datagram{command.command, address_of(command), data};
  if (auto status = bus_.transact(datagram); !status) return tl::unexpected(status.error());
  return datagram.wkc;
}

Status InitCmdRunner::validate(const InitCmd& command, std::span<std::uint8_t> data, const std::string& subject) {
  const auto end = bus_.clock().now() + command.validate->timeout_ms * kMillisecond;
  const auto wanted = command.expected_wkc.value_or(1);
  while (true) {
    std::ranges::fill(data, std::uint8_t{0});
    const auto wkc = send(command, data);
    if (!wkc) return tl::unexpected(wkc.error());
    if (*wkc >= wanted && matches(*command.validate, data)) return {};
    if (*wkc >= wanted && refused(command, data)) break;
    if (bus_.clock().now() >= end) {
      if (*wkc < wanted) {
        Error error{ErrorCode::kWorkingCounter, what(command, subject)};
        error.expected = wanted;
        error.received = *wkc;
        return fail(std::move(error));
      }
      break;
    }
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  return fail(validation_error(command, data, subject));
}

Error InitCmdRunner::validation_error(const InitCmd& command, std::span<const std::uint8_t> read,
                                      const std::string& subject) {
  const auto& wanted = command.validate->data;
  if (is_al_status(command) && !wanted.empty()) {
    Error error{refused(command, read) ? ErrorCode::kAlState : ErrorCode::kAlTimeout, subject};
    error.expected = wanted[0] & 0x0F;
    error.received = read.size() >= 2 ? load_le<std::uint16_t>(read) : read[0];
    if (read.size() >= 6) {
      error.extra = load_le<std::uint16_t>(read.subspan(4));
    } else if (auto code = bus_.read<std::uint16_t>(command.adp, reg::kAlStatusCode, subject);
               code && command.command == Command::kFprd) {
      error.extra = *code;
    }
    return error;
  }
  const bool identity = command.ado == reg::kSiiData;
  Error error{identity ? ErrorCode::kIdentityMismatch : ErrorCode::kInitCmdValidation,
              identity ? subject : what(command, subject)};
  error.detail = fmt::format("expected {}, read {}", hex_bytes(wanted), hex_bytes(read.first(wanted.size())));
  if (identity && !command.comment.empty()) error.detail = command.comment + ": " + error.detail;
  return error;
}

}  // namespace syncline
