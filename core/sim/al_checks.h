// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config/sim_config.h"
#include "sim/esc.h"
#include "sim/process_data.h"

namespace syncline::sim {

/// AL status codes of the checks that any device makes (ETG.1000.6, table 11).
namespace al_code {
inline constexpr std::uint16_t kInvalidRequest = 0x0011, kUnknownRequest = 0x0012, kNoBoot = 0x0013,
                               kInvalidBootMailbox = 0x0015, kInvalidMailbox = 0x0016, kInvalidSyncManager = 0x0017,
                               kNoOutputs = 0x0019, kWatchdog = 0x001B, kInvalidOutputs = 0x001D, kInvalidInputs = 0x001E,
                               kInvalidSyncConfiguration = 0x0030;
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
  /// PREOP -> SAFEOP: SyncManagers of the process data, then SYNC signals.
  [[nodiscard]] std::uint16_t safeop() const;

 private:
  [[nodiscard]] std::uint16_t process_data() const;
  [[nodiscard]] bool in_place(PdoDirection direction) const;
  [[nodiscard]] bool fits(PdoDirection direction) const;
  /// SYNC signals that no operation mode of the device has.
  [[nodiscard]] std::uint16_t dc() const;

  const SimSlaveConfig& config_;
  const Esc& esc_;
  const ProcessData& process_data_;
};

}  // namespace syncline::sim
