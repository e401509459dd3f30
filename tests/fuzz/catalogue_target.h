// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Opens a catalogue's database (SQLite) and looks into it. Whatever was in the file, mend() leaves one that works.
void run_catalogue(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::vector<Bytes> catalogues();

}  // namespace syncline::fuzz
