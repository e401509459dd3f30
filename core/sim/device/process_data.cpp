// SPDX-License-Identifier: Apache-2.0
#include "sim/device/process_data.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "config/device_description.h"
#include "sim/esc/esc.h"
#include "sim/registers/short_copy.h"

namespace syncline::sim {
namespace {

/// The usual objects, in each cycle. False: it is none of them.
bool copy_whole(const std::uint8_t* from, std::uint8_t* to, std::uint8_t bytes) {
  switch (bytes) {
    case 1:
      *to = *from;
      return true;
    case 2:
      std::memcpy(to, from, 2);
      return true;
    case 4:
      std::memcpy(to, from, 4);
      return true;
    case 8:
      std::memcpy(to, from, 8);
      return true;
    default:
      return false;
  }
}

}  // namespace

ProcessData::ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects)
    : dictionary_(dictionary), esc_(esc), pdos_(device, dictionary, max_objects) {
  places_.fill(kNone);
  for (const auto& assignment : pdos_.assignments()) {
    if (!assignment.manager) continue;
    auto& numbers = numbers_[assignment.direction == PdoDirection::kRx ? 0 : 1];
    const auto place = static_cast<std::uint8_t>(channels_.size());
    if (*assignment.manager < kManagers && places_[*assignment.manager] == kNone) places_[*assignment.manager] = place;
    channels_.push_back({.manager = *assignment.manager,
                         .direction = assignment.direction,
                         .assignment = assignment,
                         .first = numbers.empty()});
    numbers.push_back(*assignment.manager);
  }
}

std::optional<unsigned> ProcessData::sync_manager(PdoDirection direction) const {
  const auto& numbers = sync_managers(direction);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
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
    if (entry != nullptr && 8 * entry->value.size() >= object.bits) {
      const bool whole = offset % 8 == 0 && object.bits % 8 == 0;
      list.push_back({entry, offset, object.bits, static_cast<std::uint8_t>(whole ? object.bits / 8 : 0)});
    }
    offset += object.bits;
  }
  return list;
}

bool ProcessData::shares_objects() const {
  const auto outputs = [](const Channel& channel) { return channel.direction == PdoDirection::kRx; };
  const auto is_output = [&](const Copy& input) {
    return std::ranges::any_of(channels_, [&](const Channel& channel) {
      return outputs(channel) && std::ranges::find(channel.copies, input.entry, &Copy::entry) != channel.copies.end();
    });
  };
  return std::ranges::any_of(channels_,
                             [&](const Channel& c) { return !outputs(c) && std::ranges::any_of(c.copies, is_output); });
}

void ProcessData::map() {
  for (Channel& channel : channels_) {
    channel.copies = copies(channel.assignment);
    channel.input_buffer.clear();
    channel.end_bit = 0;
    for (const auto& copy : channel.copies) channel.end_bit = std::max(channel.end_bit, copy.bit_offset + copy.bits);
    const auto manager = esc_.sync_manager(channel.manager);
    channel.one_buffer = manager.enabled() && manager.is_mailbox();
    if (channel.direction == PdoDirection::kTx) offer_inputs(channel.manager);
  }
  inputs_ = 0;
  buffered_inputs_ = buffered_managers();
  for (const unsigned number : sync_managers(PdoDirection::kRx)) buffered_inputs_ &= ~(1U << number % kManagers);
  for (const unsigned number : sync_managers(PdoDirection::kTx)) {
    if (number < kManagers && esc_.has_sync_manager(number)) inputs_ |= 1U << number;
  }
  shared_ = shares_objects();
  forget_objects();
}

bool ProcessData::inputs_map(std::uint16_t index) {
  return std::ranges::any_of(channels_, [&](const Channel& channel) {
    if (channel.direction == PdoDirection::kRx) return false;
    const auto objects = pdos_.layout(channel.assignment);
    return std::ranges::any_of(objects, [index](const auto& object) { return object.index == index; });
  });
}

std::uint32_t ProcessData::buffered_managers() const {
  std::uint32_t managers = 0;
  for (const auto& channel : channels_) {
    if (channel.manager < kManagers && !channel.one_buffer) managers |= 1U << channel.manager;
  }
  return managers;
}

bool ProcessData::take_outputs(unsigned manager, bool valid) {
  if (!carries(PdoDirection::kRx, manager)) return false;
  auto& channel = channels_[places_[manager]];
  if (valid) outputs_to_dictionary(channel);
  if (channel.one_buffer) esc_.set_mailbox_full(manager, false);
  return channel.first;
}

void ProcessData::offer_inputs(unsigned manager) {
  const auto* channel = find(manager);
  if (channel != nullptr && channel->one_buffer) esc_.set_mailbox_full(manager, true);
}

void ProcessData::outputs_to_dictionary(Channel& channel) {
  const auto bytes = std::as_const(esc_).sync_manager_area(channel.manager);
  if (channel.outputs_stay && short_equal(bytes, channel.taken)) return;
  channel.taken.assign(bytes.begin(), bytes.end());
  channel.outputs_stay = true;
  ++outputs_taken_;
  const bool all = channel.end_bit <= 8U * bytes.size();
  for (const auto& copy : channel.copies) {
    if (!all && copy.bit_offset + copy.bits > 8U * bytes.size()) continue;
    const auto* from = bytes.data() + copy.bit_offset / 8;
    if (!copy_whole(from, copy.entry->value.data(), copy.bytes))
      copy_bits(copy.entry->value, 0, bytes, copy.bit_offset, copy.bits);
  }
}

bool ProcessData::outputs_stay() const {
  return std::ranges::all_of(channels_, [this](const Channel& channel) {
    return channel.direction == PdoDirection::kTx ||
           (channel.outputs_stay && short_equal(std::as_const(esc_).sync_manager_area(channel.manager), channel.taken));
  });
}

void ProcessData::forget_objects() {
  inputs_stay_ = false;
  forget_outputs();
}

void ProcessData::forget_outputs() {
  ++outputs_taken_;
  for (Channel& channel : channels_) channel.outputs_stay = false;
}

void ProcessData::clear_outputs() {
  forget_outputs();
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
    const bool all = channel.end_bit <= 8U * length;
    for (const auto& copy : channel.copies) {
      if (!all && copy.bit_offset + copy.bits > 8U * length) continue;
      auto* to = buffer.data() + copy.bit_offset / 8;
      if (!copy_whole(copy.entry->value.data(), to, copy.bytes))
        copy_bits(buffer, copy.bit_offset, copy.entry->value, 0, copy.bits);
    }
    esc_.put_buffer(channel.manager, buffer);
  }
  inputs_stay_ = !shared_;
  generation_ = esc_.generation();
}

void ProcessData::renew_inputs() {
  if (!inputs_stay()) return inputs_from_dictionary();
  esc_.put_same_buffers(inputs_);
}

}  // namespace syncline::sim
