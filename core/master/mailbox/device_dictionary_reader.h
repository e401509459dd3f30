// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/result.h"

namespace syncline {

struct DeviceDescription;
struct DeviceDictionary;
class MailboxClient;

/// Reads what a device in PREOP or above says of itself: its objects by SDO information where it has that, and by SDO
/// the mapping of its PDOs and which are assigned. Objects that it refuses are left out; a dead mailbox, a lying device
/// and the user end it.
[[nodiscard]] Result<DeviceDictionary> read_device_dictionary(MailboxClient& mailbox, const DeviceDescription& known);

}  // namespace syncline
