// SPDX-License-Identifier: Apache-2.0
#include "config/compile/hot_connect_plan.h"

#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kIdentifyTimeoutMs = 5'000;
constexpr std::uint32_t kIdentifyRetries = 3;

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
  if (settings.hot_connect.empty()) return std::nullopt;
  HotConnectConfig group;
  group.group = settings.hot_connect;
  group.member_count = members_from(project, slave);
  InitCmd identify;
  identify.comment = "check alias";
  identify.command = Command::kAprd;
  identify.adp = static_cast<std::uint16_t>(0U - slave);
  identify.ado = reg::kStationAlias;
  identify.data = {0, 0};
  identify.expected_wkc = 1;
  identify.retries = kIdentifyRetries;
  identify.validate = InitCmdValidate{le_bytes<std::uint16_t>(settings.alias), {}, kIdentifyTimeoutMs};
  group.identify_cmds.push_back(std::move(identify));
  return group;
}

}  // namespace syncline::compiler
