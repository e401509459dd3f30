// SPDX-License-Identifier: Apache-2.0
#include "protocol/diagnosis_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "support/byte_order.h"
#include "support/le_number.h"

namespace syncline {
namespace {

using DiagParameter = DiagnosisMessage::Parameter;

constexpr unsigned kBasicType = 0, kAsciiText = 2, kUnicodeText = 3;  // bits 15..12 of a parameter's flags
constexpr unsigned kMostFigures = 64;  // of a width or precision: no file makes us fill memory

unsigned parameter_kind(const DiagParameter& parameter) { return parameter.flags >> 12; }
std::uint16_t basic_type(const DiagParameter& parameter) { return parameter.flags & 0x0FFF; }

bool is_text(const DiagParameter& parameter) {
  return parameter_kind(parameter) == kAsciiText || parameter_kind(parameter) == kUnicodeText;
}

/// UTF-16, little endian, up to its end or a zero; what is beyond the first plane becomes a question mark.
std::string unicode_text(std::span<const std::uint8_t> data) {
  std::string text;
  for (std::size_t i = 0; i + 1 < data.size(); i += 2) {
    const auto unit = load_le<std::uint16_t>(data.subspan(i, 2));
    if (unit == 0) break;
    if (unit < 0x20 || (unit >= 0x7F && unit < 0xA0) || (unit >= 0xD800 && unit < 0xE000)) {
      text += '?';
    } else if (unit < 0x80) {
      text += static_cast<char>(unit);
    } else if (unit < 0x800) {
      text += static_cast<char>(0xC0 | unit >> 6);
      text += static_cast<char>(0x80 | (unit & 0x3F));
    } else {
      text += static_cast<char>(0xE0 | unit >> 12);
      text += static_cast<char>(0x80 | (unit >> 6 & 0x3F));
      text += static_cast<char>(0x80 | (unit & 0x3F));
    }
  }
  return text;
}

const coe::DataType* number_type(const DiagParameter& parameter) {
  if (parameter_kind(parameter) != kBasicType || parameter.data.empty() || parameter.data.size() > 8) return nullptr;
  const auto* type = coe::find_data_type(basic_type(parameter));
  return type == nullptr || type->kind == coe::ValueKind::kText ? nullptr : type;
}

double real_of(const DiagParameter& parameter) {
  const auto bits = le_number(parameter.data);
  if (parameter.data.size() == sizeof(float)) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  return std::bit_cast<double>(bits);
}

struct Conversion {
  bool left = false, zeros = false, plus = false, prefix = false;
  unsigned width = 0;
  std::optional<unsigned> precision{};
  char kind = 0;
};

unsigned take_figures(std::string_view text, std::size_t& at) {
  unsigned value = 0;
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
    value = std::min(value * 10 + static_cast<unsigned>(text[at] - '0'), kMostFigures);
  }
  return value;
}

/// Behind a percent sign; nothing when it is none, and `at` stays.
std::optional<Conversion> take_conversion(std::string_view text, std::size_t& at) {
  Conversion conversion;
  auto next = at;
  for (; next < text.size(); ++next) {
    const char c = text[next];
    if (c == '-')
      conversion.left = true;
    else if (c == '0')
      conversion.zeros = true;
    else if (c == '+')
      conversion.plus = true;
    else if (c == '#')
      conversion.prefix = true;
    else if (c != ' ')
      break;
  }
  conversion.width = take_figures(text, next);
  if (next < text.size() && text[next] == '.') {
    ++next;
    conversion.precision = take_figures(text, next);
  }
  while (next < text.size() && std::string_view("hlLqjzt").find(text[next]) != std::string_view::npos) ++next;
  if (next >= text.size() || std::string_view("diuxXocsfFeEgG").find(text[next]) == std::string_view::npos) {
    return std::nullopt;
  }
  conversion.kind = text[next];
  at = next + 1;
  return conversion;
}

std::string padded(std::string text, const Conversion& conversion, bool number) {
  if (text.size() >= conversion.width) return text;
  const auto missing = conversion.width - text.size();
  if (conversion.left) return text + std::string(missing, ' ');
  if (!number || !conversion.zeros) return std::string(missing, ' ') + text;
  const bool sign = text[0] == '-' || text[0] == '+';
  const std::size_t front = (sign ? 1U : 0U) + (conversion.prefix && text.size() > 1 && text[0] == '0' ? 2U : 0U);
  return text.insert(std::min(front, text.size()), missing, '0');
}

std::string with_sign(std::string text, const Conversion& conversion) {
  return conversion.plus && !text.starts_with('-') ? "+" + text : std::move(text);
}

std::string whole_number(const DiagParameter& parameter, const coe::DataType& type, const Conversion& conversion) {
  const auto bits = le_number(parameter.data);
  const auto* prefix = conversion.prefix ? "0x" : "";
  switch (conversion.kind) {
    case 'x':
      return fmt::format("{}{:0{}x}", prefix, bits, conversion.precision.value_or(1));
    case 'X':
      return fmt::format("{}{:0{}X}", prefix, bits, conversion.precision.value_or(1));
    case 'o':
      return fmt::format("{:o}", bits);
    case 'u':
      return fmt::format("{}", bits);
    default:
      break;
  }
  const bool negative = type.kind == coe::ValueKind::kSigned && le_signed_number(parameter.data) < 0;
  return with_sign(negative ? fmt::format("{}", le_signed_number(parameter.data)) : fmt::format("{}", bits),
                   conversion);
}

std::string real_figures(double value, const Conversion& conversion) {
  const auto figures = conversion.precision.value_or(6);
  switch (conversion.kind) {
    case 'f':
    case 'F':
      return with_sign(fmt::format("{:.{}f}", value, figures), conversion);
    case 'e':
    case 'E':
      return with_sign(fmt::format("{:.{}e}", value, figures), conversion);
    default:
      return with_sign(fmt::format("{:.{}g}", value, figures), conversion);
  }
}

std::string converted(const DiagParameter& parameter, const Conversion& conversion) {
  const auto* type = number_type(parameter);
  const bool real = type != nullptr && type->kind == coe::ValueKind::kReal;
  if (std::string_view("fFeEgG").find(conversion.kind) != std::string_view::npos) {
    if (real) return padded(real_figures(real_of(parameter), conversion), conversion, true);
  } else if (conversion.kind == 'c') {
    if (type != nullptr && !real && parameter.data[0] >= 0x20 && parameter.data[0] < 0x7F) {
      return padded(std::string(1, static_cast<char>(parameter.data[0])), conversion, false);
    }
  } else if (conversion.kind != 's' && type != nullptr && !real) {
    return padded(whole_number(parameter, *type, conversion), conversion, true);
  }
  auto text = parameter_text(parameter);
  if (conversion.kind == 's' && conversion.precision && is_text(parameter) && *conversion.precision < text.size() &&
      parameter_kind(parameter) == kAsciiText) {
    text.resize(*conversion.precision);
  }
  return padded(std::move(text), conversion, false);
}

void append_rest(std::string& text, const DiagnosisMessage& message, std::size_t first) {
  for (std::size_t i = first; i < message.parameters.size(); ++i) {
    text += fmt::format(" [{}]", parameter_text(message.parameters[i]));
  }
}

}  // namespace

std::string parameter_text(const DiagParameter& parameter) {
  switch (parameter_kind(parameter)) {
    case kBasicType:
      return value_text(basic_type(parameter), parameter.data);
    case kAsciiText:
      return value_text(kStringType, parameter.data);
    case kUnicodeText:
      return unicode_text(parameter.data);
    default:
      return value_text(kBytesType, parameter.data);
  }
}

std::string diagnosis_text(std::string_view text, const DiagnosisMessage& message) {
  std::string filled;
  std::size_t used = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at++];
    if (c != '%') {
      filled += c;
      continue;
    }
    if (at < text.size() && text[at] == '%') {
      filled += text[at++];
    } else if (const auto conversion = take_conversion(text, at)) {
      filled += used < message.parameters.size() ? converted(message.parameters[used], *conversion) : "?";
      ++used;
    } else {
      filled += c;
    }
  }
  append_rest(filled, message, used);
  return filled;
}

std::string raw_diagnosis_text(const DiagnosisMessage& message) {
  auto text = fmt::format("text 0x{:04X}", message.text_id);
  append_rest(text, message, 0);
  return text;
}

}  // namespace syncline
