// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "link/link.h"

namespace syncline {

class Clock;

/// What a bad line, a busy host or a wrong switch does to frames. Probabilities are per frame, 0 to 1.
struct LinkFaults {
  double lose_request = 0;  // never reaches the bus: nothing is executed
  double lose_reply = 0;    // executed, but the answer is lost
  double duplicate = 0;     // the answer comes twice
  double reorder = 0;       // the answer comes behind the one that follows it
  double late = 0;          // the answer comes `late_by` later than it would
  Nanoseconds late_by = 30 * kMillisecond;
  std::uint64_t seed = 1;
};

/// Decorator that damages the traffic of another link, the same way for the same seed. A late answer
/// is held back by the decorator and delivered by a later receive().
class FaultLink final : public Link {
 public:
  FaultLink(std::unique_ptr<Link> inner, Clock& clock, const LinkFaults& faults);
  ~FaultLink() override;
  /// From the next frame on.
  void set_faults(const LinkFaults& faults);

  struct Injected {
    std::uint64_t sent = 0, lost = 0, duplicated = 0, reordered = 0, late = 0;
  };
  [[nodiscard]] const Injected& injected() const;

  Status send(std::span<const std::uint8_t> frame) override;
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override;
  [[nodiscard]] LinkDescription describe() const override;
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override;
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline
