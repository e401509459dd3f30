// SPDX-License-Identifier: Apache-2.0
#include "reports/run_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "trace/held_series.h"
#include "trace/histogram.h"
#include "trace/min_max_series.h"
#include "trace/outages.h"

namespace syncline::reports {
namespace {

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= value) return step * decade;
  }
  return 10 * decade;
}

/// What the value axis shows, and from where.
struct ValueRange {
  double low = 0, high = 0;
};

/// With a limit and of what has a sign about zero, of what is near zero from zero on, else about the values.
ValueRange range_of(const CourseOf& course, const ValueRange& values) {
  double largest = std::max({course.limit, std::abs(values.low), std::abs(values.high)});
  if (largest == 0) largest = 1;
  if (course.is_signed || (course.limit > 0 && values.low < 0)) return {-round_up(largest), round_up(largest)};
  if (course.limit > 0 || (values.low >= 0 && values.low <= values.high / 2)) return {0, round_up(largest)};
  const double step = round_up(std::max((values.high - values.low) / 2, largest * 1e-6));
  const double low = std::floor(values.low / step) * step;
  return {low, low + std::max(std::ceil((values.high - low) / step), 2.0) * step};
}

/// The course's pixels.
class CourseMap {
 public:
  CourseMap(const CourseOf& course, const ValueRange& range)
      : frame_(course.frame),
        begin_(course.begin),
        span_(std::max<Nanoseconds>(course.end - course.begin, 1)),
        range_(range) {}
  [[nodiscard]] double x(Nanoseconds time) const {
    const auto part = static_cast<double>(time - begin_) / static_cast<double>(span_);
    return frame_.left + std::clamp(part, 0.0, 1.0) * frame_.inner_width();
  }
  [[nodiscard]] double y(double value) const {
    return frame_.top + (range_.high - value) / (range_.high - range_.low) * frame_.inner_height();
  }

 private:
  SvgFrame frame_;
  Nanoseconds begin_, span_;
  ValueRange range_;
};

/// A column for each pixel.
Nanoseconds columns_of(const CourseOf& course, std::vector<SeriesColumn>& columns) {
  const auto pixels = std::max<Nanoseconds>(std::llround(course.frame.inner_width()), 1);
  const auto span = std::max<Nanoseconds>(course.end - course.begin, 1);
  const auto width = (span + pixels - 1) / pixels;
  if (course.held != nullptr) {
    course.series.step_columns(course.begin, course.end + 1, width, course.held->heard(), columns);
  } else {
    course.series.columns(course.begin, course.end + 1, width, columns);
  }
  return width;
}

std::optional<ValueRange> values_of(std::span<const SeriesColumn> columns) {
  std::optional<ValueRange> range;
  for (const auto& column : columns) {
    if (!column.valid) continue;
    const ValueRange one{static_cast<double>(column.min), static_cast<double>(column.max)};
    range = range ? ValueRange{std::min(range->low, one.low), std::max(range->high, one.high)} : one;
  }
  return range;
}

/// As many digits as the stretch needs.
std::string time_label(Nanoseconds time, Nanoseconds span) {
  const double seconds = static_cast<double>(span) / 1e9;
  const int digits = std::clamp(3 - static_cast<int>(std::floor(std::log10(seconds))), 0, 9);
  auto text = fmt::format("{:.{}f}", static_cast<double>(time) / 1e9, digits);
  if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

void draw_axes(std::string& svg, const CourseOf& course, const CourseMap& map, const ValueRange& range) {
  const auto& frame = course.frame;
  for (const double tick : {range.low, (range.low + range.high) / 2, range.high}) {
    if (tick > range.low && tick < range.high)
      svg_line(svg, frame.left, map.y(tick), frame.end(), map.y(tick), kGridInk);
    const auto number = fmt::format("{:g}", tick);
    svg_label(svg, frame.left - 4, map.y(tick) + 3, "end",
              course.unit.empty() ? number : fmt::format("{} {}", number, course.unit));
  }
  const auto span = std::max<Nanoseconds>(course.end - course.begin, 1);
  const auto from = course.begin - course.origin.value_or(course.begin);
  const double foot = frame.height - 8;
  svg_label(svg, frame.left, foot, "start", time_label(from, span));
  svg_label(svg, frame.left + frame.inner_width() / 2, foot, "middle", time_label(from + span / 2, span));
  svg_label(svg, frame.end(), foot, "end", time_label(from + span, span));
}

void draw_limit(std::string& svg, const CourseOf& course, const CourseMap& map, const ValueRange& range) {
  if (course.limit <= 0) return;
  const auto& frame = course.frame;
  svg_line(svg, frame.left, map.y(course.limit), frame.end(), map.y(course.limit), kLimitInk, true);
  if (range.low < 0)
    svg_line(svg, frame.left, map.y(-course.limit), frame.end(), map.y(-course.limit), kLimitInk, true);
}

void draw_outages(std::string& svg, const CourseOf& course, const CourseMap& map) {
  for (const auto& outage : course.outages) {
    const auto from = map.x(outage.begin), width = std::max(map.x(outage.end) - from, 0.5);
    svg_area(svg, from, course.frame.top, width, course.frame.inner_height(), "#9aa5b1", 0.35);
  }
}

/// Triangles that point up; those that share a pixel are one.
void draw_faults(std::string& svg, const CourseOf& course, const CourseMap& map) {
  std::string path;
  double before = -1;
  for (const auto fault : course.faults) {
    if (fault < course.begin || fault > course.end) continue;
    const auto x = std::round(map.x(fault));
    if (std::exchange(before, x) == x) continue;
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}l-3 6h6z", x, course.frame.foot() - 7);
  }
  if (!path.empty()) svg_path(svg, path, kFaultInk);
}

}  // namespace

std::string course_svg(const CourseOf& course) {
  std::vector<SeriesColumn> columns;
  const auto width = columns_of(course, columns);
  const auto values = values_of(columns);
  if (!values) return {};
  const auto range = range_of(course, *values);
  const CourseMap map(course, range);
  auto svg = begin_svg(course.frame, course.title);
  draw_outages(svg, course, map);
  draw_axes(svg, course, map, range);
  std::string path;
  for (const auto& column : columns) {
    if (!column.valid) continue;
    const double high = map.y(static_cast<double>(column.max));
    const double height = std::max(map.y(static_cast<double>(column.min)) - high, 1.0);
    const double wide = std::max(map.x(column.start + width) - map.x(column.start), 0.5);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}h{:.2f}v{:.1f}h{:.2f}z", map.x(column.start), high, wide,
                   height, -wide);
  }
  svg_path(svg, path, kInk);
  draw_limit(svg, course, map, range);
  draw_faults(svg, course, map);
  return svg + "</svg>\n";
}

std::string histogram_svg(const Histogram& histogram, double limit) {
  const auto bins = histogram.bins();
  if (bins.empty()) return {};
  const SvgFrame frame;
  // 0 has a place of its own, left of 1.
  const double last = std::max(static_cast<double>(bins.back().high), limit);
  const double decades = std::max(std::ceil(std::log10(std::max(last, 10.0))), 1.0);
  const auto place = [&](double value) { return value < 1 ? -0.3 + value * 0.3 : std::log10(value); };
  const auto x = [&](double value) {
    return frame.left + (place(value) + 0.3) / (decades + 0.3) * frame.inner_width();
  };
  std::uint64_t most = 1;
  for (const auto& bin : bins) most = std::max(most, bin.count);
  const double height = std::log10(static_cast<double>(most)) + 1;
  const auto y = [&](std::uint64_t count) {
    return frame.top + (1 - (std::log10(static_cast<double>(count)) + 1) / height) * frame.inner_height();
  };
  auto svg = begin_svg(frame, "how often which magnitude came");
  for (int decade = 0; decade <= static_cast<int>(decades); ++decade) {
    const double at = x(std::pow(10.0, decade));
    svg_line(svg, at, frame.top, at, frame.top + frame.inner_height(), kGridInk);
    svg_label(svg, at, frame.height - 8, decade == static_cast<int>(decades) ? "end" : "middle",
              fmt::format("{:g} ns", std::pow(10.0, decade)));
  }
  svg_label(svg, frame.left - 4, frame.top + 9, "end", fmt::format("{}", most));
  svg_label(svg, frame.left - 4, y(1) + 3, "end", "1");
  std::string path;
  for (const auto& bin : bins) {
    const double left = x(static_cast<double>(bin.low)), right = std::max(x(static_cast<double>(bin.high)), left + 1);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", left, y(bin.count), right,
                   frame.top + frame.inner_height(), left);
  }
  svg_path(svg, path, kInk);
  if (limit > 0) svg_line(svg, x(limit), frame.top, x(limit), frame.top + frame.inner_height(), kLimitInk, true);
  return svg + "</svg>\n";
}

}  // namespace syncline::reports
