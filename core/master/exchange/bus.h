// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <concepts>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "master/exchange/acyclic_window.h"
#include "master/exchange/frame_exchange.h"
#include "support/byte_order.h"

namespace syncline {

/// Keeps the bus cycle running while somebody waits for something.
class CyclePump {
 public:
  virtual ~CyclePump() = default;
  /// One bus cycle. `acyclic` are sent in the same cycle as far as they fit; the rest stays unanswered.
  virtual Status run_cycle(std::span<Datagram* const> acyclic) = 0;
};

/// Acyclic access to the slaves in blocking style, for scan and bring-up. Without a pump every request
/// is sent at once and waited for; with one, requests ride with the bus cycles, so that cyclic frames
/// never stop while init commands, SDOs and waits run.
class Bus {
 public:
  Bus(FrameExchange& exchange, Clock& clock, const std::atomic<bool>* cancel = nullptr)
      : exchange_(exchange), clock_(clock), cancel_(cancel), window_(exchange) {}

  /// nullptr: no cyclic operation.
  void set_pump(CyclePump* pump) { pump_ = pump; }
  [[nodiscard]] bool cyclic() const { return pump_ != nullptr; }
  /// A bring-up can be cancelled, the way down to INIT cannot.
  void set_cancellable(bool cancellable) { cancellable_ = cancellable; }
  [[nodiscard]] bool cancellable() const { return cancellable_; }
  /// A second reason to end what is under way with kCancelled, as long as it may be cancelled.
  void set_interrupt(std::function<bool()> interrupt) { interrupt_ = std::move(interrupt); }
  /// Told when the adapter is away and when it has carried something, as long as there are no cycles.
  void set_link_observer(std::function<void(bool up)> observer) { link_observer_ = std::move(observer); }
  /// Without cycles an adapter that is away is waited for so long: longer, and it is no adapter that somebody plugs in
  /// again.
  static constexpr Nanoseconds kLinkPatience = 5 * kSecond;
  /// kCancelled when the user wants an end; for loops that do not wait through this class.
  [[nodiscard]] Status check_cancel() const;
  [[nodiscard]] Clock& clock() { return clock_; }
  [[nodiscard]] FrameExchange& exchange() { return exchange_; }

  /// Exchanges all datagrams, many a frame and many frames at once. Datagrams in one frame are executed
  /// in their order; across frames no order is promised, so what must follow something else goes into
  /// another call (or is short enough to share its frame). A lost or late frame is repeated: a slave may
  /// execute a repeated datagram twice (times_sent tells), which is harmless for registers and must be
  /// recognised for mailboxes (counter, repeat request) by the caller. Never repeated, and left unanswered
  /// when lost, are `once` datagrams and the commands that read and write in one go (may_repeat()).
  /// Working counters are for the caller to judge. kNoResponse, kCancelled, link errors.
  Status transact(std::span<Datagram> datagrams);
  Status transact(Datagram& datagram) { return transact(std::span(&datagram, 1)); }
  /// Lets time pass: bus cycles, or sleep. kCancelled.
  Status wait(Nanoseconds duration);
  /// One bus cycle, or a millisecond: what lies between two tries.
  Status wait_a_little();

  // Single registers. The result is the working counter.
  Result<std::uint16_t> exchange(Command command, std::uint16_t adp, std::uint16_t ado, std::span<std::uint8_t> data);
  template <std::unsigned_integral T>
  Result<std::uint16_t> write(Command command, std::uint16_t adp, std::uint16_t ado, T value) {
    auto bytes = le_bytes(value);
    return exchange(command, adp, ado, bytes);
  }
  /// Reads by station address; kNoResponse with `subject` when no slave answers.
  template <std::unsigned_integral T>
  Result<T> read(std::uint16_t station, std::uint16_t ado, const std::string& subject) {
    std::array<std::uint8_t, sizeof(T)> bytes{};
    const auto wkc = exchange(Command::kFprd, station, ado, bytes);
    if (!wkc) return tl::unexpected(wkc.error());
    if (*wkc == 0) return fail(ErrorCode::kNoResponse, subject);
    return load_le<T>(bytes);
  }

 private:
  Status ride_with_cycles(std::span<Datagram> datagrams);
  void note_link(const Status& status) const;
  Status await_link(std::span<Datagram> datagrams, Status status);

  FrameExchange& exchange_;
  Clock& clock_;
  const std::atomic<bool>* cancel_;
  CyclePump* pump_ = nullptr;
  bool cancellable_ = true;
  std::function<bool()> interrupt_;
  std::function<void(bool)> link_observer_;
  std::vector<Datagram*> open_;
  AcyclicWindow window_;
};

/// What must come to its end once it has begun: not cancellable while this lives.
class NotCancellable {
 public:
  explicit NotCancellable(Bus& bus) : bus_(bus), before_(bus.cancellable()) { bus.set_cancellable(false); }
  ~NotCancellable() { bus_.set_cancellable(before_); }
  NotCancellable(const NotCancellable&) = delete;
  NotCancellable& operator=(const NotCancellable&) = delete;

 private:
  Bus& bus_;
  bool before_;
};

}  // namespace syncline
