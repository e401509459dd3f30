// SPDX-License-Identifier: Apache-2.0
#include "eni/eni_text.h"

#include <array>
#include <charconv>

#include "eni/text_encoding.h"

namespace syncline::eni {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

void append_escaped(std::string& out, std::string_view sequence) {
  const char c = sequence.front();
  if (sequence.size() > 1) {
    out += sequence;
  } else if (c == '&') {
    out += "&amp;";
  } else if (c == '<') {
    out += "&lt;";
  } else if (c == '>') {
    out += "&gt;";
  } else if (c == '"') {
    out += "&quot;";
  } else if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') {
    out += '?';
  } else {
    out += c;
  }
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_sequence_length(text);
    if (length == 0) {
      out += '?';
      text.remove_prefix(1);
    } else {
      append_escaped(out, text.substr(0, length));
      text.remove_prefix(length);
    }
  }
  return out;
}

std::string EniText::decimal(std::int64_t value) {
  std::array<char, 24> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

void EniText::indent() { out_.append(open_.size() * 2, ' '); }

void EniText::open(std::string_view element, const std::vector<Attribute>& attributes) {
  indent();
  out_ += '<';
  out_ += element;
  for (const auto& attribute : attributes) {
    if (!attribute.value.empty()) {
      out_ += ' ';
      out_ += attribute.name;
      out_ += "=\"";
      out_ += escape_xml(attribute.value);
      out_ += '"';
    }
  }
  out_ += ">\n";
  open_.emplace_back(element);
}

void EniText::close() {
  const std::string element = std::move(open_.back());
  open_.pop_back();
  indent();
  out_ += "</" + element + ">\n";
}

void EniText::text(std::string_view element, std::string_view value) {
  indent();
  out_ += '<';
  out_ += element;
  out_ += '>';
  out_ += escape_xml(value);
  out_ += "</";
  out_ += element;
  out_ += ">\n";
}

void EniText::hex_number(std::string_view element, std::uint32_t value) {
  std::array<char, 16> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, 16);
  text(element, "#x" + std::string(buffer.data(), end));
}

void EniText::bytes(std::string_view element, std::span<const std::uint8_t> value) {
  std::string hex;
  hex.reserve(value.size() * 2);
  for (const std::uint8_t byte : value) {
    hex += kHexDigits[byte >> 4];
    hex += kHexDigits[byte & 0x0F];
  }
  text(element, hex);
}

}  // namespace syncline::eni
