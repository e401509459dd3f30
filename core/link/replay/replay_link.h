// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "link/link.h"
#include "support/clock.h"

namespace syncline {

/// A bus as a capture recorded it: reads are answered from what the capture's master read, addresses can be
/// set and the EEPROM be read as far as it was; whatever the capture does not hold gets no working counter,
/// like a register that is not there. Nothing else happens behind it: a scan works, a bring-up ends at the
/// first state change. Time is virtual.
///
/// Errors of the file; kNotThatKindOfFile when the capture holds no answered EtherCAT frame.
[[nodiscard]] Result<std::unique_ptr<Link>> make_replay_link(const std::string& path, VirtualClock& clock);

}  // namespace syncline
