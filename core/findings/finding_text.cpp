// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "findings/finding.h"
#include "protocol/al_state.h"
#include "reasons/placeholder.h"

namespace syncline {
namespace {

/// Three digits in the unit that suits the size.
std::string duration(std::int64_t ns) {
  const double value = static_cast<double>(ns);
  const double size = std::abs(value);
  if (size < 1e3) return fmt::format("{} ns", ns);
  if (size < 1e6) return fmt::format("{:.4g} us", value / 1e3);
  if (size < 1e9) return fmt::format("{:.4g} ms", value / 1e6);
  return fmt::format("{:.4g} s", value / 1e9);
}

std::string slaves(const Figure& figure) {
  if (figure.value == -1) return "the host";
  if (figure.value < 0) return "nobody in the configuration";
  if (figure.other > figure.value) return fmt::format("slaves {} to {}", figure.value, figure.other);
  return figure.text.empty() ? fmt::format("slave {}", figure.value)
                             : fmt::format("slave {} ({})", figure.value, figure.text);
}

std::string al_code(std::uint16_t code) {
  return fmt::format("0x{:04X} ({})", code, al_status_code_text(code).meaning);
}

const Figure* figure_named(const Finding& finding, std::string_view name) {
  const auto found = std::ranges::find(finding.figures, name, &Figure::name);
  return found == finding.figures.end() ? nullptr : &*found;
}

/// A whole number of thousandths without zeros at its end: "62.5".
std::string shortest_decimal(std::int64_t whole, std::int64_t rest, int digits) {
  auto text = fmt::format("{}.{:0{}}", whole, rest, digits);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string exact_time_text(Nanoseconds time) {
  const auto size = time < 0 ? 0 - static_cast<std::uint64_t>(time) : static_cast<std::uint64_t>(time);
  const auto sign = std::string(time < 0 ? "-" : "");
  const auto in = [&](std::uint64_t unit, int digits, const char* name) {
    return sign +
           shortest_decimal(static_cast<std::int64_t>(size / unit), static_cast<std::int64_t>(size % unit), digits) +
           name;
  };
  if (size < 1'000) return fmt::format("{} ns", time);
  if (size < 1'000'000) return in(1'000, 3, " us");
  if (size < 1'000'000'000) return in(1'000'000, 6, " ms");
  return in(1'000'000'000, 9, " s");
}

std::string figure_text(const Figure& figure) {
  using Unit = Figure::Unit;
  switch (figure.unit) {
    case Unit::kCount:
      return fmt::format("{}{}", figure.text.empty() ? "" : "at least ", figure.value);
    case Unit::kNumber:
      return fmt::format("{}", figure.value);
    case Unit::kTimes:
      return (figure.text.empty() ? "" : "at least ") +
             (figure.value == 1 ? std::string("once") : fmt::format("{} times", figure.value));
    case Unit::kNanoseconds:
      return duration(figure.value);
    case Unit::kTime:
      return exact_time_text(figure.value);
    case Unit::kMoment:
      return fmt::format("{:.3f} s", static_cast<double>(figure.value) / 1e9);
    case Unit::kPpm:
      return fmt::format("{:.1f} ppm", static_cast<double>(figure.value) / 1e3);
    case Unit::kSlave:
      return slaves(figure);
    case Unit::kSlaves:
      return "each of slaves " + figure.text;
    case Unit::kPort:
      return std::string(1, static_cast<char>('A' + (figure.value & 3)));
    case Unit::kHex16:
      return fmt::format("0x{:04X}", figure.value);
    case Unit::kHex32:
      return fmt::format("0x{:08X}", figure.value);
    case Unit::kHex:
      return fmt::format("0x{:0{}x}", figure.value, figure.other);
    case Unit::kAlStatus: {
      const auto status = static_cast<std::uint16_t>(figure.value);
      return std::string(al_state_name(al_state_of(status))) + ((status & kAlErrorFlag) != 0 ? "+ERR" : "");
    }
    case Unit::kAlCode:
      return al_code(static_cast<std::uint16_t>(figure.value));
    case Unit::kAside: {
      auto text = figure.reason.empty() ? figure.text : figure.reason.text();
      return text.empty() ? text : ": " + text;
    }
    case Unit::kPhrase:
      return figure.reason.empty() ? figure.text : figure.reason.text();
    case Unit::kText:
      return figure.text;
  }
  return {};
}

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "note";
}

bool has_errors(std::span<const Finding> findings) {
  return std::ranges::find(findings, Severity::kError, &Finding::severity) != findings.end();
}

std::string setting_at(std::string_view key, int slave) {
  constexpr std::string_view kSlave = "slave.N.";
  if (!key.starts_with(kSlave)) return std::string(key);
  return slave < 0 ? std::string() : fmt::format("slave.{}.{}", slave, key.substr(kSlave.size()));
}

std::string_view facts_template(const Finding& finding) {
  if (!finding.facts.empty()) return finding.facts;
  const FindingWords* words = find_finding_words(finding.code);
  return words == nullptr ? std::string_view{} : words->facts[0].text;
}

std::string fill_finding_template(std::string_view text, const Finding& finding) {
  std::string out;
  while (!text.empty()) {
    const auto open = text.find('{');
    const auto close = text.find('}', open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    out += text.substr(0, open);
    const Placeholder placeholder(text.substr(open + 1, close - open - 1));
    const Figure* found = figure_named(finding, placeholder.name);
    out += found == nullptr ? std::string(text.substr(open, close - open + 1))
                            : placeholder.filled(figure_text(*found), found->value == 1);
    text.remove_prefix(close + 1);
  }
  return out += text;
}

bool begins_with_own_text(std::string_view text, const Finding& finding) {
  if (!text.starts_with('{')) return false;
  const Figure* first = figure_named(finding, Placeholder(text.substr(1, text.find('}') - 1)).name);
  return first != nullptr && first->unit == Figure::Unit::kText;
}

std::string facts_text(const Finding& finding) { return fill_finding_template(facts_template(finding), finding); }

std::string describe(const Finding& finding) {
  const auto sentence = [&](std::string_view words) {
    auto text = fill_finding_template(words, finding);
    if (!text.empty() && !begins_with_own_text(words, finding) && text.front() >= 'a' && text.front() <= 'z')
      text.front() = static_cast<char>(text.front() - 'a' + 'A');
    // The rules of the checker are set behind a place, without an end of their own.
    if (!text.empty() && std::string_view(".!?:").find(text.back()) == std::string_view::npos) text += '.';
    return text;
  };
  auto text = sentence(facts_template(finding));
  const FindingWords* words = find_finding_words(finding.code);
  if (words != nullptr && !words->mend.empty()) text += " " + sentence(words->mend);
  return text;
}

}  // namespace syncline
