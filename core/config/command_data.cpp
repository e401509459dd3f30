// SPDX-License-Identifier: Apache-2.0
#include "config/command_data.h"

#include <algorithm>
#include <cstdint>

#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "config/process_image.h"

namespace syncline {
namespace {

bool touches(const std::optional<ImageRange>& range, std::uint32_t offset, const CyclicCmd& command,
             const ProcessImage& image) {
  return range && range->touches(std::uint64_t{offset} + image.command_data_offset, command.length());
}

}  // namespace

bool writes_outputs(const CyclicCmd& command, const std::optional<ImageRange>& outputs, const ProcessImage& image) {
  const bool writes = command.command == Command::kLrw || command.command == Command::kLwr;
  return writes && touches(outputs, command.output_offset, command, image);
}

bool reads_inputs(const CyclicCmd& command, const std::optional<ImageRange>& inputs, const ProcessImage& image) {
  const bool reads = command.command == Command::kLrw || command.command == Command::kLrd;
  return reads && touches(inputs, command.input_offset, command, image);
}

std::optional<std::size_t> outputs_task(const NetworkConfig& config, std::size_t slave) {
  for (std::size_t task = 0; task < config.cyclic.size(); ++task) {
    for (const auto& frame : config.cyclic[task].frames) {
      const bool writes = std::ranges::any_of(frame.commands, [&](const CyclicCmd& command) {
        return writes_outputs(command, config.slaves[slave].send, config.image);
      });
      if (writes) return task;
    }
  }
  return std::nullopt;
}

bool is_exchanged_in_each_cycle(const NetworkConfig& config, std::size_t slave) {
  if (config.cyclic.empty()) return false;
  const auto& whose = config.slaves[slave];
  const auto in_base_task = [&](auto&& exchanges) {
    return std::ranges::any_of(config.cyclic.front().frames, [&](const CyclicFrame& frame) {
      return std::ranges::any_of(frame.commands, exchanges);
    });
  };
  const bool outputs = !whose.send || in_base_task([&](const CyclicCmd& command) {
    return writes_outputs(command, whose.send, config.image);
  });
  return outputs && (!whose.receive || in_base_task([&](const CyclicCmd& command) {
           return reads_inputs(command, whose.receive, config.image);
         }));
}

}  // namespace syncline
