// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "eni/project_builder.h"
#include "master/bus.h"

namespace syncline::eni {

/// Completes the slaves of a project from a scan of `bus` that have no ESI with their object dictionaries: each slave with
/// CoE is led to PREOP for that and left as it was found. What could not be read is a warning of the project. Returns
/// early when the bus is cancelled.
void describe_slaves(BuiltProject& built, Bus& bus);
/// Whether it would ask any slave.
[[nodiscard]] bool has_undescribed_slaves(const BuiltProject& built);

}  // namespace syncline::eni
