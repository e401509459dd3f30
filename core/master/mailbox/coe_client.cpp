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

Result<std::optional<std::uint32_t>> CoeClient::upload_number(coe::ObjectAddress object) {
  const auto bytes = upload(object);
  if (!bytes && bytes.error().code == ErrorCode::kSdoAbort) return std::optional<std::uint32_t>{};
  if (!bytes) return tl::unexpected(bytes.error());
  if (bytes->empty() || bytes->size() > 4) return std::optional<std::uint32_t>{};
  std::uint32_t value = 0;
  for (std::size_t i = bytes->size(); i-- > 0;) value = value << 8 | (*bytes)[i];
  return std::optional(value);
}

}  // namespace syncline
