// SPDX-License-Identifier: Apache-2.0
#include "ui/session/master_end.h"

#include <future>
#include <thread>
#include <utility>

#include "channels/background_master.h"

namespace syncline::ui {

bool endMaster(std::unique_ptr<BackgroundMaster> master, std::chrono::milliseconds patience) {
  if (!master->started()) return true;
  std::promise<void> told;
  const auto ended = told.get_future();
  // Nobody joins it: a thread that hangs is not waited for by another one that then hangs, too.
  std::thread([master = std::move(master), told = std::move(told)]() mutable {
    master.reset();
    told.set_value();
  }).detach();
  return ended.wait_for(patience) == std::future_status::ready;
}

}  // namespace syncline::ui
