// SPDX-License-Identifier: Apache-2.0
#include "trace/stability_mask.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "trace/stability.h"

namespace syncline {
namespace {

/// Beyond what anybody observes, s.
constexpr double kShortestTau = 1e-9, kLongestTau = 1e9;

std::string_view without_blanks(std::string_view text) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// "250ns", "0.5 ms", "1e-3": a number and what follows it.
struct NumberWithUnit {
  double number = 0;
  std::string_view unit;
};

/// Takes one off the front of `text`.
std::optional<NumberWithUnit> take_number(std::string_view& text) {
  text = without_blanks(text);
  NumberWithUnit taken;
  const auto* const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, taken.number);
  if (error != std::errc() || !(taken.number > 0) || !std::isfinite(taken.number)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(behind - text.data()));
  // A unit may stand behind a blank; another number does not.
  auto rest = without_blanks(text);
  const auto is_unit = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; };
  const auto length = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_unit) - rest.begin());
  taken.unit = rest.substr(0, length);
  rest.remove_prefix(length);
  text = rest;
  return taken;
}

/// How many are in a second, which keeps "1 ms" what 1e-3 is; nothing where it is no unit of time.
std::optional<double> in_a_second(std::string_view unit) {
  if (unit == "s") return 1;
  if (unit == "ms") return 1e3;
  if (unit == "us" || unit == "\u00B5s" || unit == "\u03BCs") return 1e6;
  return unit == "ns" ? std::optional(1e9) : std::nullopt;
}

std::optional<double> mask_tau_of(const NumberWithUnit& taken) {
  const auto unit = taken.unit.empty() ? std::optional(1.0) : in_a_second(taken.unit);
  if (!unit) return std::nullopt;
  return taken.number / *unit;
}

std::optional<double> mask_value_of(const NumberWithUnit& taken, StabilityFigure figure) {
  if (figure == StabilityFigure::kAdev) return taken.unit.empty() ? std::optional(taken.number) : std::nullopt;
  if (taken.unit.empty()) return taken.number;
  const auto unit = in_a_second(taken.unit);
  if (!unit) return std::nullopt;
  return taken.number * (1e9 / *unit);
}

std::optional<StabilityMask::Point> mask_point_of(std::string_view text, StabilityFigure figure) {
  const auto first = take_number(text);
  if (!first) return std::nullopt;
  if (without_blanks(text).empty()) {
    const auto value = mask_value_of(*first, figure);
    return value ? std::optional(StabilityMask::Point{0, *value}) : std::nullopt;
  }
  const auto second = take_number(text);
  if (!second || !without_blanks(text).empty()) return std::nullopt;
  const auto tau = mask_tau_of(*first);
  const auto value = mask_value_of(*second, figure);
  return tau && value ? std::optional(StabilityMask::Point{*tau, *value}) : std::nullopt;
}

}  // namespace

double figure_of(const StabilityPoint& point, StabilityFigure figure) {
  if (figure == StabilityFigure::kAdev) return point.adev;
  return figure == StabilityFigure::kTdev ? point.tdev : point.mtie;
}

std::optional<double> StabilityMask::at(double tau) const {
  if (points.empty()) return std::nullopt;
  if (points.size() == 1) return points.front().value;
  // Samples come every 4.9998 ms and not every 5: who asks something at 5 ms means them.
  constexpr double kNearly = 0.01;
  if (tau < points.front().tau * (1 - kNearly) || tau > points.back().tau * (1 + kNearly)) return std::nullopt;
  auto right = std::ranges::lower_bound(points, tau, {}, &Point::tau);
  if (right == points.begin()) return points.front().value;
  if (right == points.end()) return points.back().value;
  const auto& left = *std::prev(right);
  const double part = std::log(tau / left.tau) / std::log(right->tau / left.tau);
  return left.value * std::pow(right->value / left.value, part);
}

StabilityMask mask_of_limit(double limit, StabilityFigure figure, double unit) {
  StabilityMask mask;
  if (limit <= 0) return mask;
  for (const double tau : {kShortestTau, kLongestTau})
    mask.points.push_back({tau, figure_of(stability_bound(limit, tau, unit), figure)});
  return mask;
}

Result<StabilityMask> parse_mask(std::string_view text, StabilityFigure figure) {
  StabilityMask mask;
  while (!without_blanks(text).empty()) {
    const auto end = std::min(text.find(';'), text.size());
    const auto part = without_blanks(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (part.empty()) continue;
    const auto point = mask_point_of(part, figure);
    const bool rises = point && (mask.empty() || (point->tau > mask.points.back().tau && mask.points.back().tau > 0));
    if (!rises) return fail(ErrorCode::kBadValue, std::string(part));
    mask.points.push_back(*point);
  }
  return mask;
}

MaskVerdict hold_against(std::span<const StabilityPoint> points, StabilityFigure figure, const StabilityMask& mask) {
  MaskVerdict verdict;
  for (const auto& point : points) {
    const double value = figure_of(point, figure);
    const auto allowed = mask.at(point.tau);
    if (!allowed || std::isnan(value)) continue;
    ++verdict.compared;
    const MaskVerdict::Place place{point.tau, value, *allowed};
    if (value > *allowed) verdict.beyond.push_back(place);
    if (!verdict.tightest || place.ratio() > verdict.tightest->ratio()) verdict.tightest = place;
  }
  return verdict;
}

}  // namespace syncline
