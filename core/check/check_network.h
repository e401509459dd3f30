// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace syncline {

class FindingList;
struct Finding;
struct FindingWords;
struct NetworkConfig;

/// All rules of the checker in the order of docs/check.md: by family, then by number.
[[nodiscard]] std::span<const FindingWords> check_rules();

/// Everything in a configuration that a master or a slave would stumble over, or that looks like a slip, by the rules
/// of check_rules(); each has its place in the configuration. Pure, bounded by the size of the configuration (n log n),
/// for any values in it.
[[nodiscard]] std::vector<Finding> check_network(const NetworkConfig& config);
/// The same of a configuration that others wrote: as many as the list takes.
void check_network(const NetworkConfig& config, FindingList& findings);

}  // namespace syncline
