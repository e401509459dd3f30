// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "support/result.h"

namespace syncline {

class MailboxClient;

/// File access over EtherCAT with one slave for those who wait: FoeWork, run to its end. The slave must be in a state
/// in which it serves files (PREOP or above; BOOT for firmware, with the mailbox of that state).
class FoeClient {
 public:
  using Progress = std::function<void(std::size_t bytes)>;
  /// A slave that sends more is refused, bytes.
  static constexpr std::size_t kLargestFile = 64U << 20;

  explicit FoeClient(MailboxClient& mailbox, Progress progress = {})
      : mailbox_(mailbox), progress_(std::move(progress)) {}

  /// kFileTransfer with the slave's FoE error, kMailboxTimeout, kMailboxProtocol.
  Result<std::vector<std::uint8_t>> read(const std::string& name, std::uint32_t password = 0);
  Status write(const std::string& name, std::span<const std::uint8_t> file, std::uint32_t password = 0);

 private:
  MailboxClient& mailbox_;
  Progress progress_;
};

}  // namespace syncline
