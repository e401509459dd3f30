// SPDX-License-Identifier: Apache-2.0
#include "config/hot_connect.h"

#include <gtest/gtest.h>

#include "config/hot_connect_groups.h"
#include "config/network_config.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

InitCmd validated(std::uint16_t ado, std::vector<std::uint8_t> data) {
  InitCmd command;
  command.ado = ado;
  command.validate.emplace().data = std::move(data);
  return command;
}

TEST(HotConnectGroup, IsKnownByTheAliasThatItsCommandsCompare) {
  HotConnectConfig group;
  EXPECT_FALSE(group.alias());
  group.identify_cmds = {validated(reg::kAlStatus, {1, 2}), validated(reg::kStationAlias, {0x34, 0x12})};
  EXPECT_EQ(group.alias(), 0x1234);
  group.identify_cmds[1].validate->data = {0x34};
  EXPECT_FALSE(group.alias()) << "half of one";
  group.identify_cmds[1].validate.reset();
  EXPECT_FALSE(group.alias()) << "it is read and not compared";
}

TEST(HotConnectGroup, HoldsSoManySlavesUnlessAnotherOneBeginsBefore) {
  NetworkConfig config;
  config.slaves.resize(9);
  const auto begins = [&config](std::size_t slave, std::uint16_t members) {
    config.slaves[slave].hot_connect.emplace().member_count = members;
  };
  begins(1, 3);
  begins(5, 3);
  begins(6, 1);
  using Head = std::optional<std::size_t>;
  const std::vector<Head> heads{{}, 1, 1, 1, {}, 5, 6, {}, {}};
  EXPECT_EQ(hot_connect_heads(config.slaves), heads);
  for (std::size_t slave = 0; slave < heads.size(); ++slave)
    EXPECT_EQ(config.hot_connect_head(slave), heads[slave]) << slave;
}

}  // namespace
}  // namespace syncline
