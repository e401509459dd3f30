// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/compile/compile.h"
#include "support/result.h"

namespace syncline {

/// A file that can be run or exported: a project is compiled, an ENI is read as it is.
[[nodiscard]] Result<CompileResult> load_config(const std::string& path, const CompileOptions& options = {});

}  // namespace syncline
