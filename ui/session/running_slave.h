// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "channels/slave_status.h"
#include "protocol/al_state.h"

namespace syncline {
struct SlaveConfig;
}  // namespace syncline

namespace syncline::ui {

class Workspace;

/// A slave of the project on the bus that runs: the project may have been edited since, and what is meant for one slave
/// must never reach another.
struct RunningSlave {
  std::uint16_t position = 0;           // in the configuration that runs
  const SlaveConfig* config = nullptr;  // of it
  const SlaveStatus* status = nullptr;  // in the latest snapshot; null before there is one
  [[nodiscard]] AlState state() const;  // kNone when it does not answer
  [[nodiscard]] bool present() const { return status != nullptr && status->present; }
  /// Its outputs drive something.
  [[nodiscard]] bool drives() const { return state() == AlState::kOp || state() == AlState::kSafeop; }
};

/// Nothing when offline, and when no slave that runs has its station address and identity.
[[nodiscard]] std::optional<RunningSlave> runningSlave(Workspace& workspace, int slave);

}  // namespace syncline::ui
