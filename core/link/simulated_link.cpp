// SPDX-License-Identifier: Apache-2.0
#include "link/simulated_link.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "link/link.h"
#include "protocol/frame.h"
#include "reasons/because.h"
#include "sim/sim_bus.h"
#include "support/byte_order.h"
#include "support/calendar_stamp.h"
#include "support/clock.h"
#include "support/random.h"
#include "support/result.h"

namespace syncline {
namespace {

class SimulatedLink final : public Link {
 public:
  SimulatedLink(std::string name, std::unique_ptr<sim::SimBus> bus, Clock& clock, const SimulatedHost& host)
      : name_(std::move(name)),
        bus_(std::move(bus)),
        clock_(clock),
        virtual_clock_(dynamic_cast<VirtualClock*>(&clock)),
        stamp_error_(host.stamp_error),
        random_(host.seed),
        calendar_steps_(host.calendar_steps),
        adapter_(host.adapter) {
    if (!calendar_steps_.empty()) stamps_.emplace(clock_, [this] { return calendar_at(clock_.now()); });
  }

  Status send(std::span<const std::uint8_t> frame) override {
    if (adapter_.is_off(clock_.now())) return fail(ErrorCode::kLinkDown, name_);
    auto& slot = take_slot();
    slot.bytes.assign(frame.begin(), frame.end());
    put_on_wire(slot, hand_over());
    return {};
  }

  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    if (adapter_.is_off(clock_.now())) return fail(ErrorCode::kLinkDown, name_);
    const auto start = hand_over();
    if (field.offset > frame.size() || frame.size() - field.offset < field.size ||
        (field.size != 4 && field.size != 8)) {
      return fail(ErrorCode::kMalformedData, name_, because("the place of the send time is not in the frame"));
    }
    auto& slot = take_slot();
    slot.bytes.assign(frame.begin(), frame.end());
    const auto place = std::span(slot.bytes).subspan(field.offset, field.size);
    const auto late = static_cast<std::uint64_t>(start - field.send_time);
    if (field.size == 8) {
      store_le(place, load_le<std::uint64_t>(place) + late);
    } else {
      store_le(place, load_le<std::uint32_t>(place) + static_cast<std::uint32_t>(late));
    }
    put_on_wire(slot, start);
    return start;
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (adapter_.is_off(clock_.now())) return fail(ErrorCode::kLinkDown, name_);
    auto next = in_flight_.empty() ? deadline : std::min(deadline, in_flight_.front().arrival);
    next = adapter_.next_off(clock_.now(), next);
    pass_time(next);
    // What came before is found when the adapter is back.
    if (adapter_.is_off(clock_.now())) return fail(ErrorCode::kLinkDown, name_);
    // As on a network card: a host that comes late to its deadline finds what arrived meanwhile.
    if (in_flight_.empty() || in_flight_.front().arrival > std::max(next, clock_.now())) return ReceivedFrame{};
    auto& slot = in_flight_.front();
    const auto length = std::min(slot.bytes.size(), buffer.size());
    std::copy_n(slot.bytes.begin(), length, buffer.begin());
    const ReceivedFrame received{length, stamped(slot.arrival)};
    spare_.push_back(std::move(slot.bytes));
    in_flight_.pop_front();
    return received;
  }

  [[nodiscard]] LinkDescription describe() const override {
    return {name_, "simulated", {0x00, 0x53, 0x4C, 0x00, 0x00, 0x01}, !adapter_.is_off(clock_.now()), true};
  }

 private:
  struct InFlight {
    std::vector<std::uint8_t> bytes;
    Nanoseconds arrival = 0;
  };

  [[nodiscard]] Nanoseconds calendar_at(Nanoseconds time) const {
    auto calendar = time;
    for (const auto& step : calendar_steps_) calendar += step.at <= time ? step.by : 0;
    return calendar;
  }

  /// As RawPort knows the arrival: by a stamp of the calendar clock.
  [[nodiscard]] Nanoseconds stamped(Nanoseconds arrival) {
    return stamps_ ? stamps_->to_clock(calendar_at(arrival)) : arrival;
  }

  /// The host is through with sending; its card takes one frame after the other, as the wire does where nobody holds
  /// frames up.
  Nanoseconds hand_over() {
    if (!stamp_error_.empty()) pass_time(clock_.now() + std::llround(stamp_error_.at(random_.uniform())));
    return std::max(clock_.now(), card_free_);
  }

  void put_on_wire(InFlight& slot, Nanoseconds handed_over) {
    const auto length = wire_time_ns(slot.bytes.size());
    card_free_ = handed_over + length;
    // Who holds frames up keeps their order.
    const auto start = std::max(handed_over + adapter_.frame_held(handed_over), wire_free_);
    if (adapter_.is_off(start)) return in_flight_.pop_back();
    wire_free_ = start + length;
    const auto returned = bus_->execute(slot.bytes, start);
    slot.arrival = returned.arrival_time;
    if (const auto held = adapter_.answer_held(slot.arrival); held > 0 || slot.arrival < last_arrival_)
      slot.arrival = std::max(slot.arrival + held, last_arrival_);
    if (returned.lost || adapter_.is_off(slot.arrival)) return in_flight_.pop_back();
    if (!adapter_.holds_answers.empty()) last_arrival_ = slot.arrival;
  }

  /// Buffers are used again, so that a steady run does not allocate.
  InFlight& take_slot() {
    InFlight slot;
    if (!spare_.empty()) {
      slot.bytes = std::move(spare_.back());
      spare_.pop_back();
    }
    return in_flight_.emplace_back(std::move(slot));
  }

  /// Frames in flight are no wake-up of the host: virtual time moves without its jitter.
  void pass_time(Nanoseconds time) {
    if (virtual_clock_ != nullptr) {
      virtual_clock_->advance_to(time);
    } else {
      clock_.sleep_until(time);
    }
  }

  std::string name_;
  std::unique_ptr<sim::SimBus> bus_;
  Clock& clock_;
  VirtualClock* virtual_clock_;
  QuantileCurve stamp_error_;
  Random random_;
  std::vector<SimulatedHost::CalendarStep> calendar_steps_;
  std::optional<ArrivalStamp> stamps_{};
  AdapterFaults adapter_;
  Nanoseconds card_free_ = 0, wire_free_ = 0;
  Nanoseconds last_arrival_ = 0;  // where answers are held up
  std::deque<InFlight> in_flight_;
  std::vector<std::vector<std::uint8_t>> spare_;
};

}  // namespace

std::unique_ptr<Link> make_simulated_link(std::string name, std::unique_ptr<sim::SimBus> bus, Clock& clock,
                                          const SimulatedHost& host) {
  return std::make_unique<SimulatedLink>(std::move(name), std::move(bus), clock, host);
}

}  // namespace syncline
