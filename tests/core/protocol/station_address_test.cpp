// SPDX-License-Identifier: Apache-2.0
#include "protocol/station_address.h"

#include <gtest/gtest.h>

#include "protocol/station_alias.h"

namespace syncline {
namespace {

TEST(StationAddress, CountsAsOtherToolsDo) {
  EXPECT_EQ(usual_station_address(0), 1001);
  EXPECT_EQ(usual_station_address(41), 1042);
}

TEST(StationAlias, IsListenedToByBit24OfDlControl) {
  EXPECT_TRUE(listens_to_alias(0x01));
  EXPECT_TRUE(listens_to_alias(0xFF));
  EXPECT_FALSE(listens_to_alias(0xFE));
}

}  // namespace
}  // namespace syncline
