// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string_view>

#include "eni/project_builder.h"
#include "support/result.h"

namespace syncline {

class Bus;

/// Completes the slaves of a project from a scan of `bus` that have no ESI with their object dictionaries: each slave
/// with CoE is led to PREOP for that and left as it was found. What could not be read is a warning of the project.
/// Returns early when the bus is cancelled.
void describe_slaves(eni::BuiltProject& built, Bus& bus);
/// The same on a link of its own, which is opened for it only when there is a slave to ask.
[[nodiscard]] Status describe_slaves(eni::BuiltProject& built, std::string_view link, const std::atomic<bool>* cancel);
/// Whether it would ask any slave.
[[nodiscard]] bool has_undescribed_slaves(const eni::BuiltProject& built);

}  // namespace syncline
