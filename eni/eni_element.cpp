// SPDX-License-Identifier: Apache-2.0
#include "eni/eni_element.h"

#include <charconv>

namespace syncline::eni {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const auto first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

void EniReadContext::report(ErrorCode code, int line, std::string_view element, std::string detail) {
  if (!error_) {
    error_ = Error{.code = code, .subject = std::string(element), .detail = std::move(detail), .file = file_, .line = line};
  }
}

EniElement EniElement::child(const char* name) const {
  return {element_ ? element_->FirstChildElement(name) : nullptr, *context_};
}

EniElement EniElement::required(const char* name) const {
  EniElement found = child(name);
  if (!found && element_) {
    context_->report(ErrorCode::kXmlMissingElement, line(), name);
  }
  return found;
}

std::vector<EniElement> EniElement::children(const char* name) const {
  std::vector<EniElement> out;
  for (const auto* e = element_ ? element_->FirstChildElement(name) : nullptr; e; e = e->NextSiblingElement(name)) {
    out.emplace_back(e, *context_);
  }
  return out;
}

std::vector<EniElement> EniElement::children() const { return children(nullptr); }

std::string EniElement::text() const {
  std::string out;
  for (const auto* node = element_ ? element_->FirstChild() : nullptr; node; node = node->NextSibling()) {
    if (const auto* part = node->ToText()) {
      // Tools wrap names in CDATA, some with white space around it: only the CDATA counts then.
      if (part->CData() || !trimmed(part->Value()).empty()) {
        out += part->Value();
      }
    }
  }
  return out;
}

std::string EniElement::attribute(const char* name) const {
  const char* value = element_ ? element_->Attribute(name) : nullptr;
  return value ? value : "";
}

std::int64_t EniElement::integer(const std::string& value, std::uint64_t maximum, unsigned bits) const {
  std::string_view digits = trimmed(value);
  int base = 10;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) {
    digits.remove_prefix(1);
  }
  if (digits.starts_with("#x") || digits.starts_with("0x") || digits.starts_with("#X") || digits.starts_with("0X")) {
    digits.remove_prefix(2);
    base = 16;
  }
  std::uint64_t magnitude = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, base);
  const std::uint64_t most_negative = std::uint64_t{1} << (bits - 1);
  if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() ||
      magnitude > (negative ? most_negative : maximum)) {
    report(ErrorCode::kXmlBadValue, value);
    return 0;
  }
  return negative ? static_cast<std::int64_t>(0 - magnitude) : static_cast<std::int64_t>(magnitude);
}

bool EniElement::to_boolean(const std::string& value) const {
  const std::string_view word = trimmed(value);
  if (word == "1" || word == "true") {
    return true;
  }
  if (!word.empty() && word != "0" && word != "false") {
    report(ErrorCode::kXmlBadValue, value);
  }
  return false;
}

std::vector<std::uint8_t> EniElement::bytes() const {
  const std::string whole = text();
  std::string_view digits = trimmed(whole);
  if (digits.starts_with("0x") || digits.starts_with("#x")) {
    digits.remove_prefix(2);
  }
  std::vector<std::uint8_t> out;
  int high = -1;
  for (const char c : digits) {
    const int digit = hex_digit(c);
    if (digit < 0 && (c == ':' || c == '-') && high < 0) {
      continue;
    }
    if (digit < 0) {
      report(ErrorCode::kXmlBadValue, whole);
      return {};
    }
    if (high < 0) {
      high = digit;
    } else {
      out.push_back(static_cast<std::uint8_t>(high << 4 | digit));
      high = -1;
    }
  }
  if (high >= 0) {
    report(ErrorCode::kXmlBadValue, whole);
  }
  return out;
}

}  // namespace syncline::eni
