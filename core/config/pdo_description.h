// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/pdo_mapping.h"

/// Process data objects as ESI and SII describe them.
namespace syncline {

enum class PdoDirection : std::uint8_t { kRx, kTx };  // Rx = outputs (master to slave), Tx = inputs

struct PdoEntry {
  std::uint16_t index = 0;  // 0 = padding
  std::uint8_t sub_index = 0;
  std::uint16_t bit_length = 0;
  std::string name;
  std::string data_type;        // ESI name: "UINT", "DINT", "BOOL" ...
  bool fixed = false;           // Entry@Fixed: stays when the mapping is changed
  bool depend_on_slot = false;  // in modules: SlotIndexIncrement is added to `index` for each slot
  bool depend_on_slot_group = false;
  std::string comment{};
  std::string scale{};    // DataType@DScale: range of an analog value, "+/-10", "0-10", "4-20" ...
  std::uint8_t swap = 0;  // DataType@SwapData: 1 swaps the bytes of words, 2 the words, 3 both
  bool operator==(const PdoEntry&) const = default;
};

/// As it stands in the PDO's object; of more than 255 bits only the low byte.
[[nodiscard]] constexpr PdoMapping mapping_of(const PdoEntry& entry) {
  return {entry.index, entry.sub_index, static_cast<std::uint8_t>(entry.bit_length)};
}

struct Pdo {
  std::uint16_t index = 0;
  std::string name;
  std::optional<std::uint8_t> sync_manager;  // default assignment by the ESI
  bool fixed = false;                        // mapping cannot be changed
  bool mandatory = false;
  std::vector<std::uint16_t> exclude;
  std::vector<PdoEntry> entries;
  std::optional<std::uint8_t> sync_unit{};  // Su: number of the device's Sync Unit
  bool is_virtual = false;                  // for the configurator only: not assigned to the hardware's SyncManager
  /// Oversampling: copies of the entries in one cycle, each `os_index_increment` further in the object dictionary.
  std::optional<std::uint16_t> os_factor{}, os_min{}, os_max{}, os_index_increment{};
  std::optional<int> order{};  // PdoOrder: place in the process data, ascending
  std::vector<std::uint8_t> excluded_sync_managers{};
  bool depend_on_slot = false;  // in modules: SlotPdoIncrement is added to `index` for each slot
  bool depend_on_slot_group = false;
  std::vector<std::uint16_t> exclude_by_slot{};  // of `exclude`: those that move with the slot
  bool overwritten_by_module = false;            // a modular configurator leaves it out, a module brings it
  bool operator==(const Pdo&) const = default;
  [[nodiscard]] std::uint32_t bit_length() const;
};

/// Null: there is none of that index.
[[nodiscard]] const Pdo* find_pdo(const std::vector<Pdo>& pdos, std::uint16_t index);

}  // namespace syncline
