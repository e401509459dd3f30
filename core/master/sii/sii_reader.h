// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "support/result.h"

namespace syncline {

class SiiAccess;

/// What one slave's EEPROM gave.
struct SiiContent {
  std::vector<std::uint8_t> bytes;  // from word 0 to the end marker of the categories
  std::optional<Error> error;
  std::optional<std::size_t> shared_with;  // first slave of the kind that this one was read together with
};

struct SiiReadOptions {
  /// Slaves of the same kind are read together: each gives its own words 0x00 to 0x0F, the rest is read
  /// in pieces, every piece from two of them. A kind is made of slaves whose header checksum is right and
  /// whose words 0x00 to 0x0D are the same but for alias and checksum; two different answers to one piece
  /// show that they are not the same after all, and then each is read by itself.
  bool share_kinds = true;
};

/// Reads the EEPROMs of all slaves at the same time and only as far as the categories go. A slave that
/// fails, or whose EEPROM is the PDI's and must be left to it, has its error in its place; the result is
/// an error only when the bus fails or the scan is cancelled. `progress` is told how many are done.
[[nodiscard]] Result<std::vector<SiiContent>> read_sii(SiiAccess& access, const SiiReadOptions& options = {},
                                                       const std::function<void(std::size_t)>& progress = {});

}  // namespace syncline
