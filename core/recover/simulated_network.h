// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

struct NetworkConfig;
struct Project;
struct SimConfig;

/// A simulated segment on which this configuration runs: a slave for each of the ENI, of the same identity, wired as
/// the ENI says (in a line where it is silent), with SyncManagers, FMMUs, PDOs, mailbox and DC unit of the size that
/// the ENI uses, and with the objects that its start-up commands write. What the ENI says wrongly, the devices refuse.
[[nodiscard]] SimConfig simulated_network(const NetworkConfig& config);

/// The same with the devices that a project knows from their ESI.
[[nodiscard]] SimConfig simulated_network(const Project& project);

}  // namespace syncline
