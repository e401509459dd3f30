// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_element.h"

#include <algorithm>

#include "eni/xml/xml_text.h"

namespace syncline::eni {

EniChildren EniElement::children(const char* name) const { return {node_, name}; }

EniChildren::Iterator& EniChildren::Iterator::operator++() {
  node_ = node_.reading().ok() ? Node(node_.element()->NextSiblingElement(name_), node_.reading()) : Node();
  return *this;
}

std::vector<std::uint8_t> EniElement::bytes() const {
  const std::string whole = node_.text();
  std::string digits(trim(whole));
  if (digits.starts_with("0x") || digits.starts_with("#x")) {
    digits.erase(0, 2);
  }
  std::erase_if(digits, [](char c) { return c == ':' || c == '-'; });
  auto parsed = parse_hex_bytes(digits);
  if (!parsed) {
    report(ErrorCode::kXmlBadValue, "\"" + whole + "\"");
  }
  return parsed ? std::move(*parsed) : std::vector<std::uint8_t>{};
}

}  // namespace syncline::eni
