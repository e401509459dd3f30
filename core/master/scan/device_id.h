// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/result.h"

namespace syncline {

class Bus;
struct ScannedSlave;
class SlaveAddress;

/// Explicit device identification (ETG.1020): the number that switches or a display give a device, so
/// that it is found wherever it is connected. Where the SII's general category says so it is read from
/// process memory (General.flags bit 4), or requested by AL control bit 5 and read from 0x0134 (bit 3);
/// the latter only when `may_request`, and only from slaves in INIT without an error. A slave that does
/// not answer the request keeps no number. Bus errors, kCancelled.
[[nodiscard]] Status read_device_ids(Bus& bus, std::span<const SlaveAddress> addresses, bool may_request,
                                     std::vector<ScannedSlave>& slaves);

}  // namespace syncline
