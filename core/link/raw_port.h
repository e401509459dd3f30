// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

struct AdapterInfo;
class Clock;

/// A network adapter opened for EtherCAT frames and nothing else: immediate mode, a filter for EtherType
/// 0x88A4, non-blocking. What a master's link and a simulated segment have in common. One thread at a time.
///
/// An adapter that is switched off, unplugged or without carrier is waited for: send() and poll() give kLinkDown until
/// it is back under its name, and open it anew then.
class RawPort {
 public:
  /// `clock` is the real clock and outlives the port. `stamps_sending`: sent_at() is wanted. kLinkNotFound with the
  /// names there are, kLinkDown and kLinkPermission with the command that helps, kNotSupported for what is no Ethernet.
  [[nodiscard]] static Result<RawPort> open(const std::string& adapter, Clock& clock, bool stamps_sending = false);
  RawPort(RawPort&&) noexcept;
  RawPort& operator=(RawPort&&) noexcept;
  ~RawPort();

  struct Frame {
    std::span<const std::uint8_t> bytes;  // in the kernel's ring; valid until the next poll()
    Nanoseconds arrival_time = 0;         // when the kernel took it from the driver, on the port's clock
  };
  /// The next frame that came in, if there is one. kLinkDown while the adapter is away, kLinkIo.
  [[nodiscard]] Result<std::optional<Frame>> poll();
  /// Sleeps until a frame is there or `duration` has passed; may wake up early.
  void wait(Nanoseconds duration) const;
  /// Hands one complete Ethernet frame without FCS to the driver. Copied once, by the kernel. kLinkDown, kLinkIo.
  Status send(std::span<const std::uint8_t> frame);
  /// When the driver got the frame of the last send(), on the port's clock; nothing where the kernel does not say.
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const;

  [[nodiscard]] const AdapterInfo& adapter() const;
  /// The adapter cannot tell directions apart: poll() also delivers what send() has sent.
  [[nodiscard]] bool sees_own() const;
  /// Frames that the kernel dropped because nobody fetched them in time, since the port was opened.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  struct Impl;
  explicit RawPort(std::unique_ptr<Impl> impl);
  [[nodiscard]] Error failed(Reason why);
  [[nodiscard]] bool come_back();
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline
