// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Reads an ESI file; what is read goes on into projects and their configuration.
void run_esi(std::span<const std::uint8_t> bytes);
/// Reads an ENI; what is read can be written and read again.
void run_eni(std::span<const std::uint8_t> bytes);
/// Reads a project; what is read can be written, comes back the same, and compiles or says why not.
void run_project(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::vector<Bytes> esis();
[[nodiscard]] std::vector<Bytes> enis();
[[nodiscard]] std::vector<Bytes> projects();

}  // namespace syncline::fuzz
