// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "support/result.h"

/// Ethernet over EtherCAT (ETG.1000.6, 5.7): its four-byte header, enough to recognise a message and to refuse it
/// in its own terms. Frames are not carried.
namespace syncline::eoe {

enum class Kind : std::uint8_t {
  kFragment = 0,
  kTimeStamp = 1,
  kSetIpRequest = 2,
  kSetIpResponse = 3,
  kSetFilterRequest = 4,
  kSetFilterResponse = 5,
  kGetIpRequest = 6,
  kGetIpResponse = 7,
  kGetFilterRequest = 8,
  kGetFilterResponse = 9,
};

/// Result codes of the responses.
inline constexpr std::uint16_t kSuccess = 0x0000, kUnspecified = 0x0001, kUnsupportedFrame = 0x0002,
                               kNoIpSupport = 0x0201, kNoDhcpSupport = 0x0202, kNoFilterSupport = 0x0401;

struct Header {
  Kind kind = Kind::kFragment;
  std::uint8_t port = 0;  // 0..15, 0 = not told
  bool last_fragment = false;
  bool time_appended = false, time_requested = false;
  std::uint8_t fragment_no = 0;  // 0..63; with the next two only of fragments
  std::uint8_t offset = 0;       // 0..63, units of 32 bytes; of the first fragment: size of the whole frame
  std::uint8_t frame_no = 0;     // 0..15
  std::uint16_t result = 0;      // of responses, instead of the three above
  bool operator==(const Header&) const = default;
  [[nodiscard]] bool is_response() const {
    return kind == Kind::kSetIpResponse || kind == Kind::kSetFilterResponse || kind == Kind::kGetIpResponse ||
           kind == Kind::kGetFilterResponse;
  }
};

[[nodiscard]] std::vector<std::uint8_t> encode(const Header& header);
/// The first four bytes behind the mailbox header. kMalformedData.
[[nodiscard]] Result<Header> decode(std::span<const std::uint8_t> data);

/// Whether these are the parameters of a "set IP" request and nothing else: flags, and as many bytes as they announce
/// (MAC, address, mask, gateway, DNS server, name).
[[nodiscard]] bool is_ip_parameters(std::span<const std::uint8_t> data);

}  // namespace syncline::eoe
