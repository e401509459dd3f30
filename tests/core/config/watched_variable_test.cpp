// SPDX-License-Identifier: Apache-2.0
#include "config/watched_variable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "config/network_config.h"
#include "config/process_image.h"

namespace syncline {
namespace {

using testing::HasSubstr;

WatchedVariable typed(std::string type, std::uint32_t bits) { return {"v", std::move(type), false, 0, bits, -1}; }

TEST(WatchedNumbers, AreThoseOfTheTypeUpToItsLimits) {
  EXPECT_EQ(watched_number(typed("BOOL", 1), 1), WatchedNumber(std::uint64_t{1}));
  EXPECT_EQ(watched_number(typed("BIT3", 3), 5), WatchedNumber(std::uint64_t{5}));
  EXPECT_EQ(watched_number(typed("SINT", 8), 0x80), WatchedNumber(std::int64_t{-128}));
  EXPECT_EQ(watched_number(typed("SINT", 8), 0x7F), WatchedNumber(std::int64_t{127}));
  EXPECT_EQ(watched_number(typed("INT", 16), 0x8000), WatchedNumber(std::int64_t{-32768}));
  EXPECT_EQ(watched_number(typed("UINT", 16), 0xFFFF), WatchedNumber(std::uint64_t{65535}));
  EXPECT_EQ(watched_number(typed("DINT", 32), 0x8000'0000), WatchedNumber(std::int64_t{INT32_MIN}));
  EXPECT_EQ(watched_number(typed("UDINT", 32), 0xFFFF'FFFF), WatchedNumber(std::uint64_t{UINT32_MAX}));
  EXPECT_EQ(watched_number(typed("LINT", 64), std::uint64_t{1} << 63), WatchedNumber(INT64_MIN));
  EXPECT_EQ(watched_number(typed("ULINT", 64), UINT64_MAX), WatchedNumber(UINT64_MAX));
  constexpr auto kLargest = std::numeric_limits<float>::max();
  EXPECT_EQ(watched_number(typed("REAL", 32), std::bit_cast<std::uint32_t>(-kLargest)), WatchedNumber(-kLargest));
  EXPECT_EQ(watched_number(typed("LREAL", 64), std::bit_cast<std::uint64_t>(-1e300)), WatchedNumber(-1e300));
  EXPECT_TRUE(std::isnan(watched_value(typed("REAL", 32), 0x7FC0'0000)));
}

TEST(WatchedNumbers, OfATypeThatIsNotAsLongAreUnsigned) {
  EXPECT_EQ(watched_number(typed("INT", 12), 0xFFF), WatchedNumber(std::uint64_t{0xFFF}));
  EXPECT_EQ(watched_number(typed("DT1234", 4), 0xF), WatchedNumber(std::uint64_t{0xF}));
  EXPECT_EQ(watched_number(typed("STRING(2)", 16), 0x4241), WatchedNumber(std::uint64_t{0x4241}));
}

NetworkConfig machine() {
  NetworkConfig config;
  config.slaves.resize(3);
  config.slaves[0].name = "Box 1.2";
  config.slaves[1].name = "Servo";
  config.slaves[2].name = "Servo B";
  config.slaves[0].send = ImageRange{0, 16};
  config.slaves[1].receive = ImageRange{0, 64};
  config.slaves[2].receive = ImageRange{64, 32};
  config.image.input_bytes = 40;
  config.image.output_bytes = 2;
  config.image.inputs = {{"Servo.Inputs.Position actual value", "DINT", "", 32, 0},
                         {"Servo.Inputs.Velocity", "DINT", "", 32, 32},
                         {"Servo B.Inputs.Velocity", "DINT", "", 32, 64},
                         {"Serial number", "STRING(20)", "", 160, 96}};
  config.image.outputs = {{"Box 1.2.Out.Lamp", "BOOL", "", 1, 3}};
  return config;
}

TEST(WatchableVariables, AreThoseOfOneTo64BitsWithTheirSlaves) {
  const auto all = watchable_variables(machine());
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0], (WatchedVariable{"Servo.Inputs.Position actual value", "DINT", false, 0, 32, 1}));
  EXPECT_EQ(all[2].slave, 2);
  EXPECT_EQ(all[3], (WatchedVariable{"Box 1.2.Out.Lamp", "BOOL", true, 3, 1, 0}));
}

TEST(WatchableVariables, AreFoundByNameOrBySlaveAndEntry) {
  const auto config = machine();
  const auto name = [&](std::string_view text) {
    const auto found = find_watchable(config, text);
    return found ? found->name : "error: " + found.error().detail.text();
  };
  EXPECT_EQ(name("Servo.Inputs.Velocity"), "Servo.Inputs.Velocity");
  EXPECT_EQ(name("1.Position actual value"), "Servo.Inputs.Position actual value");
  EXPECT_EQ(name("servo.velocity"), "Servo.Inputs.Velocity");
  EXPECT_EQ(name("2.Velocity"), "Servo B.Inputs.Velocity");
  EXPECT_EQ(name("Box 1.2.Lamp"), "Box 1.2.Out.Lamp") << "a slave with a dot in its name";
  EXPECT_EQ(name("SERVO.INPUTS.VELOCITY"), "Servo.Inputs.Velocity");
  EXPECT_THAT(name("1.ocity"), HasSubstr("no such variable")) << "no part of a word";
  EXPECT_THAT(name("Serial number"), HasSubstr("no such variable")) << "too wide";
  EXPECT_THAT(name(""), HasSubstr("no such variable"));
  EXPECT_THAT(name("4.Velocity"), HasSubstr("no such variable"));
}

TEST(WatchableVariables, SeveralAreNamedWhereATextCouldMeanThem) {
  auto config = machine();
  config.image.inputs.push_back({"Servo.More.Velocity", "DINT", "", 32, 0});
  const auto found = find_watchable(config, "1.Velocity");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kBadValue);
  EXPECT_THAT(found.error().detail.text(), HasSubstr("\"Servo.Inputs.Velocity\", \"Servo.More.Velocity\""));
}

}  // namespace
}  // namespace syncline
