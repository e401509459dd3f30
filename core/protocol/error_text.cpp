// SPDX-License-Identifier: Apache-2.0
#include "protocol/error_text.h"

#include <fmt/format.h>

#include <optional>

#include "protocol/al_state.h"
#include "protocol/coe.h"
#include "protocol/foe.h"

namespace syncline {
namespace {

std::string where_text(const Error& error) {
  return error.line > 0 ? fmt::format("{}:{}", error.file, error.line) : error.file;
}

std::string al_status_text(std::int64_t status) {
  const auto value = static_cast<std::uint16_t>(status);
  std::string text(al_state_name(al_state_of(value)));
  if ((value & kAlErrorFlag) != 0) text += "+ERR";
  return text;
}

std::string al_code_text(std::int64_t code) {
  const auto value = static_cast<std::uint16_t>(code);
  const auto text = al_status_code_text(value);
  auto line = fmt::format("0x{:04X} ({})", value, text.meaning);
  if (!text.check.empty()) line += fmt::format("; check {}", text.check);
  return line;
}

std::string abort_text(std::int64_t code) {
  const auto value = static_cast<std::uint32_t>(code);
  return fmt::format("0x{:08X} ({})", value, coe::abort_code_text(value));
}

std::string foe_text(std::int64_t code) {
  const auto value = static_cast<std::uint32_t>(code);
  return fmt::format("0x{:04X} ({})", value, foe::error_text(value));
}

std::optional<std::string> placeholder_text(std::string_view name, const Error& error) {
  if (name == "subject") return error.subject;
  if (name == "detail") return error.detail;
  if (name == "because") return error.detail.empty() ? std::string() : ": " + error.detail;
  if (name == "file") return error.file;
  if (name == "line") return fmt::format("{}", error.line);
  if (name == "where") return where_text(error);
  if (name == "expected") return fmt::format("{}", error.expected);
  if (name == "received") return fmt::format("{}", error.received);
  if (name == "extra") return fmt::format("{}", error.extra);
  if (name == "state") return std::string(al_state_name(al_state_of(static_cast<std::uint16_t>(error.expected))));
  if (name == "actual") return al_status_text(error.received);
  if (name == "alcode") return al_code_text(error.extra);
  if (name == "abort") return abort_text(error.received);
  if (name == "foe") return foe_text(error.received);
  return std::nullopt;
}

}  // namespace

std::string_view error_template(ErrorCode code) {
  switch (code) {
    case ErrorCode::kFileNotFound:
      return "The file {file} does not exist; check its name and folder.";
    case ErrorCode::kFileNotReadable:
      return "The file {file} cannot be read{because}.";
    case ErrorCode::kFileNotWritable:
      return "The file {file} cannot be written{because}; check the folder's permissions and free space.";
    case ErrorCode::kXmlMalformed:
      return "{where}: this is not well-formed XML{because}.";
    case ErrorCode::kXmlMissingElement:
      return "{where}: the element <{subject}> is missing{because}.";
    case ErrorCode::kXmlBadValue:
      return "{where}: the value of <{subject}> cannot be used{because}.";
    case ErrorCode::kNotThatKindOfFile:
      return "{where}: this is another kind of file; expected{because}.";
    case ErrorCode::kTomlMalformed:
      return "{where}: this is not well-formed TOML{because}.";
    case ErrorCode::kScenarioKey:
      return "{where}: the key \"{subject}\" cannot be used{because}.";
    case ErrorCode::kUnknownDevice:
      return "The device {subject} is not known{because}; load its ESI file.";
    case ErrorCode::kMissingEsi:
      return "No ESI file describes {subject}; put the vendor's ESI file into the ESI folder {detail} and scan again.";
    case ErrorCode::kUnknownKey:
      return "There is no setting \"{subject}\"{because}.";
    case ErrorCode::kBadValue:
      return "The value of {subject} cannot be used{because}.";
    case ErrorCode::kConfiguration:
      return "The configuration of {subject} does not work out{because}.";
    case ErrorCode::kLinkNotFound:
      return "There is no network adapter or link \"{subject}\"{because}; list them with \"synclinectl adapters\".";
    case ErrorCode::kLinkDown:
      return "The link {subject} is down{because}; check the cable and that the interface is up.";
    case ErrorCode::kLinkPermission:
      return "No permission to send raw frames on {subject}; grant it once with: {detail}";
    case ErrorCode::kLinkIo:
      return "Sending or receiving on {subject} failed{because}.";
    case ErrorCode::kNotSupported:
      return "{subject} is not supported{because}.";
    case ErrorCode::kNoResponse:
      return "No answer from {subject}; check power, cabling and the working counter of the slaves before it.";
    case ErrorCode::kWorkingCounter:
      return "{subject}: working counter {received} where {expected} was expected; a slave did not process the "
             "datagram.";
    case ErrorCode::kSlaveCount:
      return "The bus has {received} slaves where {expected} were expected; compare the wiring with the configuration.";
    case ErrorCode::kIdentityMismatch:
      return "{subject} is another device than configured{because}; scan again or exchange the device.";
    case ErrorCode::kAlState:
      return "{subject} refused {state} and stays in {actual}: AL status code {alcode}.";
    case ErrorCode::kAlTimeout:
      return "{subject} did not reach {state} in time and is in {actual}; raise the timeout or check what the slave "
             "waits for.";
    case ErrorCode::kMailboxTimeout:
      return "{subject} did not answer in its mailbox in time; the slave may be busy or its mailbox is set up wrongly.";
    case ErrorCode::kMailboxProtocol:
      return "{subject} answered in its mailbox with something else than was asked{because}.";
    case ErrorCode::kSdoAbort:
      return "{subject}: the slave aborted the SDO transfer with {abort}.";
    case ErrorCode::kSii:
      return "The SII (EEPROM) of {subject} cannot be used{because}.";
    case ErrorCode::kInitCmdValidation:
      return "{subject}: the slave's answer differs from what the init command demands{because}.";
    case ErrorCode::kMalformedData:
      return "{subject} is malformed{because}.";
    case ErrorCode::kDcSetup:
      return "Distributed clocks of {subject} could not be set up{because}.";
    case ErrorCode::kDcmOutOfLimit:
      return "{subject}: the DCM error of {received} ns is beyond the limit of {expected} ns; check the host's jitter "
             "and the clock's drift.";
    case ErrorCode::kTimeout:
      return "{subject} took too long{because}.";
    case ErrorCode::kCancelled:
      return "Cancelled.";
    case ErrorCode::kSlaveMissing:
      return "{subject} is missing{because}; check its power and the cable to it, or take it out of the configuration.";
    case ErrorCode::kSlaveExtra:
      return "There is a device that is not in the configuration: {subject}{because}; scan again or take it off the "
             "bus.";
    case ErrorCode::kSlavesSwapped:
      return "{subject} and {detail} have changed places; swap their cables, or their positions in the configuration.";
    case ErrorCode::kWiring:
      return "Wiring of {subject}: {detail}.";
    case ErrorCode::kIdentification:
      return "Identification of {subject}: {detail}.";
    case ErrorCode::kScanScope:
      return "Not read from {subject}: {detail}.";
    case ErrorCode::kFileTransfer:
      return "{subject}: the slave ended the file transfer with {foe}{because}.";
    case ErrorCode::kFileLimit:
      return "{where}: the file is beyond what is read{because}.";
    case ErrorCode::kCatalogue:
      return "The device catalogue {file} cannot be used{because}; delete it or choose another one.";
  }
  return "{subject}{because}.";
}

std::string fill_error_template(std::string_view text, const Error& error) {
  std::string filled;
  while (!text.empty()) {
    const auto open = text.find('{');
    filled += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const auto close = text.find('}', open);
    if (close == std::string_view::npos) {
      filled += text.substr(open);
      break;
    }
    const auto value = placeholder_text(text.substr(open + 1, close - open - 1), error);
    filled += value ? *value : std::string(text.substr(open, close - open + 1));
    text.remove_prefix(close + 1);
  }
  return filled;
}

std::string describe(const Error& error) {
  const auto text = error_template(error.code);
  const bool names_file =
      text.find("{file}") != std::string_view::npos || text.find("{where}") != std::string_view::npos;
  auto sentence = fill_error_template(text, error);
  if (!names_file && !error.file.empty()) return where_text(error) + ": " + sentence;
  return sentence;
}

}  // namespace syncline
