// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "config/network_config.h"
#include "findings/finding.h"
#include "support/result.h"

namespace syncline {

struct Project;

/// How the field's tools differ in writing an ENI (docs/eni.md). EC-Engineer's way is the default.
enum class EniDialect : std::uint8_t { kEcEngineer, kTwinCat };

struct CompileOptions {
  EniDialect dialect = EniDialect::kEcEngineer;
  bool operator==(const CompileOptions&) const = default;
};

struct CompileResult {
  NetworkConfig config;
  std::vector<Finding> findings;
};

/// Pure: the same project gives the same configuration. Findings of severity error mean that the
/// configuration cannot run; it is still complete enough to look at. An Error is returned only when
/// nothing can be built (no slaves, cycle time out of range).
[[nodiscard]] Result<CompileResult> compile(const Project& project, const CompileOptions& options = {});

}  // namespace syncline
