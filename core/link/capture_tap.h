// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "link/link.h"
#include "support/clock.h"

namespace syncline {

/// A Link around `inner` that writes every frame sent and received into a pcapng file; the file is
/// complete when the tap is destroyed. Writing allocates: not for a cyclic thread with a deadline.
[[nodiscard]] Result<std::unique_ptr<Link>> make_capture_tap(std::unique_ptr<Link> inner, const std::string& path,
                                                             Clock& clock);

}  // namespace syncline
