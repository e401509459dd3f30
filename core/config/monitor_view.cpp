// SPDX-License-Identifier: Apache-2.0
#include "config/monitor_view.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace syncline {
namespace {

constexpr std::array<std::string_view, 3> kScales{"linear", "signed-log", "log"};
constexpr std::array<std::string_view, 3> kOwners{"bus", "slave", "variable"};

/// By the number of the enumerator.
template <class Enum>
std::optional<Enum> named(const std::array<std::string_view, 3>& names, std::string_view name) {
  const auto* const found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace

std::string_view value_scale_name(ValueScale scale) { return kScales.at(static_cast<std::size_t>(scale)); }

std::optional<ValueScale> value_scale_from_name(std::string_view name) { return named<ValueScale>(kScales, name); }

std::string_view view_signal_of_name(ViewSignal::Of of) { return kOwners.at(static_cast<std::size_t>(of)); }

std::optional<ViewSignal::Of> view_signal_of_from_name(std::string_view name) {
  return named<ViewSignal::Of>(kOwners, name);
}

std::optional<AxisLimits> axis_limits_from_text(std::string_view text) {
  AxisLimits limits;
  const char* const end = text.data() + text.size();
  const auto low = std::from_chars(text.data(), end, limits.low);
  if (low.ec != std::errc{} || low.ptr == end || *low.ptr != ' ') return std::nullopt;
  const auto high = std::from_chars(low.ptr + 1, end, limits.high);
  if (high.ec != std::errc{} || high.ptr != end) return std::nullopt;
  if (!std::isfinite(limits.low) || !std::isfinite(limits.high) || !(limits.low < limits.high)) return std::nullopt;
  return limits;
}

}  // namespace syncline
