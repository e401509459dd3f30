// SPDX-License-Identifier: Apache-2.0
#include "ui/session/network_run.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "channels/command_queue.h"
#include "support/patient_master.h"
#include "support/ui_test_support.h"

namespace syncline {
namespace {

TEST(NetworkRun, TellsOfCommandsThatNobodyTakes) {
  ui::NetworkRun run([](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
    return std::make_unique<test::PatientMaster>();
  });
  std::vector<Error> told;
  QObject::connect(&run, &ui::NetworkRun::eventArrived, &run, [&told](const Event& event) {
    if (const auto* failure = event.as<events::Failure>()) told.push_back(failure->error);
  });
  ASSERT_TRUE(run.goOnline(QStringLiteral("sim:deaf"), {}));
  run.advance(kMillisecond);
  ASSERT_EQ(run.phase(), ui::NetworkRun::Phase::kOnline);
  // With the command that brought it up the queue is full.
  for (std::size_t i = 1; i < CommandQueue::kCapacity; ++i) run.requestState(AlState::kOp);
  EXPECT_TRUE(told.empty());
  run.requestState(AlState::kOp);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().code, ErrorCode::kTimeout);
}

class AppliedRun : public testing::Test {
 protected:
  AppliedRun()
      : run_([this](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
          auto master = std::make_unique<test::PatientMaster>();
          master_ = master.get();
          return master;
        }) {
    QObject::connect(&run_, &ui::NetworkRun::applied, &run_, [this] { ++applied_; });
    EXPECT_TRUE(run_.goOnline(QStringLiteral("sim:slow"), {.project = named("before"), .path = {}, .config = {}}));
    run_.advance(kMillisecond);
  }
  static Project named(const char* name) {
    Project project;
    project.name = name;
    return project;
  }
  void apply(const char* name) { run_.apply({.project = named(name), .path = {}, .config = {}}); }
  /// Answers what the master was asked; how many.
  int answer(const std::optional<Error>& refused) {
    int asked = 0;
    auto& commands = master_->channels().commands;
    while (const auto entry = commands.pop()) {
      commands.answer(entry->id, refused, kMillisecond);
      asked += entry->id != 0 ? 1 : 0;
    }
    run_.advance(kMillisecond);
    return asked;
  }

  test::PatientMaster* master_ = nullptr;
  ui::NetworkRun run_;
  int applied_ = 0;
};

TEST_F(AppliedRun, IsWhatRunsWhenTheMasterHasTakenIt) {
  apply("after");
  EXPECT_TRUE(run_.applying());
  apply("too early");
  EXPECT_EQ(run_.origin().project.name, "before");
  EXPECT_EQ(answer({}), 1) << "one is under way, the next is not given";
  EXPECT_FALSE(run_.applying());
  EXPECT_EQ(run_.origin().project.name, "after");
  EXPECT_EQ(applied_, 1);
}

TEST_F(AppliedRun, IsNotWhatRunsWhenTheMasterRefuses) {
  apply("after");
  EXPECT_EQ(answer(Error{ErrorCode::kBadValue, "gain", {}}), 1);
  EXPECT_FALSE(run_.applying());
  EXPECT_EQ(run_.origin().project.name, "before");
  EXPECT_EQ(applied_, 0);
  apply("again");
  EXPECT_EQ(answer({}), 1);
  EXPECT_EQ(run_.origin().project.name, "again");
}

TEST_F(AppliedRun, EndsWithItsMaster) {
  apply("after");
  run_.shutDown();
  EXPECT_FALSE(run_.applying());
  EXPECT_EQ(run_.origin().project.name, "before");
}

}  // namespace
}  // namespace syncline
