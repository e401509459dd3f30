// SPDX-License-Identifier: Apache-2.0
#include "channels/command_queue.h"

namespace syncline {

std::optional<CommandId> CommandQueue::ask(MasterCommand command) {
  if (outstanding_ == kCapacity || !commands_.try_enqueue({last_ + 1, std::move(command)})) return std::nullopt;
  ++outstanding_;
  return ++last_;
}

std::optional<CommandAnswer> CommandQueue::take_answer() {
  std::optional<CommandAnswer> answer(std::in_place);
  if (answers_.size_approx() == 0 || !answers_.try_dequeue(*answer)) return std::nullopt;
  --outstanding_;
  return answer;
}

std::optional<CommandQueue::Entry> CommandQueue::pop() {
  if (empty()) return std::nullopt;
  std::optional<Entry> entry(std::in_place);
  if (!commands_.try_dequeue(*entry)) return std::nullopt;
  return entry;
}

void CommandQueue::answer(CommandId id, std::optional<Error> refused, Nanoseconds now) {
  if (id != 0) (void)answers_.try_enqueue({id, std::move(refused), now});
}

}  // namespace syncline
