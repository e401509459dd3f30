// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace syncline {
struct HotConnectConfig;
struct Project;
}  // namespace syncline

namespace syncline::compiler {

/// The hot-connect group that `slave` heads, if it does: as many of the slaves that follow in the frame's way as hang
/// behind it, and the commands that compare its device ID or its alias (ENI Slave/HotConnect). An optional slave is a
/// group of its own, named as the slave.
[[nodiscard]] std::optional<HotConnectConfig> plan_hot_connect(const Project& project, std::size_t slave);

}  // namespace syncline::compiler
