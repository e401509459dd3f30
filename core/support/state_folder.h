// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {

/// What has to outlive a killed program: $XDG_STATE_HOME/syncline/NAME, or ~/.local/state/syncline/NAME. It need not be
/// there yet.
[[nodiscard]] std::string state_folder(const std::string& name);

}  // namespace syncline
