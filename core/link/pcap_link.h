// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "link/link.h"

namespace syncline {

class Clock;

struct AdapterInfo {
  std::string name;  // "eth0"
  std::string description;
  std::string driver;  // "" when unknown
  MacAddress mac{};
  bool up = false;  // interface up and carrier present
};

/// Network adapters that can carry EtherCAT (Ethernet, not loopback), by name.
[[nodiscard]] Result<std::vector<AdapterInfo>> list_adapters();

/// What the user has to type to let this very binary open network cards and run in real time.
[[nodiscard]] std::string permission_command();

/// kLinkNotFound, kLinkDown, or kLinkPermission with the exact setcap command for this binary in detail.
[[nodiscard]] Result<std::unique_ptr<Link>> open_pcap_link(const std::string& adapter, Clock& clock);

}  // namespace syncline
