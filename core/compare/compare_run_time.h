// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace syncline {

struct ConfigDifference;
struct Project;

/// Settings of two projects that only our master knows, as no ENI has a place for them: the numbers of synchronisation
/// and monitoring, recovery, real time. Group kRunTime, `what` is the settings key.
[[nodiscard]] std::vector<ConfigDifference> compare_run_time(const Project& left, const Project& right);

/// Those of them of which an ENI does not say enough, for whoever sets up another master. The mode of the DCM is one:
/// an ENI shows whether the reference clock is steered, not how (docs/eni.md).
[[nodiscard]] bool is_unsaid_setting(const std::string& key);

}  // namespace syncline
