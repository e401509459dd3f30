// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/mailbox/mailbox_client.h"

namespace syncline::coe {
struct ObjectAddress;
}  // namespace syncline::coe

namespace syncline {

/// SDO transfers with one slave for those who wait: SdoWork, run to its end.
class CoeClient {
 public:
  /// Objects beyond this are refused before their data are fetched, bytes.
  static constexpr std::uint32_t kLargestObject = 16U << 20;

  explicit CoeClient(MailboxClient& mailbox) : mailbox_(mailbox) {}

  /// kSdoAbort with the abort code, kMailboxTimeout, kMailboxProtocol. Complete access begins at sub-index 0 or 1.
  Status download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access = false);
  Result<std::vector<std::uint8_t>> upload(coe::ObjectAddress object, bool complete_access = false);

  /// A number of up to four bytes; nothing when the slave does not have the entry, or when it is none.
  Result<std::optional<std::uint32_t>> upload_number(coe::ObjectAddress object);

 private:
  MailboxClient& mailbox_;
};

}  // namespace syncline
