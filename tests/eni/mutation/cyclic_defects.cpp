// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/mutation/defects.h"
#include "protocol/registers.h"

namespace syncline::test {
namespace {

struct FoundCyclic {
  std::vector<CyclicCmd>* commands = nullptr;
  std::size_t index = 0;
  explicit operator bool() const { return commands != nullptr; }
  [[nodiscard]] CyclicCmd* operator->() const { return &(*commands)[index]; }
};

template <class Wanted>
FoundCyclic pick_cyclic(NetworkConfig& config, Random& random, Wanted wanted) {
  std::vector<FoundCyclic> found;
  for (auto& task : config.cyclic) {
    for (auto& frame : task.frames) {
      for (std::size_t i = 0; i < frame.commands.size(); ++i) {
        if (wanted(frame.commands[i])) found.push_back({&frame.commands, i});
      }
    }
  }
  return found.empty() ? FoundCyclic{} : found[pick(random, found.size())];
}

bool is_data(const CyclicCmd& cmd) { return is_logical(cmd.command) && cmd.expected_wkc.value_or(0) > 0; }
bool is_time(const CyclicCmd& cmd) {
  return cmd.ado == reg::kSystemTime && (cmd.command == Command::kArmw || cmd.command == Command::kFrmw);
}

bool lose_command(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, [](const CyclicCmd& cmd) { return is_data(cmd) || is_time(cmd); });
  if (found) found.commands->erase(found.commands->begin() + static_cast<std::ptrdiff_t>(found.index));
  return static_cast<bool>(found);
}

/// Masters that read the states by other means do without.
bool lose_al_status(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(
      config, random, [](const CyclicCmd& cmd) { return cmd.ado == reg::kAlStatus && !is_logical(cmd.command); });
  if (found) found.commands->erase(found.commands->begin() + static_cast<std::ptrdiff_t>(found.index));
  return static_cast<bool>(found);
}

bool move_address(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, is_data);
  if (found) found->logical_address += 1 + static_cast<std::uint32_t>(pick(random, 64));
  return static_cast<bool>(found);
}

bool shorten(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, [](const CyclicCmd& cmd) { return is_data(cmd) && cmd.length() > 1; });
  if (found)
    found->data_length = static_cast<std::uint16_t>(found->length() - 1 - pick(random, (found->length() + 1U) / 2));
  if (found) found->data.clear();
  return static_cast<bool>(found);
}

bool change_cyclic_count(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, [](const CyclicCmd& cmd) { return cmd.expected_wkc.value_or(0) > 0; });
  if (!found) return false;
  found->expected_wkc = static_cast<std::uint16_t>(
      is_logical(found->command) ? *found->expected_wkc + 1 + pick(random, 3) : *found->expected_wkc + 1);
  return true;
}

bool lose_count(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, is_data);
  if (found) found->expected_wkc.reset();
  return static_cast<bool>(found);
}

bool move_data(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, is_data);
  if (!found) return false;
  const bool inputs = found->command == Command::kLrd || (found->command == Command::kLrw && random.next() % 2 == 0);
  (inputs ? found->input_offset : found->output_offset) += 1 + static_cast<std::uint32_t>(pick(random, 40));
  return true;
}

bool lose_state(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, [](const CyclicCmd& cmd) {
    return is_data(cmd) && std::ranges::find(cmd.states, AlState::kOp) != cmd.states.end();
  });
  if (found) std::erase(found->states, AlState::kOp);
  return static_cast<bool>(found);
}

bool change_cycle(NetworkConfig& config, Random& random) {
  CyclicTask* task = pick_if(config.cyclic, random, [](const CyclicTask& t) { return t.cycle_time_given; });
  const bool clocks =
      std::ranges::any_of(config.slaves, [](const SlaveConfig& s) { return s.dc && s.dc->cycle_time0 > 0; });
  if (task == nullptr || !clocks) return false;
  task->cycle_time = task->cycle_time * 3 / 4;
  return true;
}

bool take_other_clock(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, is_time);
  if (!found || config.slaves.size() < 2) return false;
  if (found->command == Command::kArmw) {
    found->adp = static_cast<std::uint16_t>(found->adp - 1);
  } else {
    ++found->adp;
  }
  return true;
}

bool shorten_time(NetworkConfig& config, Random& random) {
  const auto found = pick_cyclic(config, random, is_time);
  if (found) found->data_length = static_cast<std::uint16_t>(1 + pick(random, 3));
  if (found) found->data.clear();
  return static_cast<bool>(found);
}

bool steer_before_reading(NetworkConfig& config, Random& random) {
  const auto time = pick_cyclic(config, random, is_time);
  const auto steering = pick_cyclic(config, random, [](const CyclicCmd& cmd) {
    return cmd.ado == reg::kSystemTime && cmd.command == Command::kApwr;
  });
  if (!time || !steering || time.commands != steering.commands || steering.index < time.index) return false;
  std::swap((*time.commands)[time.index], (*time.commands)[steering.index]);
  return true;
}

SlaveConfig* clock(NetworkConfig& config, Random& random) {
  return pick_if(config.slaves, random, [](const SlaveConfig& slave) {
    return slave.dc && slave.dc->cycle_time0 > 0 && !slave.init_cmds.empty();
  });
}

bool change_sync0(NetworkConfig& config, Random& random) {
  SlaveConfig* slave = clock(config, random);
  if (slave != nullptr) slave->dc->cycle_time0 += static_cast<std::int64_t>(1000 * (1 + pick(random, 500)));
  return slave != nullptr;
}

bool change_sync0_write(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd& cmd) {
    return writes_to(cmd, Transition::kPS, reg::kSync0CycleTime, 4) && cmd.data.size() >= 4;
  });
  if (found) found->data[1] ^= static_cast<std::uint8_t>(1 + pick(random, 255));
  return static_cast<bool>(found);
}

bool lose_sync0_write(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd& cmd) {
    return writes_to(cmd, Transition::kPS, reg::kSync0CycleTime, 4) ||
           writes_to(cmd, Transition::kPS, reg::kCyclicUnitControl, 2);
  });
  if (found) found.slave->init_cmds.erase(found.slave->init_cmds.begin() + static_cast<std::ptrdiff_t>(found.index));
  return static_cast<bool>(found);
}

bool lose_reference(NetworkConfig& config, Random&) {
  const auto reference = config.reference_clock();
  if (reference) config.slaves[*reference].dc->reference_clock = false;
  return reference.has_value();
}

/// Variables of slaves: what else a tool writes is its own diagnosis.
std::vector<Variable*> variables(NetworkConfig& config, Random& random) {
  const bool inputs = random.next() % 2 == 0;
  std::vector<Variable*> out;
  for (Variable& variable : inputs ? config.image.inputs : config.image.outputs) {
    const bool is_data = std::ranges::any_of(config.slaves, [&](const SlaveConfig& slave) {
      const auto& range = inputs ? slave.receive : slave.send;
      return range && variable.bit_offset >= range->bit_start &&
             variable.bit_offset - range->bit_start < range->bit_length;
    });
    if (is_data && variable.bit_size > 0) out.push_back(&variable);
  }
  return out;
}

bool move_variable(NetworkConfig& config, Random& random) {
  const auto all = variables(config, random);
  if (all.size() < 2) return false;
  const std::size_t i = pick(random, all.size());
  const std::size_t other = (i + 1) % all.size();
  if (all[i]->bit_offset == all[other]->bit_offset) return false;
  all[i]->bit_offset = all[other]->bit_offset;
  return true;
}

bool change_variable_size(NetworkConfig& config, Random& random) {
  const auto all = variables(config, random);
  if (all.empty()) return false;
  all[pick(random, all.size())]->bit_size += 3;
  return true;
}

bool shrink_image(NetworkConfig& config, Random& random) {
  const bool inputs = random.next() % 2 == 0;
  std::uint32_t needed = 0;  // bytes up to the end of the last slave's data
  for (const SlaveConfig& slave : config.slaves) {
    const auto& range = inputs ? slave.receive : slave.send;
    if (range) needed = std::max(needed, (range->bit_start + range->bit_length + 7) / 8);
  }
  if (needed == 0) return false;
  (inputs ? config.image.input_bytes : config.image.output_bytes) = static_cast<std::uint32_t>(pick(random, needed));
  return true;
}

constexpr DefectKind kCyclicKinds[] = {{"a cyclic command is missing", true, lose_command},
                                       {"the cyclic read of the states is missing", false, lose_al_status},
                                       {"a cyclic command at another logical address", true, move_address},
                                       {"a cyclic command that is too short", true, shorten},
                                       {"a working counter of a cyclic command", true, change_cyclic_count},
                                       {"a cyclic command without working counter", true, lose_count},
                                       {"a cyclic command's data elsewhere in the image", true, move_data},
                                       {"a cyclic command that is not sent in OP", true, lose_state},
                                       {"another cycle than SYNC0's", true, change_cycle},
                                       {"the time of another clock", true, take_other_clock},
                                       {"a time of too few bytes", true, shorten_time},
                                       {"the clock steered before it is read", true, steer_before_reading},
                                       {"another SYNC0 cycle in the element", true, change_sync0},
                                       {"another SYNC0 cycle written", true, change_sync0_write},
                                       {"SYNC0 half set up", true, lose_sync0_write},
                                       {"no reference clock", true, lose_reference},
                                       {"a variable on another's bits", true, move_variable},
                                       {"the size of a variable", true, change_variable_size},
                                       {"an image that is too small", true, shrink_image}};

}  // namespace

std::span<const DefectKind> cyclic_defects() { return kCyclicKinds; }

}  // namespace syncline::test
