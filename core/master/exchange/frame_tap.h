// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "channels/frame_ring.h"
#include "link/link.h"
#include "support/clock.h"

namespace syncline {

/// A Link around `inner` that puts every frame that the adapter has taken, and every one that came, into `ring` as long
/// as somebody has it open. It allocates and locks nothing. The clock must outlive it.
[[nodiscard]] std::unique_ptr<Link> make_frame_tap(std::unique_ptr<Link> inner, Clock& clock,
                                                   std::shared_ptr<FrameRing> ring);

}  // namespace syncline
