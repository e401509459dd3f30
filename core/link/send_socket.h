// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

/// The way out of a network adapter: a packet socket of its own beside libpcap's, which receives nothing. Frames go
/// past the queueing discipline (PACKET_QDISC_BYPASS), so that nobody's traffic shaping delays them; other programs'
/// captures on this adapter do not see them. Where the driver stamps frames (SO_TIMESTAMPING), the kernel says when it
/// handed each frame over: what the host did between reading its clock and sending is then known. One thread.
class SendSocket {
 public:
  /// Nothing when the system does not have it: then libpcap sends as well.
  [[nodiscard]] static std::optional<SendSocket> open(const std::string& adapter, bool stamped);
  SendSocket(SendSocket&& other) noexcept;
  SendSocket& operator=(SendSocket&& other) noexcept;
  ~SendSocket();

  /// A frame for which the adapter's queue has no room is lost, as on a wire. kLinkIo when the adapter went away.
  Status send(std::span<const std::uint8_t> frame);
  /// The last frame found no room, or no carrier.
  [[nodiscard]] bool dropped() const { return dropped_; }
  /// When the driver got the frame of the last send(), on the calendar clock; nothing where it does not say.
  [[nodiscard]] std::optional<Nanoseconds> take_stamp();

 private:
  explicit SendSocket(int fd) : fd_(fd) {}

  int fd_ = -1;
  bool stamped_ = false;
  std::uint32_t sent_ = 0;  // frames that were handed over: the kernel counts the stamps alike
  int without_stamp_ = 0;   // in a row
  bool dropped_ = false;
};

}  // namespace syncline
