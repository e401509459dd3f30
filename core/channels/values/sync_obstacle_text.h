// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "channels/values/sync_obstacle.h"

namespace syncline::dc {

/// English, behind a colon: "cycles were left out, the host came too late". Empty for kNone.
[[nodiscard]] std::string_view obstacle_text(SyncObstacle obstacle);

}  // namespace syncline::dc
