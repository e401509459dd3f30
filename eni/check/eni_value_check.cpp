// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_value_check.h"

#include <algorithm>
#include <limits>

#include "config/sync_manager_type.h"
#include "eni/xml/xml_number.h"
#include "eni/xml/xml_text.h"
#include "protocol/al_state.h"

namespace syncline::eni {
namespace {

template <std::size_t kCount>
ValueVerdict one_of(const std::string_view (&words)[kCount], std::string_view text) {
  return std::ranges::find(words, text) != std::end(words) ? ValueVerdict::kRight : ValueVerdict::kWrong;
}

struct Bounds {
  std::int64_t low, high;
};

Bounds bounds(EniValue value) {
  switch (value) {
    case EniValue::kByte:
      return {0, 0xFF};
    case EniValue::kUInt16:
      return {std::numeric_limits<std::int16_t>::min(), 0xFFFF};
    case EniValue::kUInt32:
    case EniValue::kHexDec:
      return {std::numeric_limits<std::int32_t>::min(), 0xFFFFFFFF};
    default:
      return {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
  }
}

ValueVerdict check_number(EniValue value, std::string_view text) {
  const auto number = parse_number(text);
  const Bounds allowed = bounds(value);
  if (!number || *number < allowed.low || *number > allowed.high) return ValueVerdict::kWrong;
  const std::size_t x = text.find_first_of("xX");
  if (value == EniValue::kHexDec) {
    return x == std::string_view::npos || text.substr(0, x) == "#" ? ValueVerdict::kRight : ValueVerdict::kOddForm;
  }
  return x == std::string_view::npos && *number <= std::numeric_limits<std::int32_t>::max() ? ValueVerdict::kRight
                                                                                            : ValueVerdict::kOddForm;
}

ValueVerdict check_bytes(std::string_view text, std::size_t wanted) {
  std::string digits(text);
  if (digits.starts_with("0x") || digits.starts_with("#x")) digits.erase(0, 2);
  std::erase_if(digits, [](char c) { return c == ':' || c == '-'; });
  const auto bytes = parse_hex_bytes(digits);
  if (!bytes || (wanted != 0 && bytes->size() != wanted)) return ValueVerdict::kWrong;
  const bool plain = digits.size() == text.size() && text.find_first_of(" \t\r\n") == std::string_view::npos;
  return plain ? ValueVerdict::kRight : ValueVerdict::kOddForm;
}

ValueVerdict check_bool(std::string_view text) {
  if (!parse_bool(text)) return ValueVerdict::kWrong;
  return text == "0" || text == "1" || text == "true" || text == "false" ? ValueVerdict::kRight
                                                                         : ValueVerdict::kOddForm;
}

}  // namespace

ValueVerdict check_value(EniValue value, std::string_view whole) {
  const std::string_view text = trim(whole);
  switch (value) {
    case EniValue::kChildren:
    case EniValue::kAnything:
    case EniValue::kText:
      return ValueVerdict::kRight;
    case EniValue::kBool:
      return check_bool(text);
    case EniValue::kBytes:
      return check_bytes(text, 0);
    case EniValue::kMac:
      return check_bytes(text, 6);
    case EniValue::kTransition:
      return transition_from_name(text) ? ValueVerdict::kRight : ValueVerdict::kWrong;
    case EniValue::kSoeTransition:
      if (one_of({"PS", "SO", "SP", "OP", "OS"}, text) == ValueVerdict::kRight) return ValueVerdict::kRight;
      return transition_from_name(text) ? ValueVerdict::kOddForm : ValueVerdict::kWrong;
    case EniValue::kState:
      return one_of({"INIT", "PREOP", "SAFEOP", "OP"}, text);
    case EniValue::kPort:
      return one_of({"B", "C", "D"}, text);
    case EniValue::kProtocol:
      return one_of({"AoE", "EoE", "CoE", "SoE", "FoE", "VoE"}, text);
    case EniValue::kSmType:
      return sync_manager_type(text) ? ValueVerdict::kRight : ValueVerdict::kWrong;
    case EniValue::kRequires:
      return one_of({"frame", "cycle"}, text);
    case EniValue::kPhysics:
      return text.size() <= 4 && text.find_first_not_of("YKBH, ") == std::string_view::npos ? ValueVerdict::kRight
                                                                                            : ValueVerdict::kWrong;
    default:
      return check_number(value, text);
  }
}

std::string_view value_words(EniValue value) {
  switch (value) {
    case EniValue::kByte:
      return "a decimal number from 0 to 255";
    case EniValue::kUInt16:
      return "a decimal number from 0 to 65535";
    case EniValue::kUInt32:
      return "a decimal number of 32 bits, negative from 2147483648 on";
    case EniValue::kInt:
      return "a decimal number from -2147483648 to 2147483647";
    case EniValue::kHexDec:
      return "a decimal number, or a hexadecimal one as #x1a00";
    case EniValue::kBool:
      return "0, 1, true or false";
    case EniValue::kBytes:
      return "bytes of two hexadecimal digits each";
    case EniValue::kMac:
      return "6 bytes of two hexadecimal digits each";
    case EniValue::kTransition:
      return "a transition such as IP or PS";
    case EniValue::kSoeTransition:
      return "a transition on which SoE is allowed: PS, SO, SP, OP or OS";
    case EniValue::kState:
      return "INIT, PREOP, SAFEOP or OP";
    case EniValue::kPort:
      return "B, C or D";
    case EniValue::kProtocol:
      return "AoE, EoE, CoE, SoE, FoE or VoE";
    case EniValue::kSmType:
      return "MBoxOut, MBoxIn, Outputs or Inputs";
    case EniValue::kRequires:
      return "frame or cycle";
    case EniValue::kPhysics:
      return "up to 4 of the letters Y, K and B";
    default:
      return "text";
  }
}

}  // namespace syncline::eni
