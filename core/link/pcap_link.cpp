// SPDX-License-Identifier: Apache-2.0
#include "link/pcap_link.h"

#include <algorithm>

#include "link/raw_port.h"
#include "protocol/frame.h"
#include "support/clock.h"

namespace syncline {
namespace {

class PcapLink final : public Link {
 public:
  PcapLink(RawPort port, Clock& clock) : port_(std::move(port)), source_(port_.adapter().mac), clock_(clock) {
    // The first ESC sets this bit. Frames leave without it, so that a returned frame differs from a
    // sent one on cards whose own address has it (veth, USB adapters).
    source_[0] &= static_cast<std::uint8_t>(~kLocallyAdministered);
  }

  Status send(std::span<const std::uint8_t> frame) override { return port_.send(frame); }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return port_.sent_at(); }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    for (;;) {
      // Waited for first: right behind sending nothing is there yet, and to look would be a system call of its own.
      const auto left = deadline - clock_.now();
      port_.wait(left);
      const auto found = port_.poll();
      if (!found) return tl::unexpected(found.error());
      if (const auto& frame = *found) {
        if (is_echo(frame->bytes)) continue;
        const auto length = std::min(frame->bytes.size(), buffer.size());
        std::copy_n(frame->bytes.begin(), length, buffer.begin());
        return ReceivedFrame{length, frame->arrival_time};
      }
      if (left <= 0) return ReceivedFrame{};
    }
  }

  [[nodiscard]] LinkDescription describe() const override {
    return {"nic:" + port_.adapter().name, "nic", source_, port_.adapter().up};
  }

 private:
  /// Our own frame as it left. Where the adapter tells directions apart the address says nothing: a
  /// segment with DL control bit 0 cleared returns it unchanged.
  [[nodiscard]] bool is_echo(std::span<const std::uint8_t> frame) const {
    return port_.sees_own() && frame.size() >= kEthernetHeaderSize &&
           std::equal(source_.begin(), source_.end(), frame.begin() + 6);
  }

  RawPort port_;
  MacAddress source_;
  Clock& clock_;
};

}  // namespace

Result<std::unique_ptr<Link>> open_pcap_link(const std::string& adapter, Clock& clock) {
  auto port = RawPort::open(adapter, clock, true);
  if (!port) return tl::unexpected(port.error());
  return std::make_unique<PcapLink>(std::move(*port), clock);
}

}  // namespace syncline
