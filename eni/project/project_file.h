// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {
struct Machine;
struct Project;
}  // namespace syncline

namespace syncline::eni {

/// The project file: XML, self-contained (it carries each device description that it uses once, as an ESI Device
/// element), stable order and bytes for version control. It holds a machine: one network as a rule, or several with a
/// master each. save is atomic.
[[nodiscard]] Status save_machine(const Machine& machine, const std::string& path);
/// kFileNotFound, kFileNotReadable, kXmlMalformed, kNotThatKindOfFile, kXmlMissingElement, kXmlBadValue with file, line
/// and element.
[[nodiscard]] Result<Machine> load_machine(const std::string& path);
[[nodiscard]] std::string write_machine(const Machine& machine);
/// `file_name` is for messages.
[[nodiscard]] Result<Machine> parse_machine(std::string_view text, const std::string& file_name);

/// Which network of a machine is meant: by name, by number from 0, or "" where there is only one. kBadValue lists them.
[[nodiscard]] Result<std::size_t> find_network(const Machine& machine, std::string_view network);

/// A file with this network alone.
[[nodiscard]] Status save_project(const Project& project, const std::string& path);
/// As load_machine and find_network.
[[nodiscard]] Result<Project> load_project(const std::string& path, std::string_view network = {});
[[nodiscard]] std::string write_project(const Project& project);
[[nodiscard]] Result<Project> parse_project(std::string_view text, const std::string& file_name,
                                            std::string_view network = {});

}  // namespace syncline::eni
