// SPDX-License-Identifier: Apache-2.0
#include "check/validate.h"

#include <compare>
#include <cstddef>

namespace syncline {
namespace {

/// Sign bit turned over, so that two's complement numbers compare like unsigned ones.
constexpr std::uint8_t kSignBit = 0x80;

std::strong_ordering compare(const InitCmdValidate& validate, std::span<const std::uint8_t> read) {
  for (std::size_t i = validate.data.size(); i-- > 0;) {
    const std::uint8_t mask = i < validate.mask.size() ? validate.mask[i] : std::uint8_t{0xFF};
    const bool sign = validate.is_signed && i + 1 == validate.data.size();
    const std::uint8_t turned = sign ? kSignBit : std::uint8_t{0};
    const int got = ((i < read.size() ? read[i] : 0) & mask) ^ turned;
    const int wanted = (validate.data[i] & mask) ^ turned;
    if (got != wanted) return got <=> wanted;
  }
  return std::strong_ordering::equal;
}

}  // namespace

bool satisfies(const InitCmdValidate& validate, std::span<const std::uint8_t> read) {
  const auto order = compare(validate, read);
  switch (validate.type) {
    case ValidateType::kEqual:
      return order == 0;
    case ValidateType::kNotEqual:
      return order != 0;
    case ValidateType::kGreaterOrEqual:
      return order >= 0;
    case ValidateType::kLessOrEqual:
      return order <= 0;
    case ValidateType::kGreater:
      return order > 0;
    case ValidateType::kLess:
      return order < 0;
    case ValidateType::kNone:
      return true;
  }
  return false;
}

std::string_view relation(ValidateType type) {
  switch (type) {
    case ValidateType::kEqual:
      return "";
    case ValidateType::kNotEqual:
      return "not ";
    case ValidateType::kGreaterOrEqual:
      return "at least ";
    case ValidateType::kLessOrEqual:
      return "at most ";
    case ValidateType::kGreater:
      return "more than ";
    case ValidateType::kLess:
      return "less than ";
    case ValidateType::kNone:
      return "anything instead of ";
  }
  return "";
}

}  // namespace syncline
