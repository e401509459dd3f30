// SPDX-License-Identifier: Apache-2.0
#include "channels/command_queue.h"

namespace syncline {

std::optional<MasterCommand> CommandQueue::pop() {
  if (empty()) return std::nullopt;
  std::optional<MasterCommand> command(std::in_place);
  if (!commands_.try_dequeue(*command)) return std::nullopt;
  return command;
}

}  // namespace syncline
