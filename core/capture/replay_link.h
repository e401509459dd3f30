// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/result.h"

namespace syncline {

class Link;
class VirtualClock;

/// What a capture proves, and what it leaves open.
struct ReplayNotes {
  struct Slave {
    bool vendor_id = false, product_code = false, revision_no = false, serial_no = false;  // read from the EEPROM
    bool alias = false, state = false, ports = false, dc = false;
    std::size_t sii_words = 0;
  };
  std::vector<Slave> slaves;
  std::size_t frames = 0;
  std::size_t cut_frames = 0;       // captured in part only: passed over
  std::optional<Error> broken_off;  // the file ends in the middle of a frame; what came before is used
};

/// A bus as a capture recorded it: reads are answered from what the capture's master read, addresses can be
/// set and the EEPROM be read as far as it was; whatever the capture does not hold gets no working counter,
/// like a register that is not there. Nothing else happens behind it: a scan works, a bring-up ends at the
/// first state change. Time is virtual.
///
/// Errors of the file; kNotThatKindOfFile when the capture holds no answered EtherCAT frame. `notes` may be null.
[[nodiscard]] Result<std::unique_ptr<Link>> make_replay_link(const std::string& path, VirtualClock& clock,
                                                             ReplayNotes* notes = nullptr);

}  // namespace syncline
