// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace syncline {
struct DcMasterSettings;
struct Project;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// Fills SlavePlan::dc of the slaves whose op mode switches DC on, and marks the reference clock.
void plan_dc(const Project& project, std::span<SlavePlan> slaves);

/// The user's choice where it names a slave with a DC unit, else the first slave with DC enabled.
[[nodiscard]] std::optional<std::uint16_t> resolve_reference_clock(const Project& project,
                                                                   std::span<const SlavePlan> slaves);

/// The project's run-time DC numbers with the resolved reference clock; switched off when no slave uses DC.
[[nodiscard]] DcMasterSettings run_time_dc(const Project& project, std::span<const SlavePlan> slaves);

}  // namespace syncline::compiler
