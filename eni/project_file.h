// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "config/project.h"
#include "support/result.h"

namespace syncline::eni {

/// The project file: XML, self-contained (it carries the device descriptions it uses, as ESI Device
/// elements), stable order and bytes for version control. save is atomic.
[[nodiscard]] Status save_project(const Project& project, const std::string& path);
[[nodiscard]] Result<Project> load_project(const std::string& path);

}  // namespace syncline::eni
