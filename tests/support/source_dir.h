// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline::test {

/// The project's folder, without a slash at the end. A function, not a macro: the compile commands of all other files
/// are the same wherever the project lies, so that compiler caches serve every checkout.
[[nodiscard]] std::string source_dir();

}  // namespace syncline::test
