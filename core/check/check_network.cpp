// SPDX-License-Identifier: Apache-2.0
#include "check/check_network.h"

#include <algorithm>

#include "check/network_view.h"

namespace syncline {

int ConfigPlace::slave() const {
  switch (kind) {
    case PlaceKind::kSlave:
    case PlaceKind::kSlaveInitCmd:
    case PlaceKind::kSyncManager:
    case PlaceKind::kPdo:
    case PlaceKind::kMailbox:
    case PlaceKind::kCoeCmd:
    case PlaceKind::kHotConnect:
    case PlaceKind::kDc:
      return static_cast<int>(first);
    default:
      return -1;
  }
}

std::vector<CheckFinding> check_network(const NetworkConfig& config) {
  using namespace checker;
  std::vector<CheckFinding> out;
  Findings findings(out);
  const NetworkView view(config);
  for (const auto rule :
       {check_references,    check_identities, check_hot_connect,  check_pdo_assignment, check_sync_managers,
        check_fmmus,         check_mailboxes,  check_coe,          check_coe_sizes,      check_state_requests,
        check_command_order, check_dc_slaves,  check_dc_commands,  check_frames,         check_working_counters,
        check_times,         check_image,      check_image_places, check_dialects,       check_device_families}) {
    rule(view, findings);
  }
  return out;
}

}  // namespace syncline
