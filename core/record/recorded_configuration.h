// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "config/network_config.h"
#include "support/result.h"

namespace syncline {

struct RecordingAbout;

/// Who knows ENI files reads one: its text, and the name of the file it came from.
using ConfigurationParser = std::function<Result<NetworkConfig>(const std::string& text, const std::string& name)>;

/// What was run: the recording's document "configuration", or where it has none that can be read and is of its slaves,
/// at least these with their names and identities.
[[nodiscard]] NetworkConfig recorded_configuration(const RecordingAbout& about, const ConfigurationParser& parse);

}  // namespace syncline
