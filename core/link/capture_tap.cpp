// SPDX-License-Identifier: Apache-2.0
#include "link/capture_tap.h"

#include "link/pcapng_writer.h"

namespace syncline {
namespace {

class CaptureTap final : public Link {
 public:
  CaptureTap(std::unique_ptr<Link> inner, PcapngWriter writer, Clock& clock)
      : inner_(std::move(inner)), writer_(std::move(writer)), clock_(clock) {}
  ~CaptureTap() override { (void)writer_.finish(); }

  Status send(std::span<const std::uint8_t> frame) override {
    // First the wire, then the file: writing would come between the master's stamp and the frame.
    const auto time = clock_.now();
    auto status = inner_->send(frame);
    writer_.write(frame, inner_->sent_at().value_or(time), PcapngWriter::Direction::kSent);
    return status;
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }

  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    // As handed over: what the adapter makes of the time is seen in what comes back.
    writer_.write(frame, clock_.now(), PcapngWriter::Direction::kSent);
    return inner_->send_corrected(frame, field);
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    if (received && received->length > 0) {
      writer_.write(buffer.first(received->length), received->arrival_time, PcapngWriter::Direction::kReceived);
    }
    return received;
  }

  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  PcapngWriter writer_;
  Clock& clock_;
};

}  // namespace

Result<std::unique_ptr<Link>> make_capture_tap(std::unique_ptr<Link> inner, const std::string& path, Clock& clock) {
  auto writer = PcapngWriter::create(path);
  if (!writer) return tl::unexpected(writer.error());
  return std::make_unique<CaptureTap>(std::move(inner), std::move(*writer), clock);
}

}  // namespace syncline
