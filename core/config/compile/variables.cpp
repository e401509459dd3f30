// SPDX-License-Identifier: Apache-2.0
#include "config/compile/variables.h"

#include <fmt/format.h>

#include <unordered_map>

namespace syncline::compiler {
namespace {

class VariableList {
 public:
  void add(std::string name, const PdoEntry& entry, std::uint32_t bit_offset) {
    const int count = ++uses_[name];
    if (count > 1) {
      name += fmt::format(" ({})", count);
      ++uses_[name];
    }
    out_.push_back({std::move(name), entry.data_type, {}, entry.bit_length, bit_offset});
  }
  [[nodiscard]] std::vector<Variable> take() { return std::move(out_); }

 private:
  std::unordered_map<std::string, int> uses_;
  std::vector<Variable> out_;
};

void add_channel(VariableList& list, const SlavePlan& slave, const ProcessDataChannel& channel, std::uint32_t bit) {
  for (const std::uint16_t index : channel.pdos) {
    const Pdo* pdo = slave.find_pdo(index);
    if (pdo == nullptr) {
      continue;
    }
    for (const PdoEntry& entry : pdo->entries) {
      if (entry.index != 0) {
        list.add(fmt::format("{}.{}.{}", slave.settings->name, pdo->name, entry.name), entry, bit);
      }
      bit += entry.bit_length;
    }
  }
}

}  // namespace

std::vector<Variable> image_variables(const std::vector<SlavePlan>& slaves, PdoDirection direction,
                                      const std::vector<std::uint32_t>& placement_bits) {
  VariableList list;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    std::uint32_t bit = placement_bits[i];
    for (const auto& channel : slaves[i].channels) {
      if (channel.is_output() == (direction == PdoDirection::kRx)) {
        add_channel(list, slaves[i], channel, bit);
        bit += slaves[i].bit_oriented ? channel.bit_length : channel.byte_length() * 8U;
      }
    }
  }
  return list.take();
}

}  // namespace syncline::compiler
