// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "link/link.h"
#include "support/clock.h"
#include "support/result.h"

namespace syncline {

/// A link and the clock it runs on, from a LINK text: "sim:FILE[?virtual][&seed=N]", "nic:NAME",
/// "replay:FILE".
struct OpenedLink {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<Link> link;
};
[[nodiscard]] Result<OpenedLink> open_link(std::string_view text);

/// Folder of the installed or source resources: $SYNCLINE_RESOURCES, beside the binary, the source tree.
[[nodiscard]] std::string resource_folder();

}  // namespace syncline
