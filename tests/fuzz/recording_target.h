// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Opens a recording (SQLite) and reads all of it. What verify() finds whole can be read from end to end.
void run_recording(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::vector<Bytes> recordings();

}  // namespace syncline::fuzz
