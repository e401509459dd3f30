// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config/pdo_description.h"
#include "config/slave_options.h"
#include "support/result.h"

namespace syncline {

struct SlaveSettings;

/// Synchronisation settings that the slave's device cannot take: kBadValue, the subject is the key behind "slave.N."
/// ("sync.error_limit"), the detail says what the device takes.
[[nodiscard]] Status check_sync_settings(const SlaveSettings& slave);

/// Value of 0x1C32:01 (outputs) or 0x1C33:01 for a choice. `has_outputs`: the device has output data, whose SM2 event
/// triggers the inputs, too.
[[nodiscard]] std::uint16_t sync_type_value(SyncTypeChoice type, PdoDirection direction, bool has_outputs);

}  // namespace syncline
