// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reports/svg_drawing.h"
#include "support/types.h"

namespace syncline {
class HeldSeries;
class Histogram;
class MinMaxSeries;
struct Outage;
}  // namespace syncline

/// Drawings of a run as SVG without a head of a file of its own, light, for a page of A4.
namespace syncline::reports {

struct CourseOf {
  const MinMaxSeries& series;
  Nanoseconds begin = 0, end = 0;  // host clock
  double limit = 0;                // magnitude, in the signal's unit; 0: none
  bool is_signed = false;          // zero is in the middle
  std::string_view unit = "ns";
  std::string_view title = "course over time";  // for who does not see it
  const HeldSeries* held = nullptr;             // a count: its values hold until the next one
  std::span<const Outage> outages{};            // shaded
  std::span<const Nanoseconds> faults{};        // marked at the foot, by time
  std::optional<Nanoseconds> origin{};          // what the axis counts from; nothing: its begin
  SvgFrame frame{};
};
/// Smallest to largest value of each column, a pixel wide, over time, with the limit dashed: no single value is left
/// out. Gaps stay gaps. Empty where there is no value.
[[nodiscard]] std::string course_svg(const CourseOf& course);

/// How often which magnitude came, both logarithmic, with the limit (0: none) dashed. Empty without a value.
[[nodiscard]] std::string histogram_svg(const Histogram& histogram, double limit);

}  // namespace syncline::reports
