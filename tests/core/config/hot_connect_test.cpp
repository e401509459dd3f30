// SPDX-License-Identifier: Apache-2.0
#include "config/hot_connect.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace syncline
