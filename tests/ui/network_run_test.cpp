// SPDX-License-Identifier: Apache-2.0
#include "ui/session/network_run.h"

#include <gtest/gtest.h>

#include <vector>

#include "channels/command_queue.h"
#include "support/patient_master.h"
#include "support/ui_test_support.h"

namespace syncline {
namespace {

TEST(NetworkRun, TellsOfCommandsThatNobodyTakes) {
  ui::NetworkRun run([](const QString&) -> Result<std::unique_ptr<BackgroundMaster>> {
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

}  // namespace
}  // namespace syncline
