// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "config/dc_settings.h"
#include "config/real_time_settings.h"
#include "config/recovery_settings.h"
#include "config/register_command.h"
#include "config/sync_unit.h"
#include "config/task_settings.h"
#include "support/types.h"

namespace syncline {

struct MasterSettings {
  std::string name = "Master";
  Nanoseconds cycle_time = kMillisecond;  // 31.25 us .. 100 ms
  std::array<std::uint8_t, 6> destination_mac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 6> source_mac{};
  /// Inputs and outputs of a slave share logical addresses, which halves the frame; off for slaves or masters that
  /// cannot do that.
  bool overlap_process_data = true;
  DcMasterSettings dc;
  RecoverySettings recovery;
  RealTimeSettings real_time;
  ProcessImageSettings image;
  std::vector<TaskSettings> tasks;                 // beside the base task, whose cycle is `cycle_time`
  std::vector<SyncUnit> sync_units;                // beside the unnamed one of the base task
  std::vector<RegisterCommand> register_commands;  // to all slaves, behind the compiler's own
  bool operator==(const MasterSettings&) const = default;
};

}  // namespace syncline
