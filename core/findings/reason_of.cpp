// SPDX-License-Identifier: Apache-2.0
#include "findings/reason_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "findings/figure.h"
#include "findings/finding.h"
#include "protocol/al_state.h"
#include "reasons/because.h"
#include "reasons/placeholder.h"

namespace syncline {
namespace {

Reason said(const Figure& figure) { return figure.reason.empty() ? Reason::phrase(figure.text) : figure.reason; }

Reason reason_of(const Figure& figure) {
  using In = Figure::Unit;
  switch (figure.unit) {
    case In::kPhrase:
      return said(figure);
    case In::kAside: {
      auto inside = said(figure);
      return inside.empty() ? inside : because(": {reason}", std::move(inside));
    }
    case In::kAlCode: {
      const auto code = static_cast<std::uint16_t>(figure.value);
      return because("{code} ({meaning})", fmt::format("0x{:04X}", code),
                     Reason::phrase(al_status_code_text(code).meaning));
    }
    default:
      return Reason::verbatim(figure_text(figure));
  }
}

Reason filled_as_it_ends(std::string_view words, const Finding& finding) {
  std::vector<Reason> given;
  for (auto place = next_place(words); place.end > place.open;) {
    const auto figure = std::ranges::find(finding.figures, place.in(words).name, &Figure::name);
    given.push_back(figure == finding.figures.end() ? Reason() : reason_of(*figure));
    const auto next = next_place(words.substr(place.end));
    place = {place.end + next.open, place.end + next.end};
  }
  return Reason::of_words(words, std::move(given));
}

/// A row's sentence, with its full stop.
Reason filled(std::string_view words, const Finding& finding) {
  auto sentence = filled_as_it_ends(words, finding);
  const auto text = sentence.text();
  const bool ends = !text.empty() && std::string_view(".!?:").find(text.back()) != std::string_view::npos;
  return ends ? sentence : because("{sentence}.", std::move(sentence));
}

bool is_row(std::string_view words) {
  return std::ranges::any_of(all_finding_words(), [&](const FindingWords& row) {
    return row.mend == words || std::ranges::find(row.facts, words, &FindingWords::Facts::text) != std::end(row.facts);
  });
}

}  // namespace

Reason reason_of(const Finding& finding) {
  auto facts = filled(facts_template(finding), finding);
  const FindingWords* row = find_finding_words(finding.code);
  if (row == nullptr || row->mend.empty()) return facts;
  return because("{sentence} {next}", std::move(facts), filled(row->mend, finding));
}

Reason facts_reason(const Finding& finding) { return filled_as_it_ends(facts_template(finding), finding); }

std::optional<Reason> reason_of_any_words(std::string_view words, std::vector<Reason> given) {
  if (given.empty() || !is_row(words) || places_of_reason(words) != given.size())
    return reason_of_words(words, std::move(given));
  return Reason::of_words(words, std::move(given));
}

}  // namespace syncline
