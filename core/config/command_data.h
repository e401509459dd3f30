// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace syncline {

struct CyclicCmd;
struct ImageRange;
struct NetworkConfig;
struct ProcessImage;

/// Whether some of these outputs go with the command; `image`: the process image in which both stand.
[[nodiscard]] bool writes_outputs(const CyclicCmd& command, const std::optional<ImageRange>& outputs,
                                  const ProcessImage& image);
/// Whether some of these inputs come with it.
[[nodiscard]] bool reads_inputs(const CyclicCmd& command, const std::optional<ImageRange>& inputs,
                                const ProcessImage& image);
/// The first task with which some of the slave's outputs go; nothing where none do.
[[nodiscard]] std::optional<std::size_t> outputs_task(const NetworkConfig& config, std::size_t slave);
/// Whether the slave's outputs go, and its inputs come, with the base task: in every cycle.
[[nodiscard]] bool is_exchanged_in_each_cycle(const NetworkConfig& config, std::size_t slave);

}  // namespace syncline
