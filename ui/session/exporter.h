// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "support/result.h"

namespace syncline::ui {

class ConfigurationMonitor;

/// Writes the ENI of the project as it is now. Fails when the project cannot be compiled or the file
/// cannot be written; findings of severity error do not stop it (the messages show them).
[[nodiscard]] Status exportEni(ConfigurationMonitor& configuration, const QString& path);

}  // namespace syncline::ui
