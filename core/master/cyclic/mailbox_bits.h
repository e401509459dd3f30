// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/cyclic/cyclic_frame_set.h"
#include "master/exchange/slave_mailbox.h"

namespace syncline {

struct NetworkConfig;
struct SlaveConfig;
struct Snapshot;

/// A bit of the logical address space.
struct LogicalBit {
  std::uint32_t address = 0;
  std::uint8_t bit = 0;
  bool operator==(const LogicalBit&) const = default;
};
/// Where a slave's FMMU puts the state of its input mailbox (bits of the SyncManager's status), by its init commands.
[[nodiscard]] std::optional<LogicalBit> mailbox_state_bit(const SlaveConfig& slave);

/// Takes the mailbox states out of the cyclic frames, cycle by cycle, into the mailboxes.
class MailboxBits {
 public:
  MailboxBits(const NetworkConfig& config, const Snapshot& snapshot, std::span<SlaveMailbox> mailboxes,
              const CyclicFrameSet& frames);
  void observe();
  /// The configuration brings this slave's bit; if not, its SyncManager is asked.
  [[nodiscard]] bool has(std::size_t slave) const;

 private:
  struct Place {
    std::size_t slave = 0;
    CyclicFrameSet::LogicalByte byte;
    std::uint8_t mask = 0;
  };
  const Snapshot& snapshot_;
  std::span<SlaveMailbox> mailboxes_;
  const CyclicFrameSet& frames_;
  std::vector<Place> places_;
};

}  // namespace syncline
