// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/pdo_description.h"

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::sim {

class ObjectDictionary;

/// PDO mapping (0x1600.., 0x1A00..) and assignment (0x1C10 + SyncManager) in an object dictionary, and what follows
/// from them: the process data's layout. Both can be changed by SDO in PREOP (ETG.1000.6, 5.6.7).
class PdoObjects {
 public:
  /// `max_objects` a direction; the assignment refuses more.
  PdoObjects(const DeviceDescription& device, ObjectDictionary& dictionary, unsigned max_objects);

  struct Mapped {
    std::uint16_t index = 0;  // 0 = padding
    std::uint8_t sub_index = 0;
    std::uint8_t bits = 0;
  };
  /// Assignment of one SyncManager; a direction may have several (safety modules have one of their own).
  struct Assignment {
    PdoDirection direction = PdoDirection::kRx;
    std::optional<unsigned> manager{};  // none: the description has no SyncManager for the direction
    std::uint16_t index = 0;            // object, 0x1C12 ...
  };
  [[nodiscard]] const std::vector<Assignment>& assignments() const { return assignments_; }

  /// Objects of the assigned PDOs in order.
  [[nodiscard]] std::vector<Mapped> layout(const Assignment& assignment) const;
  [[nodiscard]] std::uint32_t byte_length(const Assignment& assignment) const;
  /// Of all SyncManagers of the direction.
  [[nodiscard]] std::uint32_t byte_length(PdoDirection direction) const;

 private:
  void add_mapping(const Pdo& pdo, PdoDirection direction);
  void choose_assignments(const DeviceDescription& device);
  [[nodiscard]] bool is_taken(std::uint16_t index) const;
  /// The assignment to whose SyncManager the description gives the PDO; else the first of the direction.
  [[nodiscard]] const Assignment* home_of(const Pdo& pdo, PdoDirection direction) const;
  void add_assignment(const DeviceDescription& device, const Assignment& assignment);
  /// A PDO maps whole objects: `bits` as many as the object has.
  [[nodiscard]] std::uint32_t check_mapped(std::uint16_t object, std::uint8_t sub_index, std::uint8_t bits) const;
  [[nodiscard]] std::uint32_t check_assigned(std::uint16_t index, unsigned count) const;

  ObjectDictionary& dictionary_;
  unsigned max_objects_;
  std::vector<Assignment> assignments_;
};

/// As syncline::copy_bits(), quicker where whole bytes are meant.
void copy_bits(std::span<std::uint8_t> to, std::size_t to_bit, std::span<const std::uint8_t> from, std::size_t from_bit,
               std::size_t bits);

}  // namespace syncline::sim
