// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <readerwriterqueue/readerwritercircularbuffer.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "channels/command.h"

namespace syncline {

/// Commands in their order, from one thread to one other. Neither waits for the other, and who carries them out does
/// not allocate to see that there is none.
class CommandQueue {
 public:
  static constexpr std::size_t kCapacity = 256;

  CommandQueue() : commands_(kCapacity) {}
  /// False when kCapacity commands wait already: the master is not listening, and this one is not taken. Producer.
  bool push(MasterCommand command) { return commands_.try_enqueue(std::move(command)); }
  std::optional<MasterCommand> pop();                                        // consumer: the thread that runs the cycle
  [[nodiscard]] bool empty() const { return commands_.size_approx() == 0; }  // consumer

 private:
  moodycamel::BlockingReaderWriterCircularBuffer<MasterCommand> commands_;
};

}  // namespace syncline
