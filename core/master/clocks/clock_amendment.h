// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "master/exchange/frame_exchange.h"

namespace syncline {

/// One frame more to the clock that leads, within the cycle: a second write with a reading behind it. What a frame that
/// left far from its stamp has told the clock too much or too little is taken back some ten microseconds later instead
/// of in the next cycle; the clock's own control loop averages messages, so the two cancel. Cyclic thread; allocates
/// nothing.
class ClockAmendment {
 public:
  ClockAmendment() = default;
  ClockAmendment(const ClockAmendment&) = delete;
  ClockAmendment& operator=(const ClockAmendment&) = delete;

  /// The link puts its own send time into what is written (Datagram::corrected_by_link).
  void correct_by_link() { corrected_by_link_ = true; }

  /// The time is asked of `stamp` when the frame is built, which calls write(). Waits for the answer until `deadline`;
  /// a frame that is not back then is lost like any other. Errors of the link.
  Status run(FrameExchange& exchange, std::uint16_t station, SendStamp& stamp, Nanoseconds deadline);
  /// System time for the frame that is being sent.
  void write(Nanoseconds time);
  [[nodiscard]] bool sending() const { return sending_; }
  /// Low half of the clock's time when the frame passed, when it came back from the clock.
  [[nodiscard]] std::optional<std::uint32_t> reading() const;
  [[nodiscard]] Nanoseconds send_time() const { return frame_.send_time(); }

 private:
  std::array<std::uint8_t, 4> written_{}, read_{};
  Datagram write_, reading_;
  PendingFrame frame_;
  bool sending_ = false, corrected_by_link_ = false;
};

}  // namespace syncline
