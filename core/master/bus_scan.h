// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "config/device_description.h"
#include "config/project.h"
#include "protocol/dl_status.h"
#include "protocol/sii.h"
#include "support/result.h"

namespace syncline {

enum class DcCapability : std::uint8_t { kNone, kReceiveTimesOnly, kSystemTime32, kSystemTime64 };

struct ScannedSlave {
  std::uint16_t position = 0;
  std::uint16_t station_address = 0;      // given by the scan
  std::uint16_t alias = 0;
  Identity identity;
  std::uint16_t al_status = 0;
  DlStatus dl_status;
  std::uint8_t esc_type = 0;
  std::uint8_t fmmu_count = 0, sync_manager_count = 0;
  std::uint16_t features = 0;
  DcCapability dc = DcCapability::kNone;  // probed at 0x0910, feature bits lie
  std::optional<PreviousPort> previous;   // topology from DL status
  std::optional<sii::Image> sii;          // empty when it could not be parsed
  std::optional<Error> sii_error;
};

struct BusScan {
  std::vector<ScannedSlave> slaves;       // frame order
};

/// Project slave from the SII alone, for a device without an ESI.
[[nodiscard]] DeviceDescription device_from_sii(const sii::Image& image);

}  // namespace syncline
