// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/identity.h"
#include "config/previous_port.h"
#include "findings/finding.h"
#include "protocol/dl_status.h"
#include "protocol/sii.h"
#include "support/result.h"

namespace syncline {

enum class DcCapability : std::uint8_t { kNone, kReceiveTimesOnly, kSystemTime32, kSystemTime64 };

/// Of a recorded bus: what the recording does not hold. The fields of the slave say nothing then.
struct NotRecorded {
  bool vendor_id = false, product_code = false, revision_no = false, serial_no = false;
  bool alias = false, state = false, ports = false, dc = false;
  bool operator==(const NotRecorded&) const = default;
};

struct ScannedSlave {
  std::uint16_t position = 0;
  std::uint16_t station_address = 0;       // given by the scan, or found when it had to leave it
  std::uint16_t alias = 0;                 // register 0x0012
  std::optional<std::uint16_t> device_id;  // explicit device identification (switches), where the SII names it
  Identity identity;
  std::uint16_t al_status = 0;
  std::uint16_t al_status_code = 0;  // means something when the error flag is set
  DlStatus dl_status;
  std::uint8_t esc_type = 0;
  std::uint8_t fmmu_count = 0, sync_manager_count = 0;
  std::uint16_t features = 0;
  DcCapability dc = DcCapability::kNone;  // probed at 0x0910, feature bits lie
  std::optional<PreviousPort> previous;   // topology from DL status and receive times
  std::uint8_t entry_port = 0;            // towards the master; 0 unless the cables are swapped
  std::optional<sii::Image> sii;          // empty when it could not be read or parsed
  std::optional<Error> sii_error;
  NotRecorded unknown;
  std::optional<std::uint16_t> sii_shared_with;  // first slave of the kind, see SiiReadOptions
};

struct BusScan {
  std::vector<ScannedSlave> slaves;  // frame order
  bool look_only = false;
  std::size_t running = 0;        // slaves that were beyond INIT
  std::vector<Finding> findings;  // wiring, identification, what was left out or touched (core/findings/scan_words.h)
};

}  // namespace syncline
