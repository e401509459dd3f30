// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>

#include "fuzz/script.h"
#include "link/link.h"
#include "protocol/frame.h"

namespace syncline::fuzz {

/// Gives back something else than what came over another link, as a script says; when the script is over it is honest.
class LyingLink final : public Link {
 public:
  LyingLink(std::unique_ptr<Link> inner, Script& script) : inner_(std::move(inner)), script_(script) {}

  Status send(std::span<const std::uint8_t> frame) override { return inner_->send(frame); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override;
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  /// False: the frame is not delivered now.
  bool lie(std::span<std::uint8_t> buffer, std::size_t& length);
  void lie_in_datagram(std::span<std::uint8_t> frame);

  std::unique_ptr<Link> inner_;
  Script& script_;
  std::deque<Bytes> waiting_;  // for a later receive()
};

}  // namespace syncline::fuzz
