// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace syncline {
struct Finding;
struct NetworkConfig;
struct Project;
}  // namespace syncline

/// The sections of reports, HTML without their titles.
namespace syncline::exports {

struct ReportFacts;

/// "2 errors, 1 warning, 3 notes", "none"
[[nodiscard]] std::string finding_counts(std::span<const Finding> findings);

[[nodiscard]] std::string slaves_section(const NetworkConfig& config, const Project* source);
[[nodiscard]] std::string sync_section(const NetworkConfig& config, const Project* source);
/// `set`: the numbers are the project's; else those of an ENI, which holds few of them.
[[nodiscard]] std::string clocks_section(const NetworkConfig& config, bool set);
[[nodiscard]] std::string frames_section(const NetworkConfig& config);
[[nodiscard]] std::string findings_section(std::span<const Finding> findings);
/// The drawing without the head of a file of its own.
[[nodiscard]] std::string topology_section(const NetworkConfig& config);
[[nodiscard]] std::string unsaid_section(const ReportFacts& facts);

}  // namespace syncline::exports
