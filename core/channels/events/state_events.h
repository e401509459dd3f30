// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/values/shared_text.h"
#include "protocol/al_state.h"

/// States: of the master, of slaves and of who belongs to the bus.
namespace syncline::events {

struct Online {};   // a configuration runs; it may have come up in part only
struct Offline {};  // and now none

/// Of the event's slave, or of the master: the lowest of all, kNone while one does not answer.
struct StateChanged {
  AlState from = AlState::kNone;
  AlState to = AlState::kNone;
};

/// The slave refused a state, or left one by itself (ETG.1000.6, 5.3).
struct AlStatusError {
  std::uint16_t al_status = 0;       // register 0x0130
  std::uint16_t al_status_code = 0;  // register 0x0134
};

/// The slave went down from SAFEOP or OP without an error, and nobody here has asked it: another master did, or it
/// began anew.
struct LeftUnasked {
  AlState from = AlState::kNone;
  AlState to = AlState::kNone;
};

/// A bring-up begins, and some slaves are in SAFEOP or OP: another master operates them, or they were left so.
struct BusWasRunning {};

/// Its state is unknown from then on, until the StateChanged that follows.
struct SlaveLost {};
struct SlaveFound {};

/// The slave is the head of a group that comes and goes as it likes.
struct HotConnect {
  enum class What : std::uint8_t { kDisconnected, kConnected, kNotThereYet };
  What what = What::kNotThereYet;
  SharedText group;  // its name
};

/// The slave fell, or came back, and is led up again.
struct RecoveryStep {
  enum class Stage : std::uint8_t { kBegun, kDone, kFailed, kGivenUp };
  Stage stage = Stage::kBegun;
  std::uint32_t tries = 0;  // number of this try, from 1
};

}  // namespace syncline::events
