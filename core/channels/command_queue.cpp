// SPDX-License-Identifier: Apache-2.0
#include "channels/command_queue.h"

namespace syncline {

std::optional<CommandId> CommandQueue::ask(MasterCommand command) {
  if (outstanding_ == kCapacity || !commands_.push({last_ + 1, std::move(command)})) return std::nullopt;
  ++outstanding_;
  return ++last_;
}

std::optional<CommandAnswer> CommandQueue::take_answer() {
  auto answer = answers_.pop();
  if (answer) --outstanding_;
  return answer;
}

void CommandQueue::answer(CommandId id, std::optional<Error> refused, Nanoseconds now) {
  if (id != 0) (void)answers_.push({id, std::move(refused), now});
}

}  // namespace syncline
