// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "support/result.h"

namespace syncline {

class Bus;
struct NetworkConfig;
struct SlaveMailbox;
class Sm2Reader;
struct Snapshot;

/// Asks the slaves by SDO information what stands in 0x1C32:0B and :0C, and tells the reader which of them counts
/// missed SM2 events; slaves that do not say keep their vendor's place. One of each kind is asked. Needs PREOP.
/// Only errors of the bus and a cancel are errors.
Status find_sm2_counters(Bus& bus, const NetworkConfig& config, const Snapshot& snapshot,
                         std::span<SlaveMailbox> mailboxes, Sm2Reader& reader);

}  // namespace syncline
