// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace syncline {

class Clock;
class Link;
struct MasterChannels;

/// A Link around `inner` that puts every frame that the adapter has taken, and every one that came, into the channels'
/// ring as long as somebody has it open, and lets their heart beat whenever the adapter has come back from its work. It
/// allocates and locks nothing. Clock and channels must outlive it.
[[nodiscard]] std::unique_ptr<Link> make_frame_tap(std::unique_ptr<Link> inner, Clock& clock, MasterChannels& channels);

}  // namespace syncline
