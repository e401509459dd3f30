// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "findings/finding.h"
#include "protocol/al_state.h"

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
  if (figure.other <= figure.value) return fmt::format("slave {}", figure.value);
  return fmt::format("slaves {} to {}", figure.value, figure.other);
}

}  // namespace

std::string figure_text(const Figure& figure) {
  using Unit = Figure::Unit;
  switch (figure.unit) {
    case Unit::kCount:
      return fmt::format("{}{}", figure.text.empty() ? "" : "at least ", figure.value);
    case Unit::kTimes:
      if (figure.value == 1 && figure.text.empty()) return "once";
      return fmt::format("{}{} times", figure.text.empty() ? "" : "at least ", figure.value);
    case Unit::kNanoseconds:
      return duration(figure.value);
    case Unit::kMoment:
      return fmt::format("{:.3f} s", static_cast<double>(figure.value) / 1e9);
    case Unit::kPpm:
      return fmt::format("{:.1f} ppm", static_cast<double>(figure.value) / 1e3);
    case Unit::kSlave:
      return slaves(figure);
    case Unit::kPort:
      return std::string(1, static_cast<char>('A' + (figure.value & 3)));
    case Unit::kHex16:
      return fmt::format("0x{:04X}", figure.value);
    case Unit::kHex32:
      return fmt::format("0x{:08X}", figure.value);
    case Unit::kAlStatus: {
      const auto status = static_cast<std::uint16_t>(figure.value);
      return std::string(al_state_name(al_state_of(status))) + ((status & kAlErrorFlag) != 0 ? "+ERR" : "");
    }
    case Unit::kText:
      return figure.text;
  }
  return {};
}

std::string fill_finding_template(std::string_view text, const RunFinding& finding) {
  std::string out;
  while (!text.empty()) {
    const auto open = text.find('{');
    const auto close = text.find('}', open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    out += text.substr(0, open);
    const auto name = text.substr(open + 1, close - open - 1);
    const auto found = std::ranges::find(finding.figures, name, &Figure::name);
    out += found == finding.figures.end() ? std::string(text.substr(open, close - open + 1)) : figure_text(*found);
    text.remove_prefix(close + 1);
  }
  out += text;
  if (!out.empty() && out.front() >= 'a' && out.front() <= 'z')
    out.front() = static_cast<char>(out.front() - 'a' + 'A');
  return out;
}

std::string describe(const RunFinding& finding) {
  const auto words = finding_words(finding.code);
  auto text = fill_finding_template(words.why, finding);
  if (!words.mend.empty()) text += " " + fill_finding_template(words.mend, finding);
  return text;
}

}  // namespace syncline
