// SPDX-License-Identifier: Apache-2.0
#include "record/typed_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

#include "findings/finding.h"
#include "reasons/placeholder.h"
#include "record/event_fields.h"

namespace syncline {

template <>
inline constexpr int kLargest<Severity> = static_cast<int>(Severity::kError);
template <>
inline constexpr int kLargest<PlaceKind> = static_cast<int>(PlaceKind::kOutput);
template <>
inline constexpr int kLargest<Figure::Unit> = static_cast<int>(Figure::Unit::kNumber);

namespace {

constexpr std::size_t kMostFigures = 64;

struct WriteEvent {
  ValueWriter& out;
  template <class... Fields>
  void operator()(int number, const Fields&... fields) const {
    out(number, fields...);
  }
};

struct NumberOf {
  int& number;
  template <class... Fields>
  void operator()(int of_kind, const Fields&...) const {
    number = of_kind;
  }
};

struct ReadEvent {
  ValueReader& in;
  template <class... Fields>
  void operator()(int, Fields&... fields) const {
    in(fields...);
  }
};

/// The kind of this number, with nothing in it yet.
template <std::size_t index = 0>
std::optional<EventDetails> kind_of_number(int wanted) {
  if constexpr (index == std::variant_size_v<EventDetails>) {
    return std::nullopt;
  } else {
    std::variant_alternative_t<index, EventDetails> kind{};
    int number = 0;
    EventFields<NumberOf>{{number}}(kind);
    if (number == wanted) return EventDetails(kind);
    return kind_of_number<index + 1>(wanted);
  }
}

/// A figure's name lives as long as the program, as those of the finders do.
std::optional<std::string_view> lasting(const std::string& name) {
  constexpr std::size_t kMostNames = 4096, kLongest = 64;
  static std::mutex mutex;
  static std::set<std::string> names;
  const std::lock_guard lock(mutex);
  if (const auto found = names.find(name); found != names.end()) return *found;
  if (names.size() >= kMostNames || name.size() > kLongest) return std::nullopt;
  return *names.insert(name).first;
}

template <class Use, class Place>
void place_fields(Use& use, Place& place) {
  use(place.slave, place.key, place.part.kind, place.part.first, place.part.second, place.part.third, place.file,
      place.line, place.path);
}

/// How a finding's sentence is named: "/" and its variant, "" for the row's first one.
std::string sentence_name(const Finding& finding) {
  const auto* words = finding.facts.empty() ? nullptr : find_finding_words(finding.code);
  if (words == nullptr) return std::string(finding.facts);
  const auto* const found = std::ranges::find(words->facts, finding.facts, &FindingWords::Facts::text);
  return found == std::end(words->facts) ? std::string(finding.facts) : fmt::format("/{}", found->variant);
}

/// The row's sentence of that name, as it is worded today. Older programs recorded the sentence itself.
std::optional<std::string_view> recorded_sentence(const FindingWords& words, std::string_view name) {
  if (name.empty()) return std::string_view();
  if (name.starts_with('/')) {
    const auto text = sentence_of(words, name.substr(1));
    return text.empty() ? std::nullopt : std::optional(text);
  }
  const auto* const found = std::ranges::find(words.facts, name, &FindingWords::Facts::text);
  return found == std::end(words.facts) ? std::nullopt : std::optional(found->text);
}

/// Other words may want figures that were not recorded.
bool is_filled(std::string_view words, const std::vector<Figure>& figures) {
  for (auto open = words.find('{'); open != std::string_view::npos; open = words.find('{', open + 1)) {
    const Placeholder placeholder(words.substr(open + 1, words.find('}', open) - open - 1));
    if (std::ranges::find(figures, placeholder.name, &Figure::name) == figures.end()) return false;
  }
  return true;
}

}  // namespace

std::string encode_event(const EventDetails& what) {
  ValueWriter out;
  auto copy = what;  // one table of fields serves both ways
  std::visit(EventFields<WriteEvent>{{out}}, copy);
  return out.take();
}

std::optional<EventDetails> decode_event(std::string_view bytes) {
  ValueReader in(bytes);
  int number = 0;
  in(number);
  auto what = in.good() ? kind_of_number(number) : std::nullopt;
  if (!what) return std::nullopt;
  std::visit(EventFields<ReadEvent>{{in}}, *what);
  if (!in.good()) return std::nullopt;
  return what;
}

std::string encode_finding(const Finding& finding) {
  ValueWriter out;
  out(finding.code, finding.severity, sentence_name(finding), finding.from, finding.to);
  place_fields(out, finding.place);
  out(finding.figures.size());
  for (const auto& figure : finding.figures) {
    out(figure.name, figure.unit, figure.value, figure.other,
        figure.reason.empty() ? figure.text : figure.reason.text());
  }
  return out.take();
}

std::optional<Finding> decode_finding(std::string_view bytes) {
  ValueReader in(bytes);
  Finding finding;
  std::string code, name;
  std::uint64_t figures = 0;
  in(code, finding.severity, name, finding.from, finding.to);
  place_fields(in, finding.place);
  in(figures);
  const auto* words = in.good() && figures <= kMostFigures ? find_finding_words(code) : nullptr;
  if (words == nullptr) return std::nullopt;
  const auto sentence = recorded_sentence(*words, name);
  if (!sentence) return std::nullopt;
  finding.code = words->code;
  finding.facts = *sentence;
  for (std::uint64_t i = 0; i < figures; ++i) {
    Figure figure;
    std::string figure_name;
    in(figure_name, figure.unit, figure.value, figure.other, figure.text);
    const auto lives = in.good() ? lasting(figure_name) : std::nullopt;
    if (!lives) return std::nullopt;
    figure.name = *lives;
    finding.figures.push_back(std::move(figure));
  }
  const bool whole = is_filled(facts_template(finding), finding.figures) && is_filled(words->mend, finding.figures);
  return whole ? std::optional(std::move(finding)) : std::nullopt;
}

}  // namespace syncline
