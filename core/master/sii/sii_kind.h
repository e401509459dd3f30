// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "support/result.h"

namespace syncline {

/// The words that every slave gives by itself: configuration area, identity and serial number.
inline constexpr std::uint32_t kOwnSiiWords = 0x10;

/// The part of the EEPROM that slaves of one kind have in common, as far as it is read, and how far it
/// goes: to the end marker of the categories. Pure.
class SiiKind {
 public:
  /// `own` are the words 0 to 0x0F of the first member.
  SiiKind(std::vector<std::size_t> members, std::span<const std::uint8_t> own);

  std::vector<std::size_t> members;  // indexes of slaves, rising
  std::vector<std::size_t> readers;  // members whose EEPROM answers

  [[nodiscard]] bool done() const { return done_ || error_.has_value(); }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  void give_up(Error error) { error_ = std::move(error); }
  /// First word that is not known yet.
  [[nodiscard]] std::uint32_t next_word() const { return static_cast<std::uint32_t>(bytes_.size() / 2); }
  /// Pieces of eight bytes that are surely or probably needed.
  [[nodiscard]] std::size_t pieces_wanted() const;
  void append(std::span<const std::uint8_t> piece);
  /// The whole image, beginning with the first member's own words.
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  void walk();
  [[nodiscard]] std::size_t word(std::size_t byte) const;
  [[nodiscard]] std::size_t limit() const;

  std::vector<std::uint8_t> bytes_;
  std::size_t category_;  // byte where the next category begins
  std::size_t categories_ = 0;
  bool done_ = false;
  std::optional<Error> error_;
};

/// Slaves whose EEPROMs may be read together; `own` holds each one's words 0 to 0x0F, or nothing when it
/// has none. Every slave that has them is a member of exactly one kind.
[[nodiscard]] std::vector<SiiKind> find_sii_kinds(std::span<const std::vector<std::uint8_t>> own, bool share);

}  // namespace syncline
