// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "link/fault_link.h"
#include "link/link.h"
#include "master/exchange/bus.h"
#include "master/mailbox/mailbox_client.h"
#include "protocol/coe.h"
#include "protocol/datagram.h"
#include "protocol/emergency.h"
#include "protocol/frame.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "support/clock.h"

namespace syncline::test {

/// One slave that is nothing but a mailbox with its hand-shake: full and empty, counters, repeat request. What it
/// answers is the test's.
class MailboxSlave final : public Link {
 public:
  using Handler = std::function<std::vector<MailboxMessage>(const MailboxMessage&)>;
  static constexpr std::uint16_t kStation = 1001, kSend = 0x1000, kReceive = 0x1400;

  MailboxSlave(VirtualClock& clock, std::uint16_t mailbox_size) : clock_(clock), size_(mailbox_size) {}

  Handler handler;
  bool answers_repeats = true;
  bool has_repeats = true;  // else it acknowledges and its mailbox stays empty
  std::size_t requests = 0, repeats = 0;

  Status send(std::span<const std::uint8_t> frame) override {
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    FrameReader reader(bytes);
    while (auto datagram = reader.next()) execute(*datagram);
    returning_.push_back({clock_.now() + kMicrosecond, std::move(bytes)});
    return {};
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (returning_.empty() || returning_.front().first > deadline) {
      clock_.advance_to(deadline);
      return ReceivedFrame{};
    }
    auto [time, bytes] = std::move(returning_.front());
    returning_.pop_front();
    clock_.advance_to(time);
    std::ranges::copy(bytes, buffer.begin());
    return ReceivedFrame{bytes.size(), time};
  }
  [[nodiscard]] LinkDescription describe() const override { return {"mailbox", "simulated", {}, true}; }
  [[nodiscard]] MailboxPort port() const {
    MailboxPort port;
    port.name = "slave";
    port.station_address = kStation;
    port.send = {kSend, size_};
    port.receive = {kReceive, size_};
    return port;
  }

 private:
  static constexpr std::uint16_t kSm1 = reg::kSyncManager + SyncManager::kSize;

  void execute(DatagramView& d) {
    if (d.header.adp() != kStation) return;
    if (serve(d)) d.set_wkc(static_cast<std::uint16_t>(d.wkc() + 1));
  }
  bool serve(DatagramView& d) {
    const bool write = d.header.command == Command::kFpwr;
    switch (d.header.ado()) {
      case kSend:
        return write && take(d.data);
      case kReceive:
        return !write && give(d.data);
      case kSm1 + 5:
        d.data[0] = posted_ ? SyncManager::kStatusMailboxFull : std::uint8_t{0};
        return true;
      case kSm1 + 6:
        if (write) request_repeat(d.data[0]);
        if (!write) d.data[0] = activate_;
        if (!write && d.data.size() > 1) d.data[1] = acknowledge_;
        return true;
      default:
        return false;
    }
  }
  bool take(std::span<const std::uint8_t> bytes) {
    const auto message = MailboxMessage::decode(bytes);
    if (!message || (message->counter != 0 && message->counter == last_counter_)) return true;
    last_counter_ = message->counter;
    ++requests;
    for (auto& answer : handler(*message)) {
      counter_ = next_mailbox_counter(counter_);
      if (answer.counter == 0) answer.counter = counter_;
      queue_.push_back(answer.encode(size_));
    }
    post();
    return true;
  }
  bool give(std::span<std::uint8_t> data) {
    if (!posted_) return false;
    std::copy_n(posted_->begin(), std::min(data.size(), posted_->size()), data.begin());
    last_ = *posted_;
    posted_.reset();
    post();
    return true;
  }
  void post() {
    if (posted_ || queue_.empty()) return;
    posted_ = std::move(queue_.front());
    queue_.pop_front();
  }
  /// The message that was fetched last lies in front of those that were not.
  void request_repeat(std::uint8_t activate) {
    const bool toggled = ((activate ^ activate_) & 0x02) != 0;
    activate_ = activate;
    if (!toggled || !answers_repeats) return;
    ++repeats;
    acknowledge_ = activate_ & 0x02;
    if (!last_ || !has_repeats) return;
    if (posted_ && *posted_ != *last_) queue_.push_front(std::move(*posted_));
    posted_ = last_;
  }

  VirtualClock& clock_;
  std::uint16_t size_;
  std::deque<std::pair<Nanoseconds, std::vector<std::uint8_t>>> returning_;
  std::deque<std::vector<std::uint8_t>> queue_;
  std::optional<std::vector<std::uint8_t>> posted_, last_;
  std::uint8_t activate_ = 1, acknowledge_ = 0, counter_ = 0, last_counter_ = 0;
};

/// A client of that slave over a link that may lose frames.
class MailboxBed {
 public:
  explicit MailboxBed(double loss = 0, std::uint16_t mailbox_size = 128, std::uint64_t seed = 1) {
    auto owned = std::make_unique<MailboxSlave>(clock, mailbox_size);
    slave = owned.get();
    LinkFaults faults;
    faults.lose_request = faults.lose_reply = loss / 2;
    faults.late = loss / 2;
    faults.seed = seed;
    link = std::make_unique<FaultLink>(std::move(owned), clock, faults);
    exchange = std::make_unique<FrameExchange>(*link, clock);
    bus = std::make_unique<Bus>(*exchange, clock);
    mailbox.port = slave->port();
    mailbox.on_emergency = [this](const coe::Emergency& e, Nanoseconds) { emergencies.push_back(e); };
    client = std::make_unique<MailboxClient>(*bus, mailbox);
  }
  [[nodiscard]] Nanoseconds elapsed() const { return clock.now() - start; }

  VirtualClock clock;
  Nanoseconds start = clock.now();
  MailboxSlave* slave = nullptr;
  std::unique_ptr<FaultLink> link;
  std::unique_ptr<FrameExchange> exchange;
  std::unique_ptr<Bus> bus;
  SlaveMailbox mailbox;
  std::vector<coe::Emergency> emergencies;
  std::unique_ptr<MailboxClient> client;
};

[[nodiscard]] inline MailboxMessage message_of(MailboxType type, std::vector<std::uint8_t> data) {
  MailboxMessage message;
  message.type = type;
  message.data = std::move(data);
  return message;
}
[[nodiscard]] inline MailboxMessage coe_message(const coe::Response& response) {
  return message_of(MailboxType::kCoe, coe::encode(response));
}

}  // namespace syncline::test
