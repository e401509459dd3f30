// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/types.h"

namespace syncline {
class Histogram;
class MinMaxSeries;
}  // namespace syncline

/// Drawings of a run as SVG without a head of a file of its own, light, for a page of A4.
namespace syncline::reports {

struct CourseOf {
  const MinMaxSeries& series;
  Nanoseconds begin = 0, end = 0;  // host clock
  double limit = 0;                // magnitude, in the signal's unit; 0: none
  bool is_signed = false;
};
/// Smallest to largest value of each of 600 columns over time, ns, with the limit dashed: no single value is left out.
/// Gaps stay gaps. Empty where there is no value.
[[nodiscard]] std::string course_svg(const CourseOf& course);

/// How often which magnitude came, both logarithmic, with the limit (0: none) dashed. Empty without a value.
[[nodiscard]] std::string histogram_svg(const Histogram& histogram, double limit);

}  // namespace syncline::reports
