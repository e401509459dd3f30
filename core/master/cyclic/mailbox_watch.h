// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/cyclic/cyclic_mailbox.h"
#include "master/exchange/slave_mailbox.h"

namespace syncline {

class MailboxBits;
struct NetworkConfig;

/// Notices in the running bus what slaves have to say without being asked: messages in their mailboxes (by the bits in
/// the cyclic frames, or where a slave has none by reading the SyncManagers' status, many slaves a frame, at the
/// configuration's PollTime), and news in their diagnosis histories (0x10F3:04, one slave at a time, each every
/// kHistoryPeriod and after each emergency). Allocates nothing in the cycle.
class MailboxWatch {
 public:
  static constexpr Nanoseconds kHistoryPeriod = 2 * kSecond;

  MailboxWatch(const NetworkConfig& config, std::span<SlaveMailbox> mailboxes, CyclicMailbox& mailbox,
               const MailboxBits& bits);
  MailboxWatch(const MailboxWatch&) = delete;
  MailboxWatch& operator=(const MailboxWatch&) = delete;

  void add_to(PendingFrame& frame, Nanoseconds now);
  void take_polls();
  void take(const CyclicMailbox::Answer& answer, Nanoseconds now);

  /// A slave whose history holds what was not told yet, as far as is known.
  [[nodiscard]] std::optional<std::size_t> news() const;
  /// Sub-index of the newest message of its history that was told; 0: none.
  [[nodiscard]] std::uint8_t told(std::size_t slave) const;
  /// It was read up to there; nothing: the slave does not give its history after all.
  void note_told(std::size_t slave, std::optional<std::uint8_t> newest);

 private:
  struct Watched {
    std::uint16_t slave = 0;
    Nanoseconds poll_period = 0;  // 0: its bit is in the cyclic frames
    Nanoseconds next_poll = 0;
    bool full = false;  // by the poll
    std::array<std::uint8_t, 1> status{};
    Datagram poll;
    bool has_history = false;
    bool history_due = false;  // ask 0x10F3:04
    bool newest_due = false;   // ask 0x10F3:02
    bool news = false;
    std::uint8_t told = 0;
  };
  void add_polls(PendingFrame& frame, Nanoseconds now);
  void begin();
  /// In turn: the first one is behind the last.
  [[nodiscard]] std::size_t behind(std::size_t place) const { return place + 1 == watched_.size() ? 0 : place + 1; }
  void schedule_history(Nanoseconds now);
  [[nodiscard]] bool full(const Watched& slave) const;
  [[nodiscard]] Watched* find(std::size_t slave);
  [[nodiscard]] const Watched* find(std::size_t slave) const;

  std::span<SlaveMailbox> mailboxes_;
  CyclicMailbox& mailbox_;
  std::vector<Watched> watched_;  // slaves with a mailbox
  std::size_t next_ = 0, next_poll_ = 0, next_history_ = 0;
  std::size_t polled_begin_ = 0, polled_ = 0;
  Nanoseconds history_slot_ = 0;
};

}  // namespace syncline
