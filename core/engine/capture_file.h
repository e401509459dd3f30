// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "support/result.h"

namespace syncline {

class CaptureState;
struct OpenedLink;

/// From now on every frame of the link is written to this pcapng file, which is complete when the link is gone and the
/// state has not failed. Null for "": no capture. kFileNotWritable when the file cannot be made.
[[nodiscard]] Result<std::shared_ptr<const CaptureState>> capture_to(const std::string& file, OpenedLink& opened);

}  // namespace syncline
