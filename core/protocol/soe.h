// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "support/result.h"

/// Servo drive profile over EtherCAT (ETG.1000.6, 5.8; IEC 61800-7-204): the four bytes before the data of an IDN.
namespace syncline::soe {

enum class OpCode : std::uint8_t {
  kReadRequest = 1,
  kReadResponse = 2,
  kWriteRequest = 3,
  kWriteResponse = 4,
  kNotification = 5,
  kEmergency = 6,
};

/// Error codes that a drive answers with.
inline constexpr std::uint16_t kNoIdn = 0x1001, kNoElement = 0x1009;

struct Header {
  static constexpr std::size_t kSize = 4;
  OpCode op_code = OpCode::kReadRequest;
  bool incomplete = false;       // more fragments follow; `idn` then counts those left
  bool error = false;            // the data are an error code of 16 bits
  std::uint8_t drive_no = 0;     // 0..7
  std::uint8_t elements = 0x40;  // bits: state, name, attribute, unit, minimum, maximum, value, default value
  std::uint16_t idn = 0;
  bool operator==(const Header&) const = default;
};

[[nodiscard]] std::vector<std::uint8_t> encode(const Header& header);
/// The first four bytes behind the mailbox header. kMalformedData.
[[nodiscard]] Result<Header> decode(std::span<const std::uint8_t> data);

/// "S-0-0047", "P-3-0100": standard or the device's own where bit 15 is set, parameter set in bits 12 to 14, block
/// number (IEC 61800-7-204).
[[nodiscard]] std::string idn_text(std::uint16_t idn);

}  // namespace syncline::soe
