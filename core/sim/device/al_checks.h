// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "config/pdo_description.h"

namespace syncline {
struct SimSlaveConfig;
}  // namespace syncline

namespace syncline::sim {

class Esc;
class ProcessData;

/// AL status codes that simulated devices give of their own accord (ETG.1000.6, table 11; ETG.1020).
namespace al_code {
inline constexpr std::uint16_t kInvalidRequest = 0x0011, kUnknownRequest = 0x0012, kNoBoot = 0x0013,
                               kInvalidBootMailbox = 0x0015, kInvalidMailbox = 0x0016, kInvalidSyncManager = 0x0017,
                               kNoOutputs = 0x0019, kSyncError = 0x001A, kWatchdog = 0x001B, kInvalidTypes = 0x001C,
                               kInvalidOutputs = 0x001D, kInvalidInputs = 0x001E, kInvalidWatchdog = 0x001F,
                               kNeedsInit = 0x0021, kNeedsPreop = 0x0022, kInvalidInputMapping = 0x0024,
                               kInvalidOutputMapping = 0x0025, kInconsistentSettings = 0x0026, kSyncStopped = 0x002C,
                               kNoSync = 0x002D, kCycleTooSmall = 0x002E, kInvalidSyncConfiguration = 0x0030,
                               kInvalidLatchConfiguration = 0x0031, kPllError = 0x0032, kSyncTimeout = 0x0034,
                               kInvalidSyncCycle = 0x0035, kInvalidSync0Cycle = 0x0036, kInvalidSync1Cycle = 0x0037;
}  // namespace al_code

/// What a device's firmware examines before it enters a state: the registers that the master has set up, against
/// the device's description. AL status code, or 0 when there is nothing to complain about.
class AlChecks {
 public:
  /// All must outlive it.
  AlChecks(const SimSlaveConfig& config, const Esc& esc, const ProcessData& process_data)
      : config_(config), esc_(esc), process_data_(process_data) {}

  /// INIT -> BOOT: mailboxes as the SII's bootstrap area says.
  [[nodiscard]] std::uint16_t bootstrap() const;
  /// INIT -> PREOP.
  [[nodiscard]] std::uint16_t mailbox() const;
  /// PREOP -> SAFEOP: mailbox as it was, SyncManagers, watchdog and FMMUs of the process data, then SYNC signals.
  [[nodiscard]] std::uint16_t safeop() const;
  /// SAFEOP -> OP: SyncManagers as they were.
  [[nodiscard]] std::uint16_t op() const;
  /// The device has set itself up for the SyncManagers as they are now.
  void note_mailbox();
  void note_process_data();

 private:
  /// What a device relies on: start, length, control, and whether it is on.
  struct SetUp {
    std::uint16_t start = 0, length = 0;
    std::uint8_t control = 0;
    bool enabled = false;
    bool operator==(const SetUp&) const = default;
  };
  [[nodiscard]] SetUp set_up(unsigned number) const;
  [[nodiscard]] std::vector<SetUp> set_up(PdoDirection direction) const;
  [[nodiscard]] std::uint16_t process_data() const;
  /// Of the checks below: all SyncManagers of a direction pass it.
  using Check = bool (AlChecks::*)(PdoDirection, unsigned) const;
  [[nodiscard]] bool all(PdoDirection direction, Check check) const;
  /// Process data in mailbox mode or the reverse.
  [[nodiscard]] bool type_fits(PdoDirection direction, unsigned number) const;
  [[nodiscard]] std::uint16_t watchdog() const;
  [[nodiscard]] std::uint16_t mapping() const;
  /// An FMMU that can never work: it reaches the ESC's own buffers, writes inputs, or misses all the data.
  [[nodiscard]] bool mapping_fits(PdoDirection direction, unsigned number) const;
  [[nodiscard]] bool in_place(PdoDirection direction, unsigned number) const;
  [[nodiscard]] bool fits(PdoDirection direction, unsigned number) const;
  /// SYNC signals that no operation mode of the device has, or its latch inputs in the wrong hands.
  [[nodiscard]] std::uint16_t dc() const;

  const SimSlaveConfig& config_;
  const Esc& esc_;
  const ProcessData& process_data_;
  std::array<SetUp, 2> mailbox_{};
  std::array<std::vector<SetUp>, 2> data_{};
};

}  // namespace syncline::sim
