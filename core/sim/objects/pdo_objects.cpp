// SPDX-License-Identifier: Apache-2.0
#include "sim/objects/pdo_objects.h"

#include <algorithm>

#include "config/device_description.h"
#include "sim/objects/object_dictionary.h"
#include "sim/registers/short_copy.h"
#include "support/bits.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kAssign = 0x1C10;  // + SyncManager
constexpr std::uint16_t kAssignRx = 0x1C12, kAssignTx = 0x1C13;
constexpr unsigned kFirstDataManager = 2;   // of a device with mailbox
constexpr unsigned kMaxEntries = 32;        // of a mapping that can be changed
constexpr unsigned kMaxFixedEntries = 255;  // sub-indices are bytes

std::uint16_t usual_index(PdoDirection direction) { return direction == PdoDirection::kRx ? kAssignRx : kAssignTx; }

/// SyncManagers of a direction; those that are registers (virtual) only where there are no others.
std::vector<unsigned> managers_of(const DeviceDescription& device, PdoDirection direction) {
  const auto type = direction == PdoDirection::kRx ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
  std::vector<unsigned> real, all;
  for (unsigned i = 0; i < device.sync_managers.size(); ++i) {
    if (device.sync_managers[i].type != type) continue;
    all.push_back(i);
    if (!device.sync_managers[i].is_virtual) real.push_back(i);
  }
  return real.empty() ? all : real;
}

}  // namespace

void copy_bits(std::span<std::uint8_t> to, std::size_t to_bit, std::span<const std::uint8_t> from, std::size_t from_bit,
               std::size_t bits) {
  if (to_bit % 8 == 0 && from_bit % 8 == 0 && bits % 8 == 0) {
    short_copy(from.subspan(from_bit / 8, bits / 8), to.subspan(to_bit / 8));
    return;
  }
  syncline::copy_bits(to, to_bit, from, from_bit, bits);
}

PdoObjects::PdoObjects(const DeviceDescription& device, ObjectDictionary& dictionary, unsigned max_objects)
    : dictionary_(dictionary), max_objects_(max_objects) {
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const auto& pdo : device.pdos(direction)) add_mapping(pdo, direction);
  }
  choose_assignments(device);
  for (const Assignment& assignment : assignments_) add_assignment(device, assignment);
}

bool PdoObjects::is_taken(std::uint16_t index) const {
  return std::ranges::find(assignments_, index, &Assignment::index) != assignments_.end();
}

void PdoObjects::choose_assignments(const DeviceDescription& device) {
  constexpr PdoDirection kDirections[] = {PdoDirection::kRx, PdoDirection::kTx};
  for (const auto direction : kDirections) {
    for (const unsigned manager : managers_of(device, direction)) {
      // Terminals without mailbox have their data in SM0 and SM1; nobody can ask them for these objects.
      const auto usual = usual_index(direction);
      const auto own = static_cast<std::uint16_t>(kAssign + manager);
      const auto index = manager >= kFirstDataManager || is_taken(usual) ? own : usual;
      if (!is_taken(index)) assignments_.push_back({direction, manager, index});
    }
  }
  for (const auto direction : kDirections) {
    const bool none = std::ranges::find(assignments_, direction, &Assignment::direction) == assignments_.end();
    if (none && !is_taken(usual_index(direction)))
      assignments_.push_back({direction, std::nullopt, usual_index(direction)});
  }
}

const PdoObjects::Assignment* PdoObjects::home_of(const Pdo& pdo, PdoDirection direction) const {
  const Assignment* first = nullptr;
  for (const Assignment& assignment : assignments_) {
    if (assignment.direction != direction) continue;
    if (pdo.sync_manager && assignment.manager == *pdo.sync_manager) return &assignment;
    if (first == nullptr) first = &assignment;
  }
  return first;
}

void PdoObjects::add_mapping(const Pdo& pdo, PdoDirection direction) {
  const std::string usual = direction == PdoDirection::kRx ? "RxPDO mapping" : "TxPDO mapping";
  dictionary_.suggest_object_name(pdo.index, pdo.name.empty() ? usual : pdo.name);
  const bool changeable = !pdo.fixed;
  const auto most = changeable ? kMaxEntries : kMaxFixedEntries;
  const auto count = static_cast<std::uint8_t>(std::min<std::size_t>(pdo.entries.size(), most));
  auto& head = dictionary_.add(pdo.index, 0, "Number of mapped objects", count, changeable);
  head.preop_only = true;
  for (unsigned sub = 1; sub <= (changeable ? kMaxEntries : count); ++sub) {
    const auto word = sub <= count ? mapping_of(pdo.entries[sub - 1]).word() : 0U;
    auto& entry = dictionary_.add(pdo.index, static_cast<std::uint8_t>(sub), "Mapped object", word, changeable);
    entry.preop_only = true;
    entry.on_write = [this, index = pdo.index](std::span<const std::uint8_t> data) {
      if (dictionary_.get<std::uint8_t>(index, 0) != 0) return abort::kSubIndexNotWritable;
      const auto mapped = PdoMapping::of(load_le<std::uint32_t>(data));
      return check_mapped(mapped.index, mapped.sub_index, mapped.bits);
    };
  }
}

std::uint32_t PdoObjects::check_mapped(std::uint16_t object, std::uint8_t sub_index, std::uint8_t bits) const {
  if (object == 0) return abort::kNone;  // padding
  const auto* entry = dictionary_.find(object, sub_index);
  if (entry == nullptr) return abort::kNotMappable;
  return entry->bits() == bits ? abort::kNone : abort::kNotMappable;
}

std::uint32_t PdoObjects::check_assigned(std::uint16_t index, unsigned count) const {
  unsigned objects = 0;
  for (unsigned sub = 1; sub <= count; ++sub) {
    const auto pdo = dictionary_.get<std::uint16_t>(index, static_cast<std::uint8_t>(sub));
    objects += dictionary_.get<std::uint8_t>(pdo, 0);
  }
  return objects > max_objects_ ? abort::kPdoTooLong : abort::kNone;
}

void PdoObjects::add_assignment(const DeviceDescription& device, const Assignment& assignment) {
  const auto index = assignment.index;
  const auto direction = assignment.direction;
  std::vector<std::uint16_t> assigned;
  for (const auto& pdo : device.pdos(direction)) {
    if (pdo.sync_manager && home_of(pdo, direction) == &assignment) assigned.push_back(pdo.index);
  }
  const bool changeable = device.mailbox && device.mailbox->coe && device.mailbox->coe->pdo_assign;
  auto& head =
      dictionary_.add(index, 0, "Number of assigned PDOs", static_cast<std::uint8_t>(assigned.size()), changeable);
  head.preop_only = true;
  head.on_write = [this, index](std::span<const std::uint8_t> data) { return check_assigned(index, data[0]); };
  dictionary_.suggest_object_name(index, direction == PdoDirection::kRx ? "RxPDO assign" : "TxPDO assign");
  const auto slots = std::max<std::size_t>(device.pdos(direction).size(), assigned.size());
  for (std::size_t sub = 1; sub <= slots; ++sub) {
    auto& entry = dictionary_.add(index, static_cast<std::uint8_t>(sub), "Assigned PDO",
                                  sub <= assigned.size() ? assigned[sub - 1] : std::uint16_t{0}, changeable);
    entry.preop_only = true;
    entry.on_write = [this, index](std::span<const std::uint8_t> data) {
      if (dictionary_.get<std::uint8_t>(index, 0) != 0) return abort::kSubIndexNotWritable;
      return dictionary_.find(load_le<std::uint16_t>(data), 0) != nullptr ? abort::kNone : abort::kRange;
    };
  }
}

std::vector<PdoObjects::Mapped> PdoObjects::layout(const Assignment& assignment) const {
  std::vector<Mapped> objects;
  const auto index = assignment.index;
  const auto pdos = dictionary_.get<std::uint8_t>(index, 0);
  for (unsigned i = 1; i <= pdos; ++i) {
    const auto pdo = dictionary_.get<std::uint16_t>(index, static_cast<std::uint8_t>(i));
    const auto entries = dictionary_.get<std::uint8_t>(pdo, 0);
    for (unsigned k = 1; k <= entries; ++k) {
      const auto mapped = PdoMapping::of(dictionary_.get<std::uint32_t>(pdo, static_cast<std::uint8_t>(k)));
      objects.push_back({mapped.index, mapped.sub_index, mapped.bits});
    }
  }
  return objects;
}

std::uint32_t PdoObjects::byte_length(const Assignment& assignment) const {
  std::uint32_t bits = 0;
  for (const auto& object : layout(assignment)) bits += object.bits;
  return (bits + 7) / 8;
}

std::uint32_t PdoObjects::byte_length(PdoDirection direction) const {
  std::uint32_t bytes = 0;
  for (const Assignment& assignment : assignments_) {
    if (assignment.direction == direction) bytes += byte_length(assignment);
  }
  return bytes;
}

}  // namespace syncline::sim
