// SPDX-License-Identifier: Apache-2.0
#include "compile/hot_connect_plan.h"

#include "compile/identity_cmds.h"
#include "compile/init_cmd_builder.h"
#include "config/hot_connect.h"
#include "config/project.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kIdentifyTimeoutMs = 5'000;

std::uint16_t members_from(const Project& project, std::size_t head) {
  std::size_t end = head + 1;
  while (end < project.slaves.size()) {
    const auto& previous = project.slaves[end].previous;
    if (!previous || previous->position < head || previous->position >= end) break;
    ++end;
  }
  return static_cast<std::uint16_t>(end - head);
}

}  // namespace

std::optional<HotConnectConfig> plan_hot_connect(const Project& project, std::size_t slave) {
  const auto& settings = project.slaves[slave];
  if (settings.hot_connect.empty() && !settings.optional) return std::nullopt;
  HotConnectConfig group;
  group.group = settings.hot_connect.empty() ? settings.name : settings.hot_connect;
  // An optional slave goes alone: the cable is closed behind it and the others stay.
  group.member_count = settings.hot_connect.empty() ? std::uint16_t{1} : members_from(project, slave);
  InitCmdBuilder cmds(group.identify_cmds, static_cast<std::uint16_t>(0U - slave), settings.station_address);
  if (settings.check.device_id) {
    add_device_id_check(cmds, {}, settings.device, *settings.check.device_id, kIdentifyTimeoutMs);
  } else {
    cmds.aprd({}, "check alias", reg::kStationAlias, 2)
        .answered()
        .validate(le_bytes<std::uint16_t>(settings.alias), {}, kIdentifyTimeoutMs);
  }
  return group;
}

}  // namespace syncline::compiler
