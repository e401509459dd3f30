// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "check/network_view.h"
#include "config/hot_connect.h"
#include "config/network_config.h"

namespace syncline::checker {
namespace {

void check_members(const NetworkView& view, std::size_t head, Findings& findings) {
  const auto& slaves = view.config.slaves;
  const HotConnectConfig& group = *slaves[head].hot_connect;
  const ConfigPlace place{PlaceKind::kHotConnect, head};
  if (head + group.member_count > slaves.size()) {
    findings.add("ENI-HC-01", place, fig::text<"group">(group.group), fig::count<"members">(group.member_count),
                 fig::count<"left">(slaves.size() - head));
    return;
  }
  for (std::size_t i = head + 1; i < head + group.member_count; ++i) {
    if (slaves[i].hot_connect) {
      findings.add("ENI-HC-01/other", place, fig::text<"group">(group.group), fig::count<"members">(group.member_count),
                   view.slave<"slave">(i));
      return;
    }
  }
}

void check_identification(const NetworkView& view, std::size_t head, Findings& findings) {
  const HotConnectConfig& group = *view.config.slaves[head].hot_connect;
  const bool compares = std::ranges::any_of(
      group.identify_cmds, [](const InitCmd& cmd) { return cmd.validate && !cmd.validate->data.empty(); });
  if (!compares) {
    findings.add("ENI-HC-02", {PlaceKind::kHotConnect, head}, fig::text<"group">(group.group));
  }
}

}  // namespace

void check_hot_connect(const NetworkView& view, Findings& findings) {
  std::unordered_map<std::uint16_t, std::size_t> aliases;
  const auto& slaves = view.config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!slaves[i].hot_connect) continue;
    check_members(view, i, findings);
    check_identification(view, i, findings);
    const auto alias = slaves[i].hot_connect->alias();
    if (!alias) continue;
    if (const auto [it, is_new] = aliases.emplace(*alias, i); !is_new) {
      findings.add("ENI-HC-03", {PlaceKind::kHotConnect, i}, fig::number<"alias">(*alias),
                   view.slave<"slave">(it->second));
    }
  }
}

}  // namespace syncline::checker
