// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace syncline {

struct BusScan;
struct SlaveWiring;

/// What a user should know about the bus that was scanned, by slave: swapped cables, ports that lead
/// nowhere, aliases that do not tell slaves apart, EEPROMs that do not fit, and what the scan left out
/// or touched. Appends to scan.findings. Pure.
void add_scan_findings(std::span<const SlaveWiring> wiring, BusScan& scan);

}  // namespace syncline
