// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/foe_client.h"

#include "master/mailbox/foe_work.h"
#include "master/mailbox/mailbox_client.h"

namespace syncline {

Result<std::vector<std::uint8_t>> FoeClient::read(const std::string& name, std::uint32_t password) {
  std::vector<std::uint8_t> file;
  FoeWork work(mailbox_.mailbox());
  work.set_progress(progress_);
  work.read(name, password, file, kLargestFile);
  if (auto status = mailbox_.run(work); !status) return tl::unexpected(status.error());
  return file;
}

Status FoeClient::write(const std::string& name, std::span<const std::uint8_t> file, std::uint32_t password) {
  FoeWork work(mailbox_.mailbox());
  work.set_progress(progress_);
  work.write(name, password, file);
  return mailbox_.run(work);
}

}  // namespace syncline
