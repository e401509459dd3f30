// SPDX-License-Identifier: Apache-2.0
#include "eni/xml_writer.h"

#include <algorithm>

namespace syncline::eni {
namespace {

std::string escaped(std::string_view value, bool in_attribute) {
  constexpr std::string_view kSpace = " \t\n\r";
  std::string out;
  out.reserve(value.size());
  // A parser drops text that is nothing but white space.
  const bool only_space = !in_attribute && value.find_first_not_of(kSpace) == std::string_view::npos;
  for (const char c : value) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += in_attribute ? "&quot;" : "\""; break;
      case '\r': out += "&#13;"; break;
      case '\n': out += in_attribute || only_space ? "&#10;" : "\n"; break;
      case '\t': out += in_attribute || only_space ? "&#9;" : "\t"; break;
      case ' ': out += only_space ? "&#32;" : " "; break;
      default:
        // XML 1.0 has no way to write the other control characters.
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

}  // namespace

XmlWriter& XmlWriter::open(std::string_view name) {
  begin_child();
  out_.append("<").append(name);
  path_.emplace_back(name);
  start_tag_open_ = true;
  has_text_ = false;
  return *this;
}

XmlWriter& XmlWriter::attribute(std::string_view name, std::string_view value) {
  out_.append(" ").append(name).append("=\"").append(escaped(value, true)).append("\"");
  return *this;
}

XmlWriter& XmlWriter::text(std::string_view value) {
  if (value.empty()) return *this;
  if (start_tag_open_) out_ += ">";
  start_tag_open_ = false;
  has_text_ = true;
  out_ += escaped(value, false);
  return *this;
}

XmlWriter& XmlWriter::close() {
  const std::string name = std::move(path_.back());
  path_.pop_back();
  if (start_tag_open_) {
    out_ += "/>\n";
  } else {
    if (!has_text_) indent();
    out_.append("</").append(name).append(">\n");
  }
  start_tag_open_ = false;
  has_text_ = false;
  return *this;
}

XmlWriter& XmlWriter::element(std::string_view name, std::string_view value) {
  return open(name).text(value).close();
}

XmlWriter& XmlWriter::comment(std::string_view words) {
  begin_child();
  std::string safe(words);
  // "--" would end the comment.
  std::ranges::replace(safe, '-', '~');
  out_.append("<!-- ").append(safe).append(" -->\n");
  return *this;
}

std::string XmlWriter::take() {
  while (!path_.empty()) close();
  return std::move(out_);
}

void XmlWriter::begin_child() {
  if (start_tag_open_) out_ += ">\n";
  start_tag_open_ = false;
  has_text_ = false;
  indent();
}

void XmlWriter::indent() {
  for (std::size_t level = 0; level < path_.size(); ++level) out_ += indent_;
}

}  // namespace syncline::eni
