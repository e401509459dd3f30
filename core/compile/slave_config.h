// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compile/compile.h"

namespace syncline {
struct MasterSettings;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// A planned slave as the configuration has it, without its place in the process image.
[[nodiscard]] SlaveConfig slave_config(const SlavePlan& plan, EniDialect dialect);

[[nodiscard]] MasterConfig master_config(const MasterSettings& settings, const std::vector<SlavePlan>& plans,
                                         const DcMasterSettings& dc, std::uint16_t mailbox_states);

}  // namespace syncline::compiler
