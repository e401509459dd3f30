// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "master/mailbox/mailbox_client.h"
#include "protocol/coe.h"

namespace syncline {

/// CoE SDO client of one slave in blocking style: expedited, normal, segmented transfers and complete access.
/// A slave that lies about lengths, toggles or ends is refused with kMailboxProtocol and gets an abort.
class CoeClient {
 public:
  /// Objects beyond this are refused before their data are fetched, bytes.
  static constexpr std::uint32_t kLargestObject = 16U << 20;

  explicit CoeClient(MailboxClient& mailbox) : mailbox_(mailbox) {}

  /// kSdoAbort with the abort code, kMailboxTimeout, kMailboxProtocol. Complete access begins at sub-index 0 or 1.
  Status download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access = false);
  Result<std::vector<std::uint8_t>> upload(coe::ObjectAddress object, bool complete_access = false);

 private:
  template <class Expected>
  Result<Expected> ask_for(const coe::Request& request, coe::ObjectAddress object);
  Status download_segments(coe::ObjectAddress object, std::span<const std::uint8_t> rest);
  Status upload_segments(coe::ObjectAddress object, std::uint32_t complete_size, std::vector<std::uint8_t>& data);
  tl::unexpected<Error> refuse(coe::ObjectAddress object, std::uint32_t abort_code, std::string why);
  [[nodiscard]] std::string subject(coe::ObjectAddress object) const;

  MailboxClient& mailbox_;
};

}  // namespace syncline
