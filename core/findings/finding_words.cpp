// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <vector>

#include "findings/difference_words.h"
#include "findings/eni_words.h"
#include "findings/error_words.h"
#include "findings/event_words.h"
#include "findings/finding.h"
#include "findings/project_words.h"
#include "findings/recording_words.h"
#include "findings/run_bus_words.h"
#include "findings/run_slaves_words.h"
#include "findings/scan_words.h"

namespace syncline {
namespace {

constexpr auto kRun = words::joined(words::kRunSlaves, words::kRunBus);
constexpr auto kTold =
    words::joined(words::kScan, words::kDifferences, words::kFileErrors, words::kBusErrors, words::kRecording);

const std::vector<FindingWords>& all() {
  static const std::vector<FindingWords> rows = [] {
    std::vector<FindingWords> joined(words::kEni.begin(), words::kEni.end());
    joined.insert(joined.end(), words::kProject.begin(), words::kProject.end());
    joined.insert(joined.end(), kRun.begin(), kRun.end());
    joined.insert(joined.end(), words::kEvents.begin(), words::kEvents.end());
    joined.insert(joined.end(), kTold.begin(), kTold.end());
    return joined;
  }();
  return rows;
}

const std::vector<const FindingWords*>& by_code() {
  static const std::vector<const FindingWords*> sorted = [] {
    std::vector<const FindingWords*> rows;
    for (const FindingWords& row : all()) rows.push_back(&row);
    std::ranges::sort(rows, {}, &FindingWords::code);
    return rows;
  }();
  return sorted;
}

}  // namespace

std::span<const FindingWords> all_finding_words() { return all(); }

const FindingWords* find_finding_words(std::string_view code) {
  const auto& rows = by_code();
  const auto found = std::ranges::lower_bound(rows, code, {}, &FindingWords::code);
  return found == rows.end() || (*found)->code != code ? nullptr : *found;
}

std::string_view sentence_of(const FindingWords& words, std::string_view variant) {
  const auto* const found = std::ranges::find_if(words.facts, [variant](const FindingWords::Facts& facts) {
    return facts.variant == variant && !facts.text.empty();
  });
  return found == std::end(words.facts) ? std::string_view{} : found->text;
}

}  // namespace syncline
