// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// SVG as text, light, by hand: what pictures of a run are drawn with where there is no window.
namespace syncline::reports {

inline constexpr const char* kGridInk = "#e4e7eb";
inline constexpr const char* kInk = "#1f5fa8";
inline constexpr const char* kLimitInk = "#b45309";
inline constexpr const char* kFaultInk = "#b91c1c";

/// Where a drawing's axes stand, in pixels.
struct SvgFrame {
  double width = 700, height = 150;
  double left = 64, right = 12, top = 8, bottom = 26;
  [[nodiscard]] double inner_width() const { return width - left - right; }
  [[nodiscard]] double inner_height() const { return height - top - bottom; }
  [[nodiscard]] double foot() const { return height - bottom; }
  [[nodiscard]] double end() const { return width - right; }
};

/// "&", "<", ">" and quotes of a text that somebody else has written, for elements and attributes.
[[nodiscard]] std::string svg_text(std::string_view text);
/// The beginning of a drawing with its frame; `title` is what a screen reader says.
[[nodiscard]] std::string begin_svg(const SvgFrame& frame, std::string_view title);
/// `anchor`: start, middle or end; the text is escaped here.
void svg_label(std::string& svg, double x, double y, std::string_view anchor, std::string_view text);
void svg_line(std::string& svg, double x1, double y1, double x2, double y2, std::string_view ink, bool dashed = false);
/// Filled, `opacity` from 0 to 1.
void svg_area(std::string& svg, double x, double y, double width, double height, std::string_view ink, double opacity);
void svg_path(std::string& svg, std::string_view path, std::string_view ink);

}  // namespace syncline::reports
