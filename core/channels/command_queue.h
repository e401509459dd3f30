// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "channels/bounded_queue.h"
#include "channels/command.h"
#include "support/result.h"
#include "support/types.h"

namespace syncline {

/// Of one command that was asked, from 1 in the order of asking.
using CommandId = std::uint64_t;

/// What became of a command: told once, when all that it does has been done.
struct CommandAnswer {
  CommandId id = 0;
  std::optional<Error> refused{};  // nothing: carried out. Refusals are events, too (events::Failure)
  Nanoseconds time = 0;            // host clock
};

/// Commands in their order, from one thread to one other, and what became of those that were asked back. Neither waits
/// for the other, and who carries them out does not allocate to see that there is none, nor to say that one was done.
class CommandQueue {
 public:
  static constexpr std::size_t kCapacity = 256;

  CommandQueue() : commands_(kCapacity), answers_(kCapacity) {}

  // ---- producer
  /// False when kCapacity commands wait already: the master is not listening, and this one is not taken.
  bool push(MasterCommand command) { return commands_.push({0, std::move(command)}); }
  /// The same, with an answer: its id. Nothing where it was not taken, or kCapacity answers are outstanding.
  std::optional<CommandId> ask(MasterCommand command);
  /// The next answer, in the order of asking; nothing as long as the master has none.
  std::optional<CommandAnswer> take_answer();

  // ---- consumer: the thread that runs the cycle
  struct Entry {
    CommandId id = 0;  // 0: nobody wants an answer
    MasterCommand command;
  };
  std::optional<Entry> pop() { return commands_.pop(); }
  void answer(CommandId id, std::optional<Error> refused, Nanoseconds now);
  [[nodiscard]] bool empty() const { return commands_.empty(); }

 private:
  BoundedQueue<Entry> commands_;
  BoundedQueue<CommandAnswer> answers_;  // cannot overflow: ask() counts
  CommandId last_ = 0;
  std::size_t outstanding_ = 0;  // asked and not taken
};

}  // namespace syncline
