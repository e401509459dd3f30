// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

struct CycleSample;

/// The master is in OP, or nothing says in which state it is.
[[nodiscard]] bool is_run_in_op(const CycleSample& sample);

/// Once a run is armed: the figures have this cycle in them. In OP every cycle counts. Below it, where a fault has put
/// the master, those count in which what is watched is held against the reference clock: in sync or out of it. Who
/// settles there is brought up again, and of what is unknown nothing is claimed.
[[nodiscard]] bool counts_in_figures(const CycleSample& sample);

}  // namespace syncline
