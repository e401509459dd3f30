// SPDX-License-Identifier: Apache-2.0
#include "capture/capture_tap.h"

#include <utility>

#include "capture/pcapng_writer.h"
#include "link/link.h"
#include "support/attempt.h"
#include "support/clock.h"

namespace syncline {
namespace {

class CaptureTap final : public Link {
 public:
  CaptureTap(std::unique_ptr<Link> inner, PcapngWriter writer, Clock& clock, std::shared_ptr<CaptureState> state)
      : inner_(std::move(inner)), writer_(std::move(writer)), clock_(clock), state_(std::move(state)) {}
  ~CaptureTap() override {
    attempt([this] { note(writer_.finish()); });
  }

  Status send(std::span<const std::uint8_t> frame) override {
    // First the wire, then the file: writing would come between the master's stamp and the frame.
    const auto time = clock_.now();
    auto status = inner_->send(frame);
    write(frame, inner_->sent_at().value_or(time), PcapngWriter::Direction::kSent);
    return status;
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }

  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    // As handed over: what the adapter makes of the time is seen in what comes back.
    write(frame, clock_.now(), PcapngWriter::Direction::kSent);
    return inner_->send_corrected(frame, field);
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    if (received && received->length > 0) {
      write(buffer.first(received->length), received->arrival_time, PcapngWriter::Direction::kReceived);
    }
    return received;
  }

  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  void write(std::span<const std::uint8_t> frame, Nanoseconds time, PcapngWriter::Direction direction) {
    if (!lost_) note(writer_.write(frame, time, direction));
  }
  void note(const Status& status) {
    if (status || std::exchange(lost_, true)) return;
    if (state_) state_->fail_with(status.error());
  }

  std::unique_ptr<Link> inner_;
  PcapngWriter writer_;
  Clock& clock_;
  std::shared_ptr<CaptureState> state_;
  bool lost_ = false;
};

}  // namespace

void CaptureState::fail_with(Error error) {
  if (failed()) return;
  error_ = std::move(error);
  failed_.store(true, std::memory_order_release);
}

Result<std::unique_ptr<Link>> make_capture_tap(std::unique_ptr<Link> inner, const std::string& path, Clock& clock,
                                               std::shared_ptr<CaptureState> state) {
  auto writer = PcapngWriter::create(path);
  if (!writer) return tl::unexpected(writer.error());
  return std::make_unique<CaptureTap>(std::move(inner), std::move(*writer), clock, std::move(state));
}

}  // namespace syncline
