// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "config/dcm_settings.h"
#include "dc/dcm/dcm_controller.h"

namespace syncline::bench {

/// What the figures of the master synchronisation are compared with: PI controllers with published gains and nothing
/// else, which take the frame as it passes the reference clock.
/// - Master shift: 0.01 and 2e-5 a cycle.
/// - Bus shift: 0.02 and 1e-4 a cycle behind a filter of 0.05, the time predicted from the last reading and the cycle.
[[nodiscard]] std::unique_ptr<dc::DcmController> make_plain_controller(DcmMode mode, Nanoseconds cycle,
                                                                       Nanoseconds set_value);

}  // namespace syncline::bench
