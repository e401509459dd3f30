// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "config/device_description.h"
#include "sim/esc.h"
#include "sim/object_dictionary.h"
#include "sim/pdo_objects.h"

namespace syncline::sim {

/// Process data of a device: PDOs, the SyncManagers that hold them, and the copies between those and the object
/// dictionary. A direction may have several SyncManagers, each with an assignment of its own.
class ProcessData {
 public:
  /// All must outlive it. `max_objects`: the most that a SyncManager may map.
  ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects);

  /// Takes the PDO assignment and mapping as they are now; they do not change from SAFEOP on.
  void map();
  void outputs_to_dictionary(unsigned manager);
  void clear_outputs();
  void inputs_from_dictionary();
  /// Process data in one buffer (SyncManager in mailbox mode): the outputs were taken and make room, the inputs are there.
  void take_outputs(unsigned manager);
  void offer_inputs(unsigned manager);

  [[nodiscard]] std::uint32_t byte_length(PdoDirection direction) const { return pdos_.byte_length(direction); }
  [[nodiscard]] std::uint32_t byte_length_of(unsigned manager) const;
  [[nodiscard]] bool has_outputs() const;
  /// First SyncManager of the direction in the device's description; valid before map(), too.
  [[nodiscard]] std::optional<unsigned> sync_manager(PdoDirection direction) const;
  /// All of the direction.
  [[nodiscard]] const std::vector<unsigned>& sync_managers(PdoDirection direction) const {
    return numbers_[direction == PdoDirection::kRx ? 0 : 1];
  }
  [[nodiscard]] bool carries(PdoDirection direction, unsigned manager) const;

 private:
  struct Copy {
    ObjectDictionary::Entry* entry;
    std::uint32_t bit_offset;
    std::uint8_t bits;
  };
  /// One SyncManager and what it holds.
  struct Channel {
    unsigned manager = 0;
    PdoDirection direction = PdoDirection::kRx;
    PdoObjects::Assignment assignment{};
    std::vector<Copy> copies{};
    std::vector<std::uint8_t> input_buffer{};
    bool one_buffer = false;
  };
  [[nodiscard]] std::vector<Copy> copies(const PdoObjects::Assignment& assignment);

  ObjectDictionary& dictionary_;
  Esc& esc_;
  PdoObjects pdos_;
  std::vector<Channel> channels_;
  std::vector<unsigned> numbers_[2];
};

}  // namespace syncline::sim
