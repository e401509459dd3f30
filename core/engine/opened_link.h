// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "link/link.h"
#include "support/clock.h"

namespace syncline {

struct ReplayNotes;

/// A link and the clock it runs on. The clock outlives the link. Who opens it decides which; what the engine does with
/// it takes a Result, so that the errors of opening pass through.
struct OpenedLink {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<Link> link;
  std::shared_ptr<const ReplayNotes> replay;  // of a capture; null: a bus that lives
};

}  // namespace syncline
