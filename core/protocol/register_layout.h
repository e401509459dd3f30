// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the registers of an ESC mean, bit by bit (ETG.1000.4, 6; Beckhoff ESC data sheet, section II), for those who
/// show them to people.
namespace syncline::reg {

enum class RegisterGroup : std::uint8_t {
  kEsc,
  kAddresses,
  kDataLink,
  kApplicationLayer,
  kEvents,
  kErrorCounters,
  kWatchdogs,
  kEeprom,
  kFmmus,
  kSyncManagers,
  kClock,
  kSyncSignals,
  kLatch,
};
inline constexpr std::size_t kRegisterGroups = 13;
[[nodiscard]] std::string_view register_group_name(RegisterGroup group);  // "DC: SYNC signals"

/// How a value is read by people; beside it stand its digits.
enum class RegisterValue : std::uint8_t {
  kNumber,
  kHex,
  kNanoseconds,
  kSignedNanoseconds,         // two's complement
  kSignMagnitudeNanoseconds,  // 0x092C: bit 31 is the sign
  kSignedNumber,
  kTenNanoseconds,  // in units of 10 ns
  kAlState,
  kStateCode,
};

/// Bits of a register.
struct RegisterField {
  std::uint8_t bit = 0, width = 1;
  std::string_view name{};
  std::string_view words{};  // "none|not configured|EBUS|MII", by value; empty: the number
};

struct RegisterLayout {
  std::uint16_t address = 0;
  std::uint8_t length = 1;  // 1, 2, 4 or 8 bytes
  RegisterGroup group = RegisterGroup::kEsc;
  std::string name{};
  RegisterValue value = RegisterValue::kHex;
  std::span<const RegisterField> fields{};
  bool reading_matters = false;  // it takes something away: not to be read along with others
};

/// Address ascending; of so many FMMUs and SyncManagers (at most 16 each).
[[nodiscard]] std::vector<RegisterLayout> register_layouts(unsigned fmmus, unsigned sync_managers);

/// The value as people read it: "1000000 ns", "-5", names of states; empty where the digits say it all.
[[nodiscard]] std::string register_text(const RegisterLayout& layout, std::span<const std::uint8_t> bytes);
[[nodiscard]] std::string field_text(const RegisterField& field, std::span<const std::uint8_t> bytes);

/// Registers that are read at once: neighbours in a block of 16 bytes, the size of the units of an ESC. Longer ranges
/// would hide what is missing: an ESC answers a range as soon as it has a part of it, and what it has not reads 0.
struct RegisterRange {
  std::uint16_t address = 0, length = 0;
  bool operator==(const RegisterRange&) const = default;
};
[[nodiscard]] std::vector<RegisterRange> ranges_of(std::span<const RegisterLayout* const> layouts);

}  // namespace syncline::reg
