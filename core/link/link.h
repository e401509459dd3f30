// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

using MacAddress = std::array<std::uint8_t, 6>;

/// In the first byte of an address; the ESC sets it in the source address of what it has processed
/// (ESC data sheet, section I).
inline constexpr std::uint8_t kLocallyAdministered = 0x02;

struct LinkDescription {
  std::string name;  // "sim:resources/demo/machine.toml", "nic:eth0"
  std::string kind;  // "simulated", "nic", "replay"
  MacAddress mac{};  // source address for the master's frames
  bool up = false;
  bool corrects_send_time = false;  // has send_corrected()
};

struct ReceivedFrame {
  std::size_t length = 0;        // 0: nothing until the deadline
  Nanoseconds arrival_time = 0;  // on the link's clock
};

/// A time in a frame that the adapter corrects while it sends.
struct SendTimeField {
  std::size_t offset = 0;  // in the frame; 4 or 8 bytes, little-endian, ns
  std::size_t size = 8;
  Nanoseconds send_time = 0;  // for which the time was filled in
};

/// The bus, whatever it is: a network card, the simulated segment, a capture being replayed. An adapter that is
/// switched off, unplugged or has no carrier answers kLinkDown and works again as soon as it can: whoever waits only
/// has to go on. Not thread-safe: the thread that runs the master owns it. send() and receive() allocate nothing unless
/// they fail.
class Link {
 public:
  virtual ~Link() = default;
  /// Sends one complete Ethernet frame without FCS (14 bytes header + payload, 1514 at most).
  virtual Status send(std::span<const std::uint8_t> frame) = 0;
  /// Waits for a frame until `deadline` (absolute, on the link's clock) and copies it into
  /// `buffer` (at least 1514 bytes). length 0 means that none came. Frames of this host's own
  /// sending (echo) are never delivered.
  virtual Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) = 0;
  [[nodiscard]] virtual LinkDescription describe() const = 0;
  /// When the frame of the last send() was handed to the wire, where the link knows it better than its caller: his
  /// stamp is from before, and what the host did in between is not in it.
  [[nodiscard]] virtual std::optional<Nanoseconds> sent_at() const { return std::nullopt; }
  /// As send(), by an adapter that knows when it sends: adds to the time in the frame by how much later than
  /// `field.send_time` the frame leaves. Returns when it left. kNotSupported where the adapter has no such clock.
  virtual Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field);
};

}  // namespace syncline
