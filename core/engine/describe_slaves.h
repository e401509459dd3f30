// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "support/result.h"

namespace syncline {

struct OpenedLink;
struct Project;

class Bus;

/// Completes the slaves of a project from a scan of `bus` that have no ESI with their object dictionaries: each slave
/// with CoE is led to PREOP for that and left as it was found. What could not be read is returned.
/// Returns early when the bus is cancelled.
[[nodiscard]] std::vector<Error> describe_slaves(Project& project, Bus& bus);
/// The same on a link of its own, which is opened for it only when there is a slave to ask.
[[nodiscard]] Result<std::vector<Error>> describe_slaves(Project& project,
                                                         const std::function<Result<OpenedLink>()>& open,
                                                         const std::atomic<bool>* cancel);
/// Whether it would ask any slave.
[[nodiscard]] bool has_undescribed_slaves(const Project& project);

}  // namespace syncline
