// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_text.h"

#include <array>
#include <charconv>

#include "eni/xml/xml_number.h"
#include "eni/xml/xml_text.h"

namespace syncline::eni {

EniText::EniText(const EniStyle& style)
    : style_(style),
      xml_(style.tabs ? "\t" : "  ",
           style.declare_encoding ? R"(<?xml version="1.0" encoding="UTF-8"?>)" : R"(<?xml version="1.0"?>)") {}

std::string EniText::decimal(std::int64_t value) {
  std::array<char, 24> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

void EniText::open(std::string_view element, const std::vector<Attribute>& attributes) {
  xml_.open(element);
  for (const auto& attribute : attributes) {
    if (!attribute.value.empty()) {
      xml_.attribute(attribute.name, attribute.value);
    }
  }
}

void EniText::text(std::string_view element, std::string_view value) {
  xml_.element(element, to_utf8(std::string(value)));
}

void EniText::content(std::string_view value) { xml_.text(to_utf8(std::string(value))); }

void EniText::hex_number(std::string_view element, std::uint32_t value) { text(element, hex_dec(value, 1)); }

void EniText::bytes(std::string_view element, std::span<const std::uint8_t> value) { text(element, hex_bytes(value)); }

}  // namespace syncline::eni
