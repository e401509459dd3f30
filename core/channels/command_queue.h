// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "channels/command.h"

namespace syncline {

class CommandQueue {
 public:
  void push(MasterCommand command);
  std::optional<MasterCommand> pop();
  [[nodiscard]] bool empty();

 private:
  std::mutex mutex_;
  std::vector<MasterCommand> commands_;
};

}  // namespace syncline
