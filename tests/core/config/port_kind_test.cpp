// SPDX-License-Identifier: Apache-2.0
#include "config/port_kind.h"

#include <gtest/gtest.h>

#include "config/device_description.h"

namespace syncline {
namespace {

PortKind kind(const char* physics, std::uint8_t port) {
  DeviceDescription device;
  device.physics = physics;
  return port_kind(device, port);
}

TEST(PortKind, IsWhatTheLetterOfThePortSays) {
  EXPECT_EQ(kind("YKHB", 0), PortKind::kCable);
  EXPECT_EQ(kind("YKHB", 1), PortKind::kEbus);
  EXPECT_EQ(kind("YKHB", 2), PortKind::kCable);
  EXPECT_EQ(kind("YKHB", 3), PortKind::kEbus);
  EXPECT_EQ(kind("Y -X", 1), PortKind::kNone);
  EXPECT_EQ(kind("Y -X", 2), PortKind::kNone);
  EXPECT_EQ(kind("Y -X", 3), PortKind::kUnknown);
  EXPECT_EQ(kind("YY", 2), PortKind::kNone);
  EXPECT_EQ(kind("YYYYY", 4), PortKind::kNone) << "no slave has a fifth one";
}

TEST(PortKind, OfADeviceThatSaysNothingTwoPortsAreKnown) {
  for (const std::uint8_t port : {0, 1}) EXPECT_EQ(kind("", port), PortKind::kUnknown) << int{port};
  for (const std::uint8_t port : {2, 3, 4}) EXPECT_EQ(kind("", port), PortKind::kNone) << int{port};
}

TEST(PortKind, LikePortsFitAndUnknownOnesFitAll) {
  constexpr PortKind kThere[] = {PortKind::kCable, PortKind::kEbus, PortKind::kUnknown};
  for (const auto left : kThere) {
    EXPECT_FALSE(ports_fit(left, PortKind::kNone));
    EXPECT_FALSE(ports_fit(PortKind::kNone, left));
    EXPECT_TRUE(ports_fit(left, left));
    EXPECT_TRUE(ports_fit(left, PortKind::kUnknown));
    EXPECT_TRUE(ports_fit(PortKind::kUnknown, left));
  }
  EXPECT_FALSE(ports_fit(PortKind::kCable, PortKind::kEbus));
  EXPECT_FALSE(ports_fit(PortKind::kNone, PortKind::kNone));
}

}  // namespace
}  // namespace syncline
