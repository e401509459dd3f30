// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/composition/open_link.h"

namespace syncline {

/// From now on every frame of the link is written to this pcapng file; "": none. kFileNotWritable.
[[nodiscard]] Status capture_to(const std::string& file, OpenedLink& opened);
/// Whether the capture is whole; after the link is gone. kFileNotWritable when writing failed on the way.
[[nodiscard]] Status capture_complete(const std::string& file);

}  // namespace syncline
