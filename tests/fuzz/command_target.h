// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// The arguments of a command line, a line each: a known exit code, and with --json one valid object whatever happens.
void run_command(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::vector<Bytes> commands();
/// A word replaced by another that the program knows or by a nasty one, taken out, doubled or put in.
[[nodiscard]] Bytes damage_words(const Bytes& good, Random& random);

}  // namespace syncline::fuzz
