// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findings/figure.h"
#include "findings/place.h"

/// What is wrong, or worth knowing: in a file, a project, a difference, a run. Each with its place, the figures that
/// prove it, why it matters and what to do.
namespace syncline {

enum class Severity : std::uint8_t { kNote, kWarning, kError };
[[nodiscard]] std::string_view severity_name(Severity severity);  // "note", "warning", "error"

struct Finding {
  std::string_view code;  // stable name for programs: "ENI-DC-03", "frames-lost-by-noise"; has a row of words
  Severity severity = Severity::kNote;
  Place place{};
  Nanoseconds from = 0, to = 0;  // when, host clock; 0: the whole run, or no run
  std::vector<Figure> figures{};
  std::string_view facts{};  // one of the row's sentences; "": its first
  bool operator==(const Finding&) const = default;
};

[[nodiscard]] bool has_errors(std::span<const Finding> findings);
/// "slave.N.dc.op_mode" of slave 3 is "slave.3.dc.op_mode"; "" where the key is one of a slave and there is none.
[[nodiscard]] std::string setting_at(std::string_view key, int slave);

/// The words of a code, in English with {placeholders}; translations and docs/check.md are made from them.
struct FindingWords {
  struct Facts {
    std::string_view variant;  // "" = the usual one; a finder names another as "code/variant"
    std::string_view text;
  };
  static constexpr std::size_t kMostFacts = 7;

  std::string_view code;
  Severity severity = Severity::kNote;  // what it usually is; a finder of runs weighs by size
  std::string_view title;               // what is found, in a line
  std::string_view why;                 // what goes wrong on the machine
  std::string_view mend;                // what to do about it
  std::string_view setting{};           // the setting that cures it: "slave.N.dc.op_mode", "master.cycle_time_us"
  Facts facts[kMostFacts]{};            // what was seen, by variant
};

/// The row of a code; every finding's code has one.
[[nodiscard]] const FindingWords* find_finding_words(std::string_view code);
/// What a finding of this row says in a variant; "" where the row has none of this name.
[[nodiscard]] std::string_view sentence_of(const FindingWords& words, std::string_view variant);
/// All rows, family by family: the ENI's rules in the order of docs/check.md first.
[[nodiscard]] std::span<const FindingWords> all_finding_words();
/// Words of ours that figures bring into the sentences: what units kPhrase, kAside and kAlCode say, and the
/// rows of core/reasons, which have placeholders of their own.
[[nodiscard]] std::span<const std::string_view> finding_phrases();

/// The finding's sentence with {placeholders}.
[[nodiscard]] std::string_view facts_template(const Finding& finding);
/// Fills a (possibly translated) template with the figures. Unknown placeholders stay.
[[nodiscard]] std::string fill_finding_template(std::string_view text, const Finding& finding);
/// True when a template begins with somebody's own text (a file, a key), which keeps its first letter as it is.
[[nodiscard]] bool begins_with_own_text(std::string_view text, const Finding& finding);
/// English: what was seen, as it is set behind a place: "no cyclic BRD reads 0x0130".
[[nodiscard]] std::string facts_text(const Finding& finding);
/// English sentences: what was seen, why, and what to do.
[[nodiscard]] std::string describe(const Finding& finding);

}  // namespace syncline
