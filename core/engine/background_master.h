// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace syncline {

class BackgroundMaster;
struct OpenedLink;

/// A master on the bus behind `link`, which it keeps with its clock. Nothing runs yet. When it goes, the slaves go to
/// INIT.
[[nodiscard]] std::unique_ptr<BackgroundMaster> make_background_master(OpenedLink link);

}  // namespace syncline
