// SPDX-License-Identifier: Apache-2.0
#include "sim/process_data.h"

#include <algorithm>
#include <utility>

namespace syncline::sim {

ProcessData::ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects)
    : dictionary_(dictionary), esc_(esc), pdos_(device, dictionary, max_objects) {
  for (const auto& assignment : pdos_.assignments()) {
    if (!assignment.manager) continue;
    channels_.push_back({.manager = *assignment.manager, .direction = assignment.direction, .assignment = assignment});
    numbers_[assignment.direction == PdoDirection::kRx ? 0 : 1].push_back(*assignment.manager);
  }
}

std::optional<unsigned> ProcessData::sync_manager(PdoDirection direction) const {
  const auto& numbers = sync_managers(direction);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

bool ProcessData::carries(PdoDirection direction, unsigned manager) const {
  return std::ranges::find(sync_managers(direction), manager) != sync_managers(direction).end();
}

std::uint32_t ProcessData::byte_length_of(unsigned manager) const {
  const auto channel = std::ranges::find(channels_, manager, &Channel::manager);
  return channel == channels_.end() ? 0 : pdos_.byte_length(channel->assignment);
}

bool ProcessData::has_outputs() const {
  return std::ranges::any_of(channels_, [](const Channel& channel) {
    return channel.direction == PdoDirection::kRx && !channel.copies.empty();
  });
}

std::vector<ProcessData::Copy> ProcessData::copies(const PdoObjects::Assignment& assignment) {
  std::vector<Copy> list;
  std::uint32_t offset = 0;
  for (const auto& object : pdos_.layout(assignment)) {
    auto* entry = object.index == 0 ? nullptr : dictionary_.find(object.index, object.sub_index);
    if (entry != nullptr && 8 * entry->value.size() >= object.bits) list.push_back({entry, offset, object.bits});
    offset += object.bits;
  }
  return list;
}

void ProcessData::map() {
  for (Channel& channel : channels_) {
    channel.copies = copies(channel.assignment);
    channel.input_buffer.clear();
    const auto manager = esc_.sync_manager(channel.manager);
    channel.one_buffer = manager.enabled() && manager.is_mailbox();
    if (channel.direction == PdoDirection::kTx) offer_inputs(channel.manager);
  }
}

void ProcessData::take_outputs(unsigned manager) {
  const auto channel = std::ranges::find(channels_, manager, &Channel::manager);
  if (channel != channels_.end() && channel->one_buffer) esc_.set_mailbox_full(manager, false);
}

void ProcessData::offer_inputs(unsigned manager) {
  const auto channel = std::ranges::find(channels_, manager, &Channel::manager);
  if (channel != channels_.end() && channel->one_buffer) esc_.set_mailbox_full(manager, true);
}

void ProcessData::outputs_to_dictionary(unsigned manager) {
  const auto channel = std::ranges::find(channels_, manager, &Channel::manager);
  if (channel == channels_.end()) return;
  const auto bytes = std::as_const(esc_).sync_manager_area(manager);
  for (const auto& copy : channel->copies) {
    if (copy.bit_offset + copy.bits > 8U * bytes.size()) continue;
    copy_bits(copy.entry->value, 0, bytes, copy.bit_offset, copy.bits);
  }
}

void ProcessData::clear_outputs() {
  for (const Channel& channel : channels_) {
    if (channel.direction == PdoDirection::kTx) continue;
    for (const auto& copy : channel.copies) std::ranges::fill(copy.entry->value, std::uint8_t{0});
  }
}

void ProcessData::inputs_from_dictionary() {
  for (Channel& channel : channels_) {
    if (channel.direction == PdoDirection::kRx) continue;
    auto& buffer = channel.input_buffer;
    const auto length = std::as_const(esc_).sync_manager_area(channel.manager).size();
    if (buffer.size() != length) buffer.assign(length, 0);  // bits that nothing is mapped to stay zero
    for (const auto& copy : channel.copies) {
      if (copy.bit_offset + copy.bits > 8U * buffer.size()) continue;
      copy_bits(buffer, copy.bit_offset, copy.entry->value, 0, copy.bits);
    }
    esc_.put_buffer(channel.manager, buffer);
  }
}

}  // namespace syncline::sim
