// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_writer.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "eni/xml/xml_text.h"
#include "support/markup.h"
#include "support/utf8.h"

namespace syncline::eni {
namespace {

constexpr std::string_view kSpace = " \t\n\r";

/// Bytes that may stand as they are, in attributes and in texts; beyond ASCII somebody must look closer.
constexpr std::array<bool, 256> kPlain = [] {
  std::array<bool, 256> plain{};
  for (int c = 0x20; c < 0x80; ++c) plain[static_cast<std::size_t>(c)] = markup_entity(static_cast<char>(c)).empty();
  return plain;
}();

bool is_plain(char c) { return kPlain[static_cast<std::uint8_t>(c)]; }

void append_character(std::string& out, char c, bool in_attribute, bool only_space) {
  if (const auto entity = markup_entity(c); !entity.empty() && (c != '"' || in_attribute)) {
    out += entity;
    return;
  }
  switch (c) {
    case '\r':
      out += "&#13;";
      break;
    case '\n':
      out += in_attribute || only_space ? "&#10;" : "\n";
      break;
    case '\t':
      out += in_attribute || only_space ? "&#9;" : "\t";
      break;
    case ' ':
      out += only_space ? "&#32;" : " ";
      break;
    default:
      // XML 1.0 has no way to write the other control characters.
      if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
}

void append_slowly(std::string& out, std::string_view value, bool in_attribute) {
  // A parser drops text that is nothing but white space.
  const bool only_space = !in_attribute && value.find_first_not_of(kSpace) == std::string_view::npos;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto rest = value.substr(i);
    if (rest.starts_with("\xEF\xBF\xBE") || rest.starts_with("\xEF\xBF\xBF")) {
      i += 2;  // U+FFFE and U+FFFF are no characters of XML
    } else {
      append_character(out, value[i], in_attribute, only_space);
    }
  }
}

void append_escaped(std::string& out, std::string_view value, bool in_attribute) {
  const bool may_be_only_space = !in_attribute && kSpace.find(value.front()) != std::string_view::npos;
  if (!may_be_only_space && std::ranges::all_of(value, is_plain)) {
    out += value;
  } else if (is_utf8(value)) {
    append_slowly(out, value, in_attribute);
  } else {
    // One wrong byte would have the whole file taken for another encoding.
    append_slowly(out, to_utf8(std::string(value)), in_attribute);
  }
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
  out_.append(" ").append(name).append("=\"");
  if (!value.empty()) append_escaped(out_, value, true);
  out_ += '"';
  return *this;
}

XmlWriter& XmlWriter::text(std::string_view value) {
  if (value.empty()) return *this;
  if (start_tag_open_) out_ += ">";
  start_tag_open_ = false;
  has_text_ = true;
  append_escaped(out_, value, false);
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

XmlWriter& XmlWriter::element(std::string_view name, std::string_view value) { return open(name).text(value).close(); }

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
