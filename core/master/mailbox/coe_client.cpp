// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/coe_client.h"

#include "master/mailbox/sdo_work.h"

namespace syncline {

Status CoeClient::download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access) {
  SdoWork work(mailbox_.mailbox());
  work.download(object, complete_access, data);
  return mailbox_.run(work);
}

Result<std::vector<std::uint8_t>> CoeClient::upload(coe::ObjectAddress object, bool complete_access) {
  std::vector<std::uint8_t> data;
  SdoWork work(mailbox_.mailbox());
  work.upload(object, complete_access, data, kLargestObject);
  if (auto status = mailbox_.run(work); !status) return tl::unexpected(status.error());
  return data;
}

}  // namespace syncline
