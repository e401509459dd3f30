// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {

struct OpenedLink;
struct Project;

/// Opens "sim:FILE[?virtual][&seed=N]", "nic:NAME" or "replay:FILE". Errors name the file, line and key of a scenario,
/// or the adapter and the command that grants the permission.
[[nodiscard]] Result<OpenedLink> open_link(std::string_view text);

/// The simulated bus that a project describes, on the virtual clock. Errors as of a scenario.
[[nodiscard]] Result<OpenedLink> open_simulated(const Project& machine);

/// Folder of the resources (ESI files, demo machine): $SYNCLINE_RESOURCES, ../share/syncline beside the
/// binary, or the source tree that this was built from.
[[nodiscard]] std::string resource_folder();

/// LINK of the demonstration machine on the virtual or the real clock.
[[nodiscard]] std::string demo_link(bool virtual_clock);

}  // namespace syncline
