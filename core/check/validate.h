// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "config/init_cmd.h"

namespace syncline {

/// Whether what was read satisfies the check: masked and, where sizes count, taken as one little-endian number. Bytes
/// that were not read count as 0.
[[nodiscard]] bool satisfies(const InitCmdValidate& validate, std::span<const std::uint8_t> read);

/// Before the expected value in a sentence: "", "not ", "at least " and so on.
[[nodiscard]] std::string_view relation(ValidateType type);

}  // namespace syncline
