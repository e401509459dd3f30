// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/object_description.h"

namespace syncline {

struct DeviceDescription;

/// A PDO as the device's dictionary has it (0x1600 to 0x17FF, 0x1A00 to 0x1BFF).
struct DictionaryPdo {
  std::uint16_t index = 0;
  std::string name;
  std::vector<std::uint32_t> mapped;  // index, sub-index, bits as in the mapping object
  bool writable = false;              // the mapping can be changed
};

/// What a device without an ESI says of itself online.
struct DeviceDictionary {
  std::vector<ObjectDescription> objects;  // empty where the device does not describe them
  std::vector<DictionaryPdo> rx_pdos, tx_pdos;
  std::vector<std::uint16_t> assigned_rx, assigned_tx;  // 0x1C12, 0x1C13
};

/// Completes a description that came from the EEPROM: the objects; PDOs with their mapping in the device's order, where
/// the dictionary has any, instead of the EEPROM's; their SyncManagers by the assignment. Pure.
void complete_from_dictionary(DeviceDescription& device, const DeviceDictionary& dictionary);

}  // namespace syncline
