// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {
struct NetworkConfig;
}  // namespace syncline

/// What programs and people need of a configuration beside the ENI. Pure text, the same bytes for the same
/// configuration; CSV as RFC 4180 with a header row, comma, UTF-8 and CR LF.
namespace syncline::exports {

/// Header for C99 and C++: sizes, cycle time, and for each variable its place in the image with functions that read
/// inputs and write outputs, whatever the byte order and alignment of the machine. `name` gives prefix and include
/// guard.
[[nodiscard]] std::string c_header(const NetworkConfig& config, const std::string& name);

/// One row a variable: direction, name, data type, bits, byte and bit in the image.
[[nodiscard]] std::string image_csv(const NetworkConfig& config);

/// One row an entry of each PDO: slave, PDO, SyncManager, whether it is assigned, and its place in the image if it is.
[[nodiscard]] std::string pdo_csv(const NetworkConfig& config);

/// One row a slave: identity, addresses, wiring, process data, mailbox protocols, DC.
[[nodiscard]] std::string slaves_csv(const NetworkConfig& config);

/// One row an init command, in the order of init_commands.h: transition, protocol, command, target, data, what is
/// expected, comment.
[[nodiscard]] std::string init_commands_csv(const NetworkConfig& config);

/// Drawing of the segment: slaves in frame order from top to bottom, branches to the right.
[[nodiscard]] std::string topology_svg(const NetworkConfig& config);

}  // namespace syncline::exports
