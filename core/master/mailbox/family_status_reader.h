// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "families/families.h"
#include "support/result.h"

namespace syncline::families {
struct Family;
}  // namespace syncline::families

namespace syncline {

struct Identity;
class MailboxClient;

/// What a device's family tells of its synchronisation in objects of its own.
struct FamilyStatus {
  const families::Family* family = nullptr;
  /// Of families with a status object: its value, and one line a bit.
  std::optional<std::uint32_t> status;
  std::vector<families::StatusLine> lines;
  /// Of gateways: states of the nodes by sub-index, from 1.
  std::vector<std::uint8_t> node_states;
};

/// Family null when the device is of none; objects that the slave does not have stay empty. Changes nothing in the
/// slave. kMailboxTimeout, kMailboxProtocol and errors of the bus; never kSdoAbort.
[[nodiscard]] Result<FamilyStatus> read_family_status(MailboxClient& mailbox, const Identity& identity);

}  // namespace syncline
