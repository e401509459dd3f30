// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/network_config.h"
#include "master/bus.h"
#include "protocol/coe.h"
#include "protocol/mailbox.h"

namespace syncline {

/// CoE SDO client of one slave in blocking style: expedited, normal and segmented transfers. Polls the
/// slave's mailbox through the cyclic operation that runs meanwhile.
class CoeClient {
 public:
  using EmergencyHandler = std::function<void(const coe::Emergency&)>;

  /// `counter`: the slave's mailbox counter, which outlives the client.
  CoeClient(Bus& bus, const SlaveConfig& slave, std::uint8_t& counter, EmergencyHandler on_emergency = {});

  /// Time for each answer; 0 takes the default of 2 s.
  void set_timeout_ms(std::uint32_t timeout_ms);
  /// kSdoAbort with the abort code, kMailboxTimeout, kMailboxProtocol.
  Status download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access = false);
  Result<std::vector<std::uint8_t>> upload(coe::ObjectAddress object, bool complete_access = false);

 private:
  Status write_mailbox(std::vector<std::uint8_t> coe_data);
  Result<MailboxMessage> read_mailbox();
  Status wait_until_full(Nanoseconds end);
  /// Sends a request and waits for its response; emergencies in between are handed on.
  Result<coe::Response> ask(const coe::Request& request);
  template <class Expected>
  Result<Expected> ask_for(const coe::Request& request, coe::ObjectAddress object);
  Status download_segments(coe::ObjectAddress object, std::span<const std::uint8_t> rest);
  [[nodiscard]] std::string subject(coe::ObjectAddress object) const;

  Bus& bus_;
  const SlaveConfig& slave_;
  const MailboxConfig& mailbox_;
  std::uint8_t& counter_;
  EmergencyHandler on_emergency_;
  Nanoseconds timeout_;
};

}  // namespace syncline
