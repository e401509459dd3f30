// SPDX-License-Identifier: Apache-2.0
#include "compile/variables.h"

#include <fmt/format.h>

#include <unordered_map>

#include "compile/effective_slave.h"
#include "compile/slave_plan.h"
#include "config/slave_settings.h"

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

/// The user's name for entry `number` of a PDO, nullptr when there is none.
const std::string* own_name(const SlaveSettings& slave, std::uint16_t pdo, std::size_t number) {
  for (const VariableName& name : slave.variable_names) {
    if (name.pdo == pdo && name.entry == number) return &name.name;
  }
  return nullptr;
}

std::string variable_name(const SlaveSettings& slave, const Pdo& pdo, std::size_t number, std::size_t samples) {
  const std::size_t mapped = pdo.entries.size() / samples;
  const std::string* own = slave.variable_names.empty() ? nullptr : own_name(slave, pdo.index, number % mapped);
  if (own == nullptr) return fmt::format("{}.{}.{}", slave.name, pdo.name, pdo.entries[number].name);
  return samples == 1 ? *own : fmt::format("{}[{}]", *own, number / mapped);
}

void add_channel(VariableList& list, const SlavePlan& slave, const ProcessDataChannel& channel, std::uint32_t bit) {
  for (const std::uint16_t index : channel.pdos) {
    const Pdo* pdo = slave.find_pdo(index);
    if (pdo == nullptr) {
      continue;
    }
    const std::size_t samples = oversampling_factor(*slave.settings, index);
    for (std::size_t i = 0; i < pdo->entries.size(); ++i) {
      const PdoEntry& entry = pdo->entries[i];
      if (entry.index != 0) {
        list.add(variable_name(*slave.settings, *pdo, i, samples), entry, bit);
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
