// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

TEST(CliSync, ShowsTheSynchronisationObjectsByName) {
  const auto servo = cli_run({"sync", demo(), "3"});
  ASSERT_EQ(servo.code, cli::kDone) << servo.err;
  EXPECT_THAT(servo.out, HasSubstr("0x1C32     SM output parameter"));
  EXPECT_THAT(servo.out, HasSubstr(":0C SM event missed counter"));
  EXPECT_THAT(servo.out, HasSubstr("free run, SYNC0"));
  EXPECT_THAT(servo.out, HasSubstr("62500 ns"));
  EXPECT_THAT(servo.out, HasSubstr("the slave names its counters"));
  const auto coupler = cli_run({"sync", demo(), "0"});
  EXPECT_NE(coupler.code, cli::kUsage);
}

TEST(CliSync, JsonSaysWhatEachValueMeansWhereverTheVendorKeepsIt) {
  for (const auto& [position, place] : std::map<std::string, int>{{"3", 0x0C}, {"5", 0x0B}}) {
    const auto report = cli_run({"sync", demo(), position, "--json"}).json();
    ASSERT_EQ(report["objects"].size(), 2U);
    EXPECT_EQ(report["objects"][1]["index"], "0x1c33");
    EXPECT_EQ(report["objects"][0]["counter_source"], "object_name");
    int found = 0;
    for (const auto& entry : report["objects"][0]["entries"]) {
      if (entry["meaning"] == "sm_event_missed") {
        ++found;
        EXPECT_EQ(entry["sub_index"], place);
      }
    }
    EXPECT_EQ(found, 1);
  }
}

TEST(CliSync, DecodesTheStatusObjectsOfDeviceFamilies) {
  const auto drive = cli_run({"sync", demo(), "5"});
  EXPECT_THAT(drive.out, HasSubstr("0x21B4     Network status register 0x0000"));
  EXPECT_THAT(drive.out, HasSubstr(".0  ! SYNC0 is off"));
  const auto report = cli_run({"sync", demo(), "5", "--json"}).json();
  EXPECT_EQ(report["family"]["id"], "sl-xe2");
  ASSERT_EQ(report["family"]["bits"].size(), 4U);
  EXPECT_EQ(report["family"]["bits"][3]["as_wanted"], true);
  EXPECT_EQ(cli_run({"sync", demo(), "3", "--json"}).json()["family"]["status"], nullptr);
}

}  // namespace
}  // namespace syncline::test
