// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline {

/// Files that are read for a LINK: the scenario with what it names, or the capture. As far as they can be found: what
/// is wrong with a LINK says open_link(). kCancelled alone: a signal ended the waiting for one of them.
[[nodiscard]] Result<std::vector<std::string>> link_files(std::string_view text);

}  // namespace syncline
