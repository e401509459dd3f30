// SPDX-License-Identifier: Apache-2.0
#include "check/check_network.h"

#include <algorithm>

#include "check/network_view.h"
#include "config/network_config.h"
#include "findings/finding_list.h"

namespace syncline {

std::span<const FindingWords> check_rules() { return words::kEni; }

void check_network(const NetworkConfig& config, FindingList& out) {
  using namespace checker;
  Findings findings(out);
  const NetworkView view(config);
  for (const auto rule :
       {check_references,    check_identities, check_hot_connect,  check_pdo_assignment, check_sync_managers,
        check_fmmus,         check_mailboxes,  check_coe,          check_coe_sizes,      check_state_requests,
        check_command_order, check_dc_slaves,  check_dc_commands,  check_frames,         check_working_counters,
        check_times,         check_image,      check_image_places, check_dialects,       check_device_families}) {
    rule(view, findings);
  }
}

std::vector<Finding> check_network(const NetworkConfig& config) {
  auto all = FindingList::unbounded();
  check_network(config, all);
  return all.take_kept();
}

}  // namespace syncline
