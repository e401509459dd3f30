// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/device_description.h"
#include "eni/esi_reader.h"
#include "eni/xml_reader.h"

/// The parts of an ESI Device element, one function each. Errors go to the node's Reading.
namespace syncline::eni {

/// What stands around the Device elements of a file.
struct EsiVendor {
  std::uint32_t id = 0;
  std::string name;
};

using FileWarnings = std::vector<FileWarning>;

/// Device element; the caller looks at the Reading before it uses the result.
[[nodiscard]] DeviceDescription read_device(const Node& device, const EsiVendor& vendor, FileWarnings& warnings);

[[nodiscard]] Pdo read_pdo(const Node& pdo);                                             // RxPdo, TxPdo
[[nodiscard]] StartupCommand read_init_cmd(const Node& init_cmd);                        // CoE/InitCmd
[[nodiscard]] MailboxDescription read_mailbox(const Node& device, const Node& mailbox);  // with Info/Mailbox/Timeout
[[nodiscard]] DcDescription read_dc(const Node& dc);
/// Objects of Profile/Dictionary with their data types resolved; an object that cannot be read is left out with a
/// warning, because a device works without its dictionary.
[[nodiscard]] std::vector<ObjectDescription> read_dictionary(const Node& profile, FileWarnings& warnings);

}  // namespace syncline::eni
