// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "app/cli/context.h"
#include "compile/compile.h"

namespace syncline::cli {

[[nodiscard]] bool has_errors(const std::vector<Finding>& findings);
[[nodiscard]] Json to_json(const std::vector<Finding>& findings);
void print(std::ostream& out, const std::vector<Finding>& findings);

}  // namespace syncline::cli
