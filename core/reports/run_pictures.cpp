// SPDX-License-Identifier: Apache-2.0
#include "reports/run_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "trace/histogram.h"
#include "trace/min_max_series.h"

namespace syncline::reports {
namespace {

constexpr double kWidth = 700, kHeight = 150, kLeft = 64, kRight = 12, kTop = 8, kBottom = 26;
constexpr double kInnerWidth = kWidth - kLeft - kRight, kInnerHeight = kHeight - kTop - kBottom;
constexpr const char* kInk = "#1f5fa8";
constexpr const char* kLimitInk = "#b45309";

std::string begin_svg(const char* title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" height=\"{}\" role=\"img\" "
      "font-family=\"sans-serif\" font-size=\"10\" fill=\"#52606d\">\n<title>{}</title>\n"
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#9aa5b1\"/>\n",
      kWidth, kHeight, kWidth, kHeight, title, kLeft, kTop, kInnerWidth, kInnerHeight);
}

void label(std::string& svg, double x, double y, const char* anchor, const std::string& text) {
  fmt::format_to(std::back_inserter(svg), "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                 anchor, text);
}

void line(std::string& svg, double x1, double y1, double x2, double y2, const char* ink, bool dashed) {
  fmt::format_to(std::back_inserter(svg),
                 "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"{}/>\n", x1, y1, x2, y2,
                 ink, dashed ? " stroke-dasharray=\"6 4\"" : "");
}

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= value) return step * decade;
  }
  return 10 * decade;
}

}  // namespace

std::string course_svg(const CourseOf& course) {
  constexpr Nanoseconds kColumns = 600;
  const auto span = std::max<Nanoseconds>(course.end - course.begin, 1);
  const auto width = (span + kColumns - 1) / kColumns;
  std::vector<SeriesColumn> columns;
  course.series.columns(course.begin, course.end + 1, width, columns);
  double largest = course.limit;
  bool any = false;
  for (const auto& column : columns) {
    if (!column.valid) continue;
    any = true;
    largest = std::max({largest, std::abs(static_cast<double>(column.min)), std::abs(static_cast<double>(column.max))});
  }
  if (!any) return {};
  const double top = round_up(largest), bottom = course.is_signed ? -top : 0;
  const auto y = [&](double value) { return kTop + (top - value) / (top - bottom) * kInnerHeight; };
  const auto x = [&](Nanoseconds time) {
    const auto part = static_cast<double>(time - course.begin) / static_cast<double>(span);
    return kLeft + std::clamp(part, 0.0, 1.0) * kInnerWidth;
  };
  auto svg = begin_svg("course over time");
  for (const double tick : {bottom, (top + bottom) / 2, top}) {
    if (tick > bottom && tick < top) line(svg, kLeft, y(tick), kLeft + kInnerWidth, y(tick), "#e4e7eb", false);
    label(svg, kLeft - 4, y(tick) + 3, "end", fmt::format("{:g} ns", tick));
  }
  std::string path;
  for (const auto& column : columns) {
    if (!column.valid) continue;
    const double high = y(column.max), height = std::max(y(column.min) - high, 1.0);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}h{:.2f}v{:.1f}h{:.2f}z", x(column.start), high,
                   std::max(x(column.start + width) - x(column.start), 0.5), height,
                   -std::max(x(column.start + width) - x(column.start), 0.5));
  }
  svg += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kInk);
  if (course.limit > 0) {
    line(svg, kLeft, y(course.limit), kLeft + kInnerWidth, y(course.limit), kLimitInk, true);
    if (course.is_signed) line(svg, kLeft, y(-course.limit), kLeft + kInnerWidth, y(-course.limit), kLimitInk, true);
  }
  const double seconds = static_cast<double>(span) / 1e9;
  label(svg, kLeft, kHeight - 8, "start", "0 s");
  label(svg, kLeft + kInnerWidth / 2, kHeight - 8, "middle", fmt::format("{:.4g} s", seconds / 2));
  label(svg, kLeft + kInnerWidth, kHeight - 8, "end", fmt::format("{:.4g} s", seconds));
  return svg + "</svg>\n";
}

std::string histogram_svg(const Histogram& histogram, double limit) {
  const auto bins = histogram.bins();
  if (bins.empty()) return {};
  // 0 has a place of its own, left of 1.
  const double last = std::max(static_cast<double>(bins.back().high), limit);
  const double decades = std::max(std::ceil(std::log10(std::max(last, 10.0))), 1.0);
  const auto place = [&](double value) { return value < 1 ? -0.3 + value * 0.3 : std::log10(value); };
  const auto x = [&](double value) { return kLeft + (place(value) + 0.3) / (decades + 0.3) * kInnerWidth; };
  std::uint64_t most = 1;
  for (const auto& bin : bins) most = std::max(most, bin.count);
  const double height = std::log10(static_cast<double>(most)) + 1;
  const auto y = [&](std::uint64_t count) {
    return kTop + (1 - (std::log10(static_cast<double>(count)) + 1) / height) * kInnerHeight;
  };
  auto svg = begin_svg("how often which magnitude came");
  for (int decade = 0; decade <= static_cast<int>(decades); ++decade) {
    const double at = x(std::pow(10.0, decade));
    line(svg, at, kTop, at, kTop + kInnerHeight, "#e4e7eb", false);
    label(svg, at, kHeight - 8, decade == static_cast<int>(decades) ? "end" : "middle",
          fmt::format("{:g} ns", std::pow(10.0, decade)));
  }
  label(svg, kLeft - 4, kTop + 9, "end", fmt::format("{}", most));
  label(svg, kLeft - 4, y(1) + 3, "end", "1");
  std::string path;
  for (const auto& bin : bins) {
    const double left = x(static_cast<double>(bin.low)), right = std::max(x(static_cast<double>(bin.high)), left + 1);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", left, y(bin.count), right,
                   kTop + kInnerHeight, left);
  }
  svg += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kInk);
  if (limit > 0) line(svg, x(limit), kTop, x(limit), kTop + kInnerHeight, kLimitInk, true);
  return svg + "</svg>\n";
}

}  // namespace syncline::reports
