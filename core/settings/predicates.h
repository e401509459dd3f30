// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "support/types.h"

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

/// Rules about several settings, each by its name; whoever sets, checks or shows asks here.
namespace syncline::settings {

struct Range;

/// The send phase must lie inside the cycle: SYNC0 comes after sending and before the next frame.
[[nodiscard]] Range set_values(Nanoseconds cycle);

/// A SYNC signal and the frames keep step: one period is a multiple of the other, give or take less than `rounding`
/// (files hold whole microseconds).
[[nodiscard]] bool keeps_step(Nanoseconds sync_period, Nanoseconds cycle, Nanoseconds rounding = 1);

/// The shift of a SYNC signal lies within one period of it to either side: further on it counts modulo the period.
[[nodiscard]] bool within_period(Nanoseconds shift, Nanoseconds sync_period);

/// The ENI and the registers hold this time of a SYNC signal.
[[nodiscard]] bool is_sync_time(Nanoseconds time);

[[nodiscard]] bool is_position(std::size_t slaves, std::int64_t position);

// What a device must have for a setting to mean something.
[[nodiscard]] bool has_clock(const SlaveSettings& slave);  // distributed clocks in its description
[[nodiscard]] bool has_mailbox(const SlaveSettings& slave);
[[nodiscard]] bool has_coe(const SlaveSettings& slave);
[[nodiscard]] bool has_soe(const SlaveSettings& slave);
[[nodiscard]] bool has_eoe(const SlaveSettings& slave);
[[nodiscard]] bool has_aoe(const SlaveSettings& slave);
[[nodiscard]] bool is_gateway(const SlaveSettings& slave);        // a CAN gateway of a family that is known
[[nodiscard]] bool has_process_data(const SlaveSettings& slave);  // of its own or of modules

}  // namespace syncline::settings
