// SPDX-License-Identifier: Apache-2.0
#include "reports/svg_drawing.h"

#include <fmt/format.h>

#include <iterator>

namespace syncline::reports {

std::string svg_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        // Control characters have no place in XML.
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string begin_svg(const SvgFrame& frame, std::string_view title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" height=\"{}\" role=\"img\" "
      "font-family=\"sans-serif\" font-size=\"10\" fill=\"#52606d\">\n<title>{}</title>\n"
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#9aa5b1\"/>\n",
      frame.width, frame.height, frame.width, frame.height, svg_text(title), frame.left, frame.top, frame.inner_width(),
      frame.inner_height());
}

void svg_label(std::string& svg, double x, double y, std::string_view anchor, std::string_view text) {
  fmt::format_to(std::back_inserter(svg), "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                 anchor, svg_text(text));
}

void svg_line(std::string& svg, double x1, double y1, double x2, double y2, std::string_view ink, bool dashed) {
  fmt::format_to(std::back_inserter(svg),
                 "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"{}/>\n", x1, y1, x2, y2,
                 ink, dashed ? " stroke-dasharray=\"6 4\"" : "");
}

void svg_area(std::string& svg, double x, double y, double width, double height, std::string_view ink, double opacity) {
  fmt::format_to(std::back_inserter(svg),
                 "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" opacity=\"{}\"/>\n", x,
                 y, width, height, ink, opacity);
}

void svg_path(std::string& svg, std::string_view path, std::string_view ink) {
  fmt::format_to(std::back_inserter(svg), "<path d=\"{}\" fill=\"{}\"/>\n", path, ink);
}

}  // namespace syncline::reports
