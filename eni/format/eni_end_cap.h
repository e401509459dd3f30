// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

namespace syncline::eni {

/// Some tools write the end cap of a row of terminals, or another part without an EtherCAT slave controller, as a Slave
/// without address, commands, process data and mailbox. On the bus there is nobody: readers count and check the others.
[[nodiscard]] bool is_end_cap(const tinyxml2::XMLElement& slave);

}  // namespace syncline::eni
