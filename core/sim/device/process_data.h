// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/esc/esc.h"
#include "sim/objects/object_dictionary.h"
#include "sim/objects/pdo_objects.h"

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::sim {

/// Process data of a device: PDOs, the SyncManagers that hold them, and the copies between those and the object
/// dictionary. A direction may have several SyncManagers, each with an assignment of its own.
class ProcessData {
 public:
  /// All must outlive it. `max_objects`: the most that a SyncManager may map.
  ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects);

  /// Takes the PDO assignment and mapping as they are now; they do not change from SAFEOP on.
  void map();
  void clear_outputs();
  void inputs_from_dictionary();
  /// As firmware does in each cycle: the buffers are written again, also where the inputs are what they were, because
  /// the status of their SyncManagers shows it.
  void renew_inputs();
  /// The dictionary's inputs are in the SyncManagers, and outputs do not change them.
  [[nodiscard]] bool inputs_stay() const { return inputs_stay_ && generation_ == esc_.generation(); }
  /// The dictionary's outputs are those that the SyncManagers hold.
  [[nodiscard]] bool outputs_stay() const;
  /// Somebody else has been at the dictionary.
  void forget_objects();
  /// Another number whenever the objects that outputs are mapped to may have changed.
  [[nodiscard]] std::uint32_t outputs_taken() const { return outputs_taken_; }
  /// An entry of the object is mapped into the inputs.
  [[nodiscard]] bool inputs_map(std::uint16_t index);
  /// Bit per SyncManager: those of buffered process data.
  [[nodiscard]] std::uint32_t buffered_managers() const;
  /// Of these, those of inputs.
  [[nodiscard]] std::uint32_t buffered_inputs() const { return buffered_inputs_; }
  /// The same of those that renew_inputs() writes.
  [[nodiscard]] std::uint32_t input_managers() const { return inputs_; }
  /// The master has written outputs: into the dictionary with them, when they are `valid`. Process data in one buffer
  /// (SyncManager in mailbox mode) make room for the next. True: the first SyncManager of the outputs has them.
  bool take_outputs(unsigned manager, bool valid);
  /// The master has read inputs: in one buffer there are new ones at once.
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
  [[nodiscard]] bool carries(PdoDirection direction, unsigned manager) const {
    const auto* channel = find(manager);
    return channel != nullptr && channel->direction == direction;
  }
  /// It is the first of its direction.
  [[nodiscard]] bool leads(unsigned manager) const {
    const auto* channel = find(manager);
    return channel != nullptr && channel->first;
  }

 private:
  struct Copy {
    ObjectDictionary::Entry* entry;
    std::uint32_t bit_offset;
    std::uint8_t bits;
    std::uint8_t bytes;  // when they are whole ones at the beginning of one; else 0
  };
  /// One SyncManager and what it holds.
  struct Channel {
    unsigned manager = 0;
    PdoDirection direction = PdoDirection::kRx;
    PdoObjects::Assignment assignment{};
    std::vector<Copy> copies{};
    std::vector<std::uint8_t> input_buffer{};
    std::vector<std::uint8_t> taken{};  // outputs that are in the dictionary
    bool outputs_stay = false;          // nobody else has been there since
    bool one_buffer = false;
    bool first = false;         // of its direction
    std::uint32_t end_bit = 0;  // behind all copies
  };
  static constexpr std::size_t kManagers = 16;
  static constexpr std::uint8_t kNone = 0xFF;
  [[nodiscard]] const Channel* find(unsigned manager) const {
    return manager < kManagers && places_[manager] != kNone ? &channels_[places_[manager]] : nullptr;
  }
  void outputs_to_dictionary(Channel& channel);
  void forget_outputs();
  [[nodiscard]] bool shares_objects() const;
  [[nodiscard]] std::vector<Copy> copies(const PdoObjects::Assignment& assignment);

  ObjectDictionary& dictionary_;
  Esc& esc_;
  PdoObjects pdos_;
  std::vector<Channel> channels_;
  std::array<std::uint8_t, kManagers> places_{};  // in channels_, by SyncManager
  std::vector<unsigned> numbers_[2];
  bool shared_ = false;  // an output is an input, too
  bool inputs_stay_ = false;
  std::uint32_t inputs_ = 0, buffered_inputs_ = 0;  // bit per SyncManager
  std::uint32_t outputs_taken_ = 0;
  std::uint32_t generation_ = 0;  // of the ESC's settings then
};

}  // namespace syncline::sim
