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
/// dictionary.
class ProcessData {
 public:
  /// All must outlive it. `max_objects`: the most that a direction may map.
  ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects);

  /// Takes the PDO assignment and mapping as they are now; they do not change from SAFEOP on.
  void map();
  void outputs_to_dictionary();
  void clear_outputs();
  void inputs_from_dictionary();
  /// Process data in one buffer (SyncManager in mailbox mode): the outputs were taken and make room, the inputs are there.
  void take_outputs();
  void offer_inputs();

  [[nodiscard]] std::uint32_t byte_length(PdoDirection direction) const { return pdos_.byte_length(direction); }
  [[nodiscard]] bool has_outputs() const { return !outputs_.empty(); }
  /// SyncManager of the device's description; valid before map(), too.
  [[nodiscard]] std::optional<unsigned> sync_manager(PdoDirection direction) const {
    return direction == PdoDirection::kRx ? output_sm_ : input_sm_;
  }

 private:
  struct Copy {
    ObjectDictionary::Entry* entry;
    std::uint32_t bit_offset;
    std::uint8_t bits;
  };
  [[nodiscard]] std::vector<Copy> copies(PdoDirection direction);

  ObjectDictionary& dictionary_;
  Esc& esc_;
  PdoObjects pdos_;
  std::vector<Copy> outputs_, inputs_;
  std::vector<std::uint8_t> input_buffer_;
  std::optional<unsigned> output_sm_, input_sm_;
  bool one_output_buffer_ = false, one_input_buffer_ = false;
};

}  // namespace syncline::sim
