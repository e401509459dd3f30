// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/result.h"

namespace syncline {
struct JitterProfile;
}  // namespace syncline

namespace syncline::sim {

/// The measured times of a host in a TOML file (docs/scenarios.md, "Hosts"). kFileNotFound, kTomlMalformed, or
/// kScenarioKey with file, line and key, also for values that contradict each other.
[[nodiscard]] Result<JitterProfile> read_host_profile(const std::string& path);

/// The same profile as such a file. `about`: what was measured, a line or more; it becomes a comment.
[[nodiscard]] std::string host_profile_text(const JitterProfile& profile, const std::string& about);

}  // namespace syncline::sim
