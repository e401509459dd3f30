// SPDX-License-Identifier: Apache-2.0
#include "config/dotted_address.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(DottedAddress, IsSoManyNumbersWithDots) {
  EXPECT_EQ(ipv4_bytes("192.168.0.255"), (std::array<std::uint8_t, 4>{192, 168, 0, 255}));
  EXPECT_EQ(ams_net_id_bytes("5.23.1.9.1.1"), (std::array<std::uint8_t, 6>{5, 23, 1, 9, 1, 1}));
}

TEST(DottedAddress, IsNothingElse) {
  for (const char* text : {"", "192.168.0", "192.168.0.", "192.168.0.256", "192.168.0.1.", "192.168.0.1 ",
                           "192.168.0.1.2", ".168.0.1", "192,168.0.1", "192.168.0.-1", "a.b.c.d", "192.168..1"}) {
    EXPECT_FALSE(ipv4_bytes(text)) << text;
  }
  for (const char* text : {"5.23.1.9.1", "5.23.1.9.1.1.1", "5.23.1.9.1.300", "192.168.0.1"}) {
    EXPECT_FALSE(ams_net_id_bytes(text)) << text;
  }
}

}  // namespace
}  // namespace syncline
