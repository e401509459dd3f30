// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "findings/finding.h"
#include "findings/named_number.h"
#include "reasons/placeholder.h"

/// Findings whose words are looked up while compiling: a code without words, a placeholder that no figure fills, a
/// figure that no sentence shows and a count where the words name something do not compile.
namespace syncline {

template <std::size_t kSize>
struct FigureName {
  char text[kSize]{};
  bool counts = false;  // says how many
  // NOLINTNEXTLINE(google-explicit-constructor): fig::count<"bytes">(4).
  consteval FigureName(const char (&name)[kSize]) { std::copy_n(name, kSize, text); }
  [[nodiscard]] constexpr std::string_view view() const { return {text, kSize - 1}; }
};

/// The name of a figure that says how many.
template <std::size_t kSize>
[[nodiscard]] consteval FigureName<kSize> counted(FigureName<kSize> name) {
  name.counts = true;
  return name;
}

/// A figure that has its name in its type.
template <FigureName kName>
struct Named {
  static constexpr auto kText = kName;  // lives as long as the program
  Figure figure;
};

namespace fig {

template <FigureName kName>
[[nodiscard]] Named<kName> of(Figure::Unit unit, std::int64_t value, std::int64_t other = 0, std::string text = {}) {
  return {{Named<kName>::kText.view(), unit, value, other, std::move(text)}};
}
/// How many, which languages group by thousands; a balance may be below 0.
template <FigureName kName>
[[nodiscard]] Named<counted(kName)> count(std::integral auto value) {
  return of<counted(kName)>(Figure::Unit::kCount, static_cast<std::int64_t>(value));
}
/// What names something: a station address, an alias, a line, a bit of the image.
template <FigureName kName>
[[nodiscard]] Named<kName> number(std::integral auto value) {
  return of<kName>(Figure::Unit::kNumber, static_cast<std::int64_t>(value));
}
template <FigureName kName>
[[nodiscard]] Named<kName> time(Nanoseconds value) {
  return of<kName>(Figure::Unit::kTime, value);
}
template <FigureName kName>
[[nodiscard]] Named<kName> hex(std::uint64_t value, int digits = 4) {
  return of<kName>(Figure::Unit::kHex, static_cast<std::int64_t>(value), digits);
}
template <FigureName kName>
[[nodiscard]] Named<kName> hex16(std::uint64_t value) {
  return of<kName>(Figure::Unit::kHex16, static_cast<std::int64_t>(value));
}
template <FigureName kName>
[[nodiscard]] Named<kName> hex32(std::uint64_t value) {
  return of<kName>(Figure::Unit::kHex32, static_cast<std::int64_t>(value));
}
/// Measured: four digits.
template <FigureName kName>
[[nodiscard]] Named<kName> measured(Nanoseconds value) {
  return of<kName>(Figure::Unit::kNanoseconds, value);
}
/// "once", "3 times"
template <FigureName kName>
[[nodiscard]] Named<counted(kName)> times(std::uint64_t value) {
  return of<counted(kName)>(Figure::Unit::kTimes, static_cast<std::int64_t>(value));
}
template <FigureName kName>
[[nodiscard]] Named<kName> port(std::uint64_t value) {
  return of<kName>(Figure::Unit::kPort, static_cast<std::int64_t>(value));
}
/// Somebody's own text, which no language changes.
template <FigureName kName>
[[nodiscard]] Named<kName> text(std::string value) {
  return of<kName>(Figure::Unit::kText, 0, 0, std::move(value));
}
/// A word of ours: one of finding_phrases().
template <FigureName kName>
[[nodiscard]] Named<kName> phrase(std::string_view value) {
  return of<kName>(Figure::Unit::kPhrase, 0, 0, std::string(value));
}
/// ": a word of ours", or nothing.
template <FigureName kName>
[[nodiscard]] Named<kName> aside(std::string_view value) {
  return of<kName>(Figure::Unit::kAside, 0, 0, std::string(value));
}
/// Why something failed, from an Error.
template <FigureName kName>
[[nodiscard]] Named<kName> reason(Reason value) {
  return {{Named<kName>::kText.view(), Figure::Unit::kPhrase, 0, 0, {}, std::move(value)}};
}
/// "slave 3 (Drive)"
template <FigureName kName>
[[nodiscard]] Named<kName> slave(std::size_t position, std::string name = {}) {
  const auto at = static_cast<std::int64_t>(position);
  return of<kName>(Figure::Unit::kSlave, at, at, std::move(name));
}

}  // namespace fig

/// The words for a finding with these figures, from a table: "ENI-DC-10", or "ENI-DC-10/zero" for a variant.
template <const auto& kTable, FigureName... kNames>
class FindingSentence {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as with format strings.
  consteval FindingSentence(const char* key) {
    const std::string_view whole(key);
    const auto slash = whole.find('/');
    const auto variant = slash == std::string_view::npos ? std::string_view{} : whole.substr(slash + 1);
    for (std::size_t i = 0; i < std::size(kTable); ++i) {
      if (kTable[i].code == whole.substr(0, slash)) row_ = i;
    }
    if (row_ == std::size(kTable)) throw "no words for this code";
    for (std::size_t i = 0; i < FindingWords::kMostFacts; ++i) {
      if (kTable[row_].facts[i].variant == variant && !kTable[row_].facts[i].text.empty())
        facts_ = kTable[row_].facts[i].text;
    }
    if (facts_.empty()) throw "the code has no sentence of this variant";
    check_names(facts_);
    check_names(kTable[row_].mend);
    if (!(shows(kNames.view()) && ...)) throw "a figure that no sentence shows";
  }
  [[nodiscard]] const FindingWords& words() const { return kTable[row_]; }
  [[nodiscard]] std::string_view facts() const { return facts_; }

 private:
  static consteval void check_names(std::string_view text) {
    for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
      [[maybe_unused]] const auto name = Placeholder(text.substr(open + 1, text.find('}', open) - open - 1)).name;
      if (!((name == kNames.view()) || ...)) throw "a placeholder without a figure";
      if (((kNames.counts && name == kNames.view()) || ...) && names_something(text, open))
        throw "a count where the words name something: fig::number";
    }
  }
  static consteval bool shows_in(std::string_view text, std::string_view name) {
    for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
      const auto end = at + name.size();
      if (at > 0 && text[at - 1] == '{' && end < text.size() && (text[end] == '}' || text[end] == ':')) return true;
    }
    return false;
  }
  [[nodiscard, maybe_unused]] consteval bool shows(std::string_view name) const {
    return shows_in(facts_, name) || shows_in(kTable[row_].mend, name);
  }

  // Not pointers: GCC's undefined-behaviour sanitizer takes comparisons of them out of what is constant (GCC bug
  // 71962).
  std::size_t row_ = std::size(kTable);
  std::string_view facts_;
};

/// A finding of the row's usual severity. Its key is the row's setting, for the place's slave.
template <const auto& kTable, FigureName... kNames>
[[nodiscard]] Finding make_finding(std::type_identity_t<FindingSentence<kTable, kNames...>> sentence, Place place,
                                   Named<kNames>... figures) {
  Finding finding{sentence.words().code, sentence.words().severity, std::move(place)};
  if (finding.place.key.empty()) finding.place.key = setting_at(sentence.words().setting, finding.place.slave);
  finding.figures.reserve(sizeof...(figures));
  (finding.figures.push_back(std::move(figures.figure)), ...);
  finding.facts = sentence.facts();
  return finding;
}

}  // namespace syncline
