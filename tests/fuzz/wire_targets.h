// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Walks a frame's datagrams and learns a bus from them.
void run_frame(std::span<const std::uint8_t> given);
/// Decodes an EEPROM image.
void run_sii(std::span<const std::uint8_t> bytes);
/// One mailbox message: into every decoder, and into a simulated slave's mailbox.
void run_mailbox(std::span<const std::uint8_t> bytes);
/// Reads a capture, pcap or pcapng, and learns a bus from it.
void run_pcap(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::vector<Bytes> frames();
[[nodiscard]] std::vector<Bytes> siis();
[[nodiscard]] std::vector<Bytes> mailboxes();
[[nodiscard]] std::vector<Bytes> captures();

}  // namespace syncline::fuzz
