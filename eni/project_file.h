// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "config/project.h"
#include "support/result.h"

namespace syncline::eni {

/// The project file: XML, self-contained (it carries each device description that it uses once, as an ESI Device
/// element), stable order and bytes for version control. save is atomic.
[[nodiscard]] Status save_project(const Project& project, const std::string& path);
/// kFileNotFound, kFileNotReadable, kXmlMalformed, kNotThatKindOfFile, kXmlMissingElement, kXmlBadValue with file, line
/// and element.
[[nodiscard]] Result<Project> load_project(const std::string& path);

[[nodiscard]] std::string write_project(const Project& project);
/// `file_name` is for messages.
[[nodiscard]] Result<Project> parse_project(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
