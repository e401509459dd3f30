// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "settings/setting_type.h"
#include "support/types.h"

/// Rules about several settings, each by its name; whoever sets, checks or shows asks here.
namespace syncline::settings {

/// The send phase must lie inside the cycle: SYNC0 comes after sending and before the next frame.
[[nodiscard]] Range set_values(Nanoseconds cycle);

/// A SYNC signal and the frames keep step: one period is a multiple of the other, give or take less than `rounding`
/// (files hold whole microseconds).
[[nodiscard]] bool keeps_step(Nanoseconds sync_period, Nanoseconds cycle, Nanoseconds rounding = 1);

[[nodiscard]] bool is_position(std::size_t slaves, std::int64_t position);

/// Whether our master can run with this bus cycle.
[[nodiscard]] bool is_bus_cycle(Nanoseconds cycle);

}  // namespace syncline::settings
