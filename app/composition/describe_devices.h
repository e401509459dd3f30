// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "eni/project_builder.h"
#include "support/result.h"

namespace syncline {

/// Completes the slaves of a project from a scan that have no ESI with their object dictionaries, read from `link`: each
/// slave with CoE is led to PREOP for that and left as it was found. What could not be read is a warning of the project.
void describe_devices(eni::BuiltProject& built, const std::string& link, const std::atomic<bool>* cancel = nullptr);

}  // namespace syncline
