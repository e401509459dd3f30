// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/types.h"

/// Blocks of a pcapng file (draft-ietf-opsawg-pcapng), put behind `out`: one section, little-endian, with one interface
/// of Ethernet whose times are nanoseconds. Times count from the DC epoch; the file holds Unix time.
namespace syncline {

/// Section header. `application`: shb_userappl, "": none.
void append_pcapng_section(std::vector<std::uint8_t>& out, std::string_view application);

/// Interface description. `name` and `description`: if_name, if_description, "": none.
void append_pcapng_interface(std::vector<std::uint8_t>& out, std::string_view name, std::string_view description);

struct PcapngPacket {
  Nanoseconds time = 0;
  std::uint8_t direction = 0;           // epb_flags, bits 1:0: 1 inbound, 2 outbound
  std::uint64_t lost_before = 0;        // epb_dropcount: since the packet before
  std::span<const std::string> notes;   // opt_comment, UTF-8, each up to 65535 bytes
  std::span<const std::uint8_t> bytes;  // Ethernet frame without FCS
};
/// Enhanced packet.
void append_pcapng_packet(std::vector<std::uint8_t>& out, const PcapngPacket& packet);

/// Of an enhanced packet without notes whose frame has `bytes`.
[[nodiscard]] std::size_t pcapng_packet_size(std::size_t bytes);

struct PcapngStatistics {
  Nanoseconds begin = 0, end = 0;
  std::uint64_t received = 0;          // isb_ifrecv: those in the file and those lost
  std::uint64_t lost = 0;              // isb_ifdrop
  std::span<const std::string> notes;  // opt_comment
};
/// Interface statistics.
void append_pcapng_statistics(std::vector<std::uint8_t>& out, const PcapngStatistics& statistics);

}  // namespace syncline
