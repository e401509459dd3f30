// SPDX-License-Identifier: Apache-2.0
#include "channels/command_queue.h"

#include <utility>

namespace syncline {

void CommandQueue::push(MasterCommand command) {
  const std::scoped_lock lock(mutex_);
  commands_.push_back(std::move(command));
}

bool CommandQueue::empty() {
  const std::scoped_lock lock(mutex_);
  return commands_.empty();
}

std::optional<MasterCommand> CommandQueue::pop() {
  const std::scoped_lock lock(mutex_);
  if (commands_.empty()) return std::nullopt;
  auto command = std::move(commands_.front());
  commands_.erase(commands_.begin());
  return command;
}

}  // namespace syncline
