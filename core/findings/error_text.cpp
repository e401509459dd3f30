// SPDX-License-Identifier: Apache-2.0
#include "findings/error_text.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "findings/error_words.h"
#include "findings/joined_words.h"
#include "findings/reason_of.h"
#include "protocol/al_state.h"
#include "protocol/coe.h"
#include "protocol/foe.h"
#include "reasons/because.h"
#include "reasons/placeholder.h"

namespace syncline {
namespace {

using Unit = Figure::Unit;

constexpr auto kErrors = words::joined(words::kFileErrors, words::kBusErrors);

constexpr std::string_view name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kFileNotFound:
      return "file-not-found";
    case ErrorCode::kFileNotReadable:
      return "file-not-readable";
    case ErrorCode::kFileNotWritable:
      return "file-not-writable";
    case ErrorCode::kXmlMalformed:
      return "xml-malformed";
    case ErrorCode::kXmlMissingElement:
      return "xml-element-missing";
    case ErrorCode::kXmlBadValue:
      return "xml-value";
    case ErrorCode::kNotThatKindOfFile:
      return "other-kind-of-file";
    case ErrorCode::kTomlMalformed:
      return "toml-malformed";
    case ErrorCode::kScenarioKey:
      return "scenario-key";
    case ErrorCode::kUnknownDevice:
      return "unknown-device";
    case ErrorCode::kMissingEsi:
      return "no-esi";
    case ErrorCode::kUnknownKey:
      return "unknown-key";
    case ErrorCode::kBadValue:
      return "bad-value";
    case ErrorCode::kConfiguration:
      return "configuration";
    case ErrorCode::kLinkNotFound:
      return "link-not-found";
    case ErrorCode::kLinkDown:
      return "link-down";
    case ErrorCode::kLinkPermission:
      return "link-permission";
    case ErrorCode::kLinkIo:
      return "link-io";
    case ErrorCode::kNotSupported:
      return "not-supported";
    case ErrorCode::kNoResponse:
      return "no-response";
    case ErrorCode::kWorkingCounter:
      return "unexpected-working-counter";
    case ErrorCode::kSlaveCount:
      return "slave-count";
    case ErrorCode::kIdentityMismatch:
      return "other-device";
    case ErrorCode::kAlState:
      return "state-refused";
    case ErrorCode::kAlTimeout:
      return "state-not-reached";
    case ErrorCode::kMailboxTimeout:
      return "mailbox-timeout";
    case ErrorCode::kMailboxProtocol:
      return "mailbox-answer";
    case ErrorCode::kSdoAbort:
      return "sdo-abort";
    case ErrorCode::kSii:
      return "eeprom-unusable";
    case ErrorCode::kInitCmdValidation:
      return "init-command-refused";
    case ErrorCode::kMalformedData:
      return "malformed-data";
    case ErrorCode::kDcSetup:
      return "clocks-not-set-up";
    case ErrorCode::kDcmOutOfLimit:
      return "dcm-out-of-limit";
    case ErrorCode::kTimeout:
      return "took-too-long";
    case ErrorCode::kCancelled:
      return "cancelled";
    case ErrorCode::kScanScope:
      return "not-read";
    case ErrorCode::kSlaveMissing:
      return "slave-missing";
    case ErrorCode::kSlaveExtra:
      return "slave-extra";
    case ErrorCode::kSlavesSwapped:
      return "slaves-swapped";
    case ErrorCode::kFileTransfer:
      return "file-transfer";
    case ErrorCode::kFileLimit:
      return "file-limit";
    case ErrorCode::kCatalogue:
      return "device-catalogue";
  }
  return {};
}

constexpr std::optional<std::size_t> row_of(ErrorCode code) {
  for (std::size_t i = 0; i < kErrors.size(); ++i) {
    if (kErrors[i].code == name_of(code)) return i;
  }
  return std::nullopt;
}

constexpr bool all_have_words() {
  for (int code = 0; code <= static_cast<int>(ErrorCode::kCatalogue); ++code) {
    if (!row_of(static_cast<ErrorCode>(code))) return false;
  }
  return name_of(static_cast<ErrorCode>(static_cast<int>(ErrorCode::kCatalogue) + 1)).empty();
}
static_assert(all_have_words(), "an ErrorCode without words, or behind the last one that is looked at here");

std::string where_text(const Error& error) {
  return error.line > 0 ? fmt::format("{}:{}", error.file, error.line) : error.file;
}

std::string_view code_meaning(const Error& error) {
  const auto code = static_cast<std::uint32_t>(error.received);
  return error.code == ErrorCode::kFileTransfer ? foe::error_text(code) : coe::abort_code_text(code);
}

std::optional<Figure> figure_of(std::string_view name, const Error& error) {
  const auto al_status = [&](std::int64_t value) { return Figure{name, Unit::kAlStatus, value}; };
  const auto text = [&](std::string value) { return Figure{name, Unit::kText, 0, 0, std::move(value)}; };
  const auto phrase = [&](std::string_view value) { return Figure{name, Unit::kPhrase, 0, 0, std::string(value)}; };
  if (name == "subject") return text(error.subject);
  if (name == "detail") return Figure{name, Unit::kPhrase, 0, 0, {}, error.detail};
  if (name == "because") return Figure{name, Unit::kAside, 0, 0, {}, error.detail};
  if (name == "file") return text(error.file);
  if (name == "where") return text(where_text(error));
  if (name == "expected") return Figure{name, Unit::kCount, error.expected};
  if (name == "received") return Figure{name, Unit::kCount, error.received};
  if (name == "state") return al_status(error.expected);
  if (name == "actual") return al_status(error.received);
  if (name == "alcode") return Figure{name, Unit::kAlCode, error.extra};
  if (name == "check") return phrase(al_status_code_text(static_cast<std::uint16_t>(error.extra)).check);
  if (name == "code")
    return Figure{name, error.code == ErrorCode::kFileTransfer ? Unit::kHex16 : Unit::kHex32, error.received};
  if (name == "meaning") return phrase(code_meaning(error));
  if (name == "error") return Figure{name, Unit::kNanoseconds, error.received};
  if (name == "limit") return Figure{name, Unit::kNanoseconds, error.expected};
  return std::nullopt;
}

void add_figures(std::string_view text, const Error& error, Finding& finding) {
  for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const Placeholder placeholder(text.substr(open + 1, text.find('}', open) - open - 1));
    if (auto figure = figure_of(placeholder.name, error)) finding.figures.push_back(std::move(*figure));
  }
}

std::string_view variant_of(const Error& error) {
  const bool unchecked =
      error.code == ErrorCode::kAlState && al_status_code_text(static_cast<std::uint16_t>(error.extra)).check.empty();
  return unchecked ? "unchecked" : "";
}

}  // namespace

Finding finding_of(const Error& error) {
  const FindingWords& row = kErrors[row_of(error.code).value_or(0)];
  Finding finding{row.code, row.severity};
  finding.place.file = error.file;
  finding.place.line = error.line;
  finding.facts = sentence_of(row, variant_of(error));
  add_figures(finding.facts, error, finding);
  add_figures(row.mend, error, finding);
  return finding;
}

Reason reason_of(const Error& error) {
  const auto finding = finding_of(error);
  const auto said = [&](std::string_view placeholder) {
    return finding.facts.find(placeholder) != std::string_view::npos;
  };
  auto sentence = reason_of(finding);
  if (error.file.empty() || said("{file}") || said("{where}")) return sentence;
  return because("{place}: {reason}", where_text(error), std::move(sentence));
}

std::string describe(const Error& error) { return reason_of(error).text(); }

}  // namespace syncline
