// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "eni/check/eni_schema.h"

namespace syncline::eni {

enum class ValueVerdict : std::uint8_t {
  kRight,
  kOddForm,  // understood by tolerant readers only
  kWrong,
};

[[nodiscard]] ValueVerdict check_value(EniValue value, std::string_view text);
/// "a decimal number from 0 to 65535"
[[nodiscard]] std::string_view value_words(EniValue value);

}  // namespace syncline::eni
