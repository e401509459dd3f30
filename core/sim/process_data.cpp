// SPDX-License-Identifier: Apache-2.0
#include "sim/process_data.h"

#include <algorithm>
#include <utility>

namespace syncline::sim {

ProcessData::ProcessData(const DeviceDescription& device, ObjectDictionary& dictionary, Esc& esc, unsigned max_objects)
    : dictionary_(dictionary), esc_(esc), pdos_(device, dictionary, max_objects) {
  const auto first = [&device](SyncManagerType type) -> std::optional<unsigned> {
    for (unsigned i = 0; i < device.sync_managers.size(); ++i) {
      if (device.sync_managers[i].type == type) return i;
    }
    return std::nullopt;
  };
  output_sm_ = first(SyncManagerType::kOutputs);
  input_sm_ = first(SyncManagerType::kInputs);
}

std::vector<ProcessData::Copy> ProcessData::copies(PdoDirection direction) {
  std::vector<Copy> list;
  std::uint32_t offset = 0;
  for (const auto& object : pdos_.layout(direction)) {
    auto* entry = object.index == 0 ? nullptr : dictionary_.find(object.index, object.sub_index);
    if (entry != nullptr && 8 * entry->value.size() >= object.bits) list.push_back({entry, offset, object.bits});
    offset += object.bits;
  }
  return list;
}

void ProcessData::map() {
  outputs_ = copies(PdoDirection::kRx);
  inputs_ = copies(PdoDirection::kTx);
  input_buffer_.clear();
  const auto one_buffer = [this](const std::optional<unsigned>& number) {
    return number && esc_.sync_manager(*number).enabled() && esc_.sync_manager(*number).is_mailbox();
  };
  one_output_buffer_ = one_buffer(output_sm_);
  one_input_buffer_ = one_buffer(input_sm_);
  offer_inputs();
}

void ProcessData::take_outputs() {
  if (one_output_buffer_) esc_.set_mailbox_full(*output_sm_, false);
}

void ProcessData::offer_inputs() {
  if (one_input_buffer_) esc_.set_mailbox_full(*input_sm_, true);
}

void ProcessData::outputs_to_dictionary() {
  if (!output_sm_) return;
  const auto bytes = std::as_const(esc_).sync_manager_area(*output_sm_);
  for (const auto& copy : outputs_) {
    if (copy.bit_offset + copy.bits > 8U * bytes.size()) continue;
    copy_bits(copy.entry->value, 0, bytes, copy.bit_offset, copy.bits);
  }
}

void ProcessData::clear_outputs() {
  for (const auto& copy : outputs_) std::ranges::fill(copy.entry->value, std::uint8_t{0});
}

void ProcessData::inputs_from_dictionary() {
  if (!input_sm_) return;
  const auto length = std::as_const(esc_).sync_manager_area(*input_sm_).size();
  if (input_buffer_.size() != length) input_buffer_.assign(length, 0);  // bits that nothing is mapped to stay zero
  for (const auto& copy : inputs_) {
    if (copy.bit_offset + copy.bits > 8U * input_buffer_.size()) continue;
    copy_bits(input_buffer_, copy.bit_offset, copy.entry->value, 0, copy.bits);
  }
  esc_.put_buffer(*input_sm_, input_buffer_);
}

}  // namespace syncline::sim
