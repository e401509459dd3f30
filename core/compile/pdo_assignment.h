// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct ConfiguredPdo;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::compiler {

struct ProcessDataChannel;

/// All PDOs of a slave with the user's changed mappings and the user's assignment: Tx, then Rx, ESI order.
[[nodiscard]] std::vector<ConfiguredPdo> effective_pdos(const SlaveSettings& slave);

/// The process-data SyncManagers with the PDOs that the user assigned, in the user's order. An assigned PDO goes to
/// the SyncManager that the ESI names for it, else to the first one of its direction; one that finds none is left out
/// (findings name it).
[[nodiscard]] std::vector<ProcessDataChannel> process_data_channels(const SlaveSettings& slave);

/// True for a slave without mailbox whose assigned entries are all smaller than a byte.
[[nodiscard]] bool is_bit_oriented(const SlaveSettings& slave);

}  // namespace syncline::compiler
