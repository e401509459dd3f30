// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Reads a scenario (TOML); what is read becomes a simulated segment that runs for some milliseconds.
void run_scenario(std::span<const std::uint8_t> bytes);
/// Reads a DCM log; what is read can be written, and comes back the same.
void run_dcm_log(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::vector<Bytes> scenarios();
[[nodiscard]] std::vector<Bytes> dcm_logs();

}  // namespace syncline::fuzz
