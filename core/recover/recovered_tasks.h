// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::compiler {
class FindingList;
}  // namespace syncline::compiler

namespace syncline::recover {

/// Cyclic tasks behind the first one become tasks with a Sync Unit each; slaves whose FMMUs point into the process data
/// that a task exchanges are put into its Sync Unit. A cycle that is no multiple of the first one's is a finding, and
/// its slaves stay in the base task.
void recover_tasks(Project& project, const NetworkConfig& config, compiler::FindingList& findings);

}  // namespace syncline::recover
