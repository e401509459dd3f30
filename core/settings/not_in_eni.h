// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Why a setting changes nothing in an ENI: what an ENI (ETG.2100) has no element for, whoever runs the bus decides.
namespace syncline::settings::not_in_eni {

inline constexpr auto kMaster = "decided by the master that runs the bus";
inline constexpr auto kClocks = "done by the master as it sets up the clocks";
inline constexpr auto kControl = "of the controller in the master that runs the bus";
inline constexpr auto kJudged = "judged by the master that runs the bus";
inline constexpr auto kTold = "told by the master that runs the bus";
inline constexpr auto kHost = "of the host that the master runs on";
inline constexpr auto kProject = "kept in the project alone";

}  // namespace syncline::settings::not_in_eni
