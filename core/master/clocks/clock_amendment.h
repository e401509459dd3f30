// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "master/exchange/frame_exchange.h"

namespace syncline {

/// One frame more to the clock that leads, within the cycle. A second write with a reading behind it: what a frame that
/// left far from its stamp has told the clock too much or too little is taken back some ten microseconds later instead
/// of in the next cycle; the clock's own control loop averages messages, so the two cancel. Or another depth of that
/// average, when a clock begins or ceases to lead. Cyclic thread; allocates nothing.
class ClockAmendment final : private SendStamp {
 public:
  struct Request {
    std::uint16_t station = 0;          // address of the clock
    std::optional<std::uint8_t> depth;  // 0x0934
    bool told = true;                   // its time, behind that; if not, it is only asked for it
  };
  ClockAmendment() = default;
  ClockAmendment(const ClockAmendment&) = delete;
  ClockAmendment& operator=(const ClockAmendment&) = delete;

  /// The link puts its own send time into what is written (Datagram::corrected_by_link).
  void correct_by_link() { corrected_by_link_ = true; }

  /// The time is asked of `stamp` when the frame is built, which calls write(). Waits for the answer until `deadline`;
  /// a frame that is not back then is lost like any other. Errors of the link.
  Status run(FrameExchange& exchange, const Request& request, SendStamp& stamp, Nanoseconds deadline);
  /// The depth, and then a message that says nothing new: the clock is asked for its time in one frame and told that in
  /// the next. Its average begins at zero, and it runs on with the rate that it has learned. Both frames are as long on
  /// their way from the stamp to the wire, so that this is no part of the message.
  Status settle(FrameExchange& exchange, const Request& request, Nanoseconds deadline);
  /// System time for the frame that is being sent.
  void write(Nanoseconds time);
  [[nodiscard]] bool sending() const { return sending_; }
  /// Low half of the clock's time when the frame passed, when it came back from the clock.
  [[nodiscard]] std::optional<std::uint32_t> reading() const;
  [[nodiscard]] Nanoseconds send_time() const { return frame_.send_time(); }

 private:
  void stamp(Nanoseconds send_time) override;  // in settle()

  std::array<std::uint8_t, 1> depth_{};
  std::array<std::uint8_t, 4> written_{}, read_{};
  Datagram filter_, write_, reading_;
  PendingFrame frame_;
  bool sending_ = false, told_ = false, corrected_by_link_ = false;
  Nanoseconds stamped_at_ = 0;        // in settle(), as is
  std::optional<Nanoseconds> ahead_;  // of the host's clock
};

}  // namespace syncline
