// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/exchange/slave_mailbox.h"
#include "master/mailbox/fetch_work.h"
#include "master/mailbox/sdo_work.h"
#include "protocol/coe.h"

namespace syncline {

struct Snapshot;

/// The master's own work in the slaves' mailboxes while the bus runs: fetches a message that nobody asked for, or
/// uploads an object of at most 4 bytes; one slave at a time. Tells emergencies by events. Allocates nothing in the
/// cycle.
class CyclicMailbox {
 public:
  struct Answer {
    enum class Kind : std::uint8_t {
      kValue,
      kAbort,
      kFetched,
      kNothing
    };  // kNothing: no answer in time, or an unusable one
    std::uint16_t slave = 0;
    coe::ObjectAddress object;  // index 0: it was a fetch
    Kind kind = Kind::kNothing;
    std::uint32_t value = 0;  // of the object, or the abort code
    bool emergency = false;   // one came, now or before the answer
  };

  CyclicMailbox(Snapshot& snapshot, std::span<SlaveMailbox> mailboxes);
  CyclicMailbox(const CyclicMailbox&) = delete;
  CyclicMailbox& operator=(const CyclicMailbox&) = delete;

  /// Nothing is begun while somebody holds it (MailboxHold); what is under way is still finished.
  void hold() { ++holds_; }
  void release() { --holds_; }
  [[nodiscard]] bool idle() const { return !busy_; }
  /// What is under way gets no answer: its slave is gone, or set up anew.
  void give_up();
  /// Something may be begun with this slave: nothing is under way, and its mailbox works in its state.
  [[nodiscard]] bool ready_for(std::size_t slave) const;

  void upload(std::size_t slave, coe::ObjectAddress object);
  void fetch(std::size_t slave);

  /// As of a SlaveWork, in each cycle.
  Datagram* next(Nanoseconds now);
  void take(Nanoseconds now);
  /// After the cycle: what has come to its end.
  std::optional<Answer> answer();

 private:
  void begin(std::size_t slave, coe::ObjectAddress object);
  [[nodiscard]] bool fetching() const { return current_.object.index == 0; }
  [[nodiscard]] SlaveWork& work() { return fetching() ? static_cast<SlaveWork&>(fetch_) : sdo_; }
  void judge();

  static constexpr std::size_t kMostBytes = 4;

  Snapshot& snapshot_;
  std::span<SlaveMailbox> mailboxes_;
  SdoWork sdo_;
  FetchWork fetch_;
  std::vector<std::uint8_t> value_;
  Answer current_;
  int holds_ = 0;
  bool busy_ = false;
};

}  // namespace syncline
