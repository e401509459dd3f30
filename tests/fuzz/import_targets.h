// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Imports a run out of a table: a DCM log, or a run's CSV.
void run_table(std::span<const std::uint8_t> bytes);
/// Imports the run that a capture shows.
void run_import(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::vector<Bytes> tables();
[[nodiscard]] std::vector<Bytes> captured_runs();

}  // namespace syncline::fuzz
