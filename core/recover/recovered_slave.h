// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recover/recover_project.h"

namespace syncline::compiler {
class FindingList;
}  // namespace syncline::compiler

namespace syncline::recover {

/// The settings of one slave, without those start-up commands that can only be told apart when the rest is compiled.
[[nodiscard]] SlaveSettings recovered_slave(const NetworkConfig& config, std::size_t position,
                                            const DeviceLookup& devices, compiler::FindingList& findings);

}  // namespace syncline::recover
