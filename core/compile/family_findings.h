// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
struct SlaveConfig;
}  // namespace syncline

namespace syncline::compiler {

class FindingList;
struct SlavePlan;

/// What the slave's device family refuses (errors) or does not bear (warnings) of the configuration made from the plan,
/// and a cycle below the minimum that its object dictionary names.
void find_family_problems(FindingList& findings, const SlavePlan& slave, const SlaveConfig& config);

}  // namespace syncline::compiler
