// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline {

class Bus;
class SlaveAddress;

/// Words done and words in all.
using SiiProgress = std::function<void(std::size_t done, std::size_t all)>;

/// The whole EEPROM of one slave, as long as its size word (0x3E) says; a size below the header or above
/// 1 Mbit counts as 16 Kbit. `bytes`: so many instead. Takes the EEPROM from the PDI and gives it
/// back. kSii, kCancelled, bus errors.
[[nodiscard]] Result<std::vector<std::uint8_t>> read_eeprom(Bus& bus, const SlaveAddress& slave,
                                                            const SiiProgress& progress = {}, std::size_t bytes = 0);

/// Called when it is known what will be written over what, before the first word: a place to keep both, should the
/// program be killed. An error ends the write before it has begun.
using SiiIntent = std::function<Status(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after)>;

struct SiiWriteReport {
  std::size_t words = 0;    // of the image
  std::size_t written = 0;  // those that were different
  bool operator==(const SiiWriteReport&) const = default;
};

/// Makes the EEPROM hold `image` and reads it back. To the user it happens as a whole or not at all: when a
/// word cannot be written or does not read back, the words before it are put back and the error says so,
/// or says that even that failed. Cancelling does the same; a word that has been begun is ended first. Words that are
/// right already are not written; the configuration area (words 0 to 7) comes last, so that an interrupted write leaves
/// no new configuration behind. kSii with the word; kBadValue for an image of odd length, shorter than its header,
/// larger than the EEPROM, or with a wrong checksum.
[[nodiscard]] Result<SiiWriteReport> write_eeprom(Bus& bus, const SlaveAddress& slave,
                                                  std::span<const std::uint8_t> image, const SiiProgress& progress = {},
                                                  const SiiIntent& intent = {});

/// As write_eeprom(), of the EEPROM's first bytes as they are: nothing is checked but that they are words.
[[nodiscard]] Result<SiiWriteReport> write_image(Bus& bus, const SlaveAddress& slave,
                                                 std::span<const std::uint8_t> image, const SiiIntent& intent);

/// True for the error of a write that has failed when nothing of it is left.
[[nodiscard]] bool old_content_is_back(const Error& error);

/// Writes the station alias (word 4) and the checksum that goes with it. The ESC takes a new alias at its
/// next power-on. Otherwise as write_eeprom().
[[nodiscard]] Result<SiiWriteReport> write_alias(Bus& bus, const SlaveAddress& slave, std::uint16_t alias,
                                                 const SiiIntent& intent = {});

}  // namespace syncline
