// SPDX-License-Identifier: Apache-2.0
#include "findings/finding_list.h"

#include <utility>

#include "findings/eni_structure_words.h"
#include "findings/sentence.h"

namespace syncline {

FindingList FindingList::unbounded() {
  FindingList list;
  list.most_of_rule_ = list.most_in_all_ = std::numeric_limits<std::size_t>::max();
  return list;
}

bool FindingList::has_room(std::string_view code) const {
  const auto found = of_rule_.find(code);
  return found == of_rule_.end() || (found->second < most_of_rule_ && kept_.size() < most_in_all_);
}

void FindingList::add(Finding finding) {
  if (!has_room(finding.code)) return left_out_.add(finding.severity);
  ++of_rule_[finding.code];
  kept_.push_back(std::move(finding));
}

std::vector<Finding> FindingList::take_kept() { return std::exchange(kept_, {}); }

std::optional<Finding> FindingList::rest() const {
  if (left_out_.all() == 0) return std::nullopt;
  auto finding = make_finding<words::kEniStructure>("ENI-XML-10", Place(), fig::count<"count">(left_out_.all()));
  for (const auto severity : {Severity::kNote, Severity::kWarning, Severity::kError}) {
    if (left_out_[severity] > 0) finding.severity = severity;
  }
  return finding;
}

}  // namespace syncline
