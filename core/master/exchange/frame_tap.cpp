// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/frame_tap.h"

#include <utility>

#include "channels/frame_ring.h"
#include "channels/master_channels.h"
#include "link/link.h"
#include "support/clock.h"

namespace syncline {
namespace {

class FrameTap final : public Link {
 public:
  FrameTap(std::unique_ptr<Link> inner, Clock& clock, MasterChannels& channels)
      : inner_(std::move(inner)), clock_(clock), channels_(channels), ring_(channels.frames) {}

  Status send(std::span<const std::uint8_t> frame) override {
    if (!ring_->is_open()) {
      auto plain = inner_->send(frame);
      channels_.beat();
      return plain;
    }
    // First the wire, then the copy: it would come between the master's stamp and the frame.
    const auto time = clock_.now();
    auto status = inner_->send(frame);
    channels_.beat();
    if (status) ring_->push(frame, inner_->sent_at().value_or(time), FrameDirection::kSent);
    return status;
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }

  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    auto sent = inner_->send_corrected(frame, field);
    channels_.beat();
    // As handed over: what the adapter makes of the time is seen in what comes back.
    if (sent) ring_->push(frame, *sent, FrameDirection::kSent);
    return sent;
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    channels_.beat();
    if (received && received->length > 0)
      ring_->push(buffer.first(received->length), received->arrival_time, FrameDirection::kReceived);
    return received;
  }

  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  Clock& clock_;
  MasterChannels& channels_;
  std::shared_ptr<FrameRing> ring_;
};

}  // namespace

std::unique_ptr<Link> make_frame_tap(std::unique_ptr<Link> inner, Clock& clock, MasterChannels& channels) {
  return std::make_unique<FrameTap>(std::move(inner), clock, channels);
}

}  // namespace syncline
