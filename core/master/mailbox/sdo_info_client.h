// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "master/mailbox/mailbox_client.h"
#include "protocol/sdo_information.h"

namespace syncline {

/// SDO information for those who wait: SdoWork, run to its end. Asks a slave which objects it has and what they are.
/// Not every slave answers: kMailboxProtocol ("does not support this service") or kSdoAbort then. Slaves whose
/// fragments never end or contradict are refused.
class SdoInfoClient {
 public:
  explicit SdoInfoClient(MailboxClient& mailbox) : mailbox_(mailbox) {}

  Result<std::vector<std::uint16_t>> object_list(coe::ObjectListType list = coe::ObjectListType::kAll);
  Result<coe::ObjectDescription> object(std::uint16_t index);
  Result<coe::EntryDescription> entry(std::uint16_t index, std::uint8_t sub_index, std::uint8_t value_info = 0);

 private:
  template <class Expected>
  Result<Expected> ask_for(const coe::InformationRequest& request);

  MailboxClient& mailbox_;
};

}  // namespace syncline
