// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/cyclic_frame.h"
#include "config/dc_settings.h"
#include "config/master_config.h"
#include "config/process_image.h"
#include "config/real_time_settings.h"
#include "config/recovery_settings.h"
#include "config/slave_config.h"
#include "support/types.h"

/// What is exported and what is run: the content of an ENI file (ETG.2100) as a value. The ENI
/// writer serialises it, the master executes it.
namespace syncline {

struct NetworkConfig {
  MasterConfig master;
  std::vector<SlaveConfig> slaves;
  std::vector<CyclicTask> cyclic;  // the first is the base task
  ProcessImage image;
  /// Run-time DC parameters. The ENI carries the mode and whether the window is monitored by its
  /// commands; the numbers (limit, settle time, burst, set value) are the project's, or the
  /// defaults when an ENI is run.
  DcMasterSettings dc;
  /// As `dc`: the project's, or the defaults when an ENI is run.
  RecoverySettings recovery;
  RealTimeSettings real_time;
  /// Run time, too: a device says that it does not know FRMW (ESI, Dc@UnknownFRMW; ETG.2000), so that it follows ARMW.
  bool frmw_unknown = false;
  bool operator==(const NetworkConfig&) const = default;

  [[nodiscard]] Nanoseconds cycle_time() const { return cyclic.empty() ? kMillisecond : cyclic.front().cycle_time; }
  /// Position of the slave whose DC element says ReferenceClock, if any.
  [[nodiscard]] std::optional<std::uint16_t> reference_clock() const;
  /// First slave of the hot-connect group that this slave belongs to, if any.
  [[nodiscard]] std::optional<std::size_t> hot_connect_head(std::size_t slave) const;
};

}  // namespace syncline
