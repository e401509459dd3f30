// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::compiler {

/// The slave with everything put into its description that the user sets against it: PDOs and commands of the plugged
/// modules, oversampling, watchdogs, time-outs, mailbox sizes, mailbox protocols that are switched off. All later steps
/// see only descriptions. Null when the ESI stands as it is, which spares the copy.
[[nodiscard]] std::shared_ptr<const SlaveSettings> effective_slave(const SlaveSettings& slave);

/// How often a PDO's entries are in the process data of one cycle: the user's factor, else that of the operation mode,
/// else 1. At most 1000, at least 1.
[[nodiscard]] std::uint16_t oversampling_factor(const SlaveSettings& slave, std::uint16_t pdo);

}  // namespace syncline::compiler
