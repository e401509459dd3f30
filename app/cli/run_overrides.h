// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "support/result.h"

namespace syncline {
struct CompileResult;
}  // namespace syncline

namespace syncline::cli {

/// The configuration of a project or an ENI with settings for one run, "KEY=VALUE" each; dcm.* is short for
/// master.dc.*. A project is changed and then compiled, so that every key of a project can be set and means what it
/// means there. Of an ENI only master.dc.* that the master itself decides can be set: what lies in the file's frames
/// and commands is refused. kUnknownKey, kBadValue, and what loading and compiling report.
[[nodiscard]] Result<CompileResult> load_with_overrides(const std::string& path, std::string_view network,
                                                        std::span<const std::string> overrides);

}  // namespace syncline::cli
