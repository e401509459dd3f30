// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "master/cyclic/cyclic_frame_set.h"

namespace syncline {

class RunState;
struct SlaveConfig;

/// A bit of the logical address space.
struct LogicalBit {
  std::uint32_t address = 0;
  std::uint8_t bit = 0;
  bool operator==(const LogicalBit&) const = default;
};
/// Where a slave's FMMU puts the state of its input mailbox (bits of the SyncManager's status), by its init commands.
[[nodiscard]] std::optional<LogicalBit> mailbox_state_bit(const SlaveConfig& slave);

/// Takes the mailbox states out of the cyclic frames, cycle by cycle, into RunState::mailboxes.
class MailboxBits {
 public:
  MailboxBits(RunState& run, const CyclicFrameSet& frames);
  void observe();
  /// The configuration brings this slave's bit; if not, its SyncManager is asked.
  [[nodiscard]] bool has(std::size_t slave) const;

 private:
  struct Place {
    std::size_t slave = 0;
    CyclicFrameSet::LogicalByte byte;
    std::uint8_t mask = 0;
  };
  RunState& run_;
  const CyclicFrameSet& frames_;
  std::vector<Place> places_;
};

}  // namespace syncline
