// SPDX-License-Identifier: Apache-2.0
#include "support/shared_epoch.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "support/calendar_stamp.h"
#include "support/clock.h"

namespace syncline {
namespace {

class SharedEpochTest : public ::testing::Test {
 protected:
  SharedEpochTest() {
    std::string folder = "/tmp/syncline-epoch-XXXXXX";
    path_ = std::string(::mkdtemp(folder.data())) + "/epoch";
  }
  ~SharedEpochTest() override {
    std::remove(path_.c_str());
    ::rmdir(path_.substr(0, path_.rfind('/')).c_str());
  }
  static std::function<Nanoseconds()> says(Nanoseconds shift) {
    return [shift] { return shift; };
  }
  std::string path_;
};

TEST_F(SharedEpochTest, WhoComesLaterTakesWhatHoldsWhateverTheCalendarSaysNow) {
  std::optional<SharedEpoch> first(std::in_place, path_, says(5 * kSecond));
  EXPECT_TRUE(first->shared());
  EXPECT_EQ(first->shift(), 5 * kSecond);
  std::optional<SharedEpoch> second(std::in_place, path_, says(3'605 * kSecond));
  EXPECT_EQ(second->shift(), 5 * kSecond) << "the calendar was set an hour on in between";
  first.reset();
  const SharedEpoch third(path_, says(9));
  EXPECT_EQ(third.shift(), 5 * kSecond) << "the one that said it has gone, another one still lives by it";
}

TEST_F(SharedEpochTest, WhenNobodyIsLeftTheCalendarCountsAgain) {
  EXPECT_EQ(SharedEpoch(path_, says(5)).shift(), 5);
  EXPECT_EQ(SharedEpoch(path_, says(7)).shift(), 7);
}

TEST_F(SharedEpochTest, HoldsBetweenProcesses) {
  const SharedEpoch mine(path_, says(42));
  const auto child = ::fork();
  if (child == 0) ::_exit(SharedEpoch(path_, says(77)).shift() == 42 ? 0 : 1);
  int status = 1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST_F(SharedEpochTest, AFileThatIsNoneOrCannotBeWrittenLeavesTheOwnReading) {
  const SharedEpoch nowhere("/nonexistent/folder/epoch", says(11));
  EXPECT_FALSE(nowhere.shared());
  EXPECT_EQ(nowhere.shift(), 11);
  std::ofstream(path_) << "rubbish";
  EXPECT_EQ(SharedEpoch(path_, says(12)).shift(), 12) << "written anew";
}

TEST(CalendarShift, IsTheSameWithinTheReadingsOfTwoClocks) {
  const auto first = calendar_shift();
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(static_cast<double>(calendar_shift() - first), 0, 2'000);
}

}  // namespace
}  // namespace syncline
