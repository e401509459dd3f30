// SPDX-License-Identifier: Apache-2.0
#include "ui/session/live_session.h"

#include <gtest/gtest.h>

#include <vector>

#include "channels/command_queue.h"
#include "support/patient_master.h"
#include "support/ui_test_support.h"

namespace syncline {
namespace {

TEST(LiveSession, TellsOfCommandsThatNobodyTakes) {
  ui::LiveSession live([](const QString&) -> Result<std::unique_ptr<BackgroundMaster>> {
    return std::make_unique<test::PatientMaster>();
  });
  std::vector<Error> told;
  QObject::connect(&live, &ui::LiveSession::eventArrived, &live, [&told](const Event& event) {
    if (const auto* failure = event.as<events::Failure>()) told.push_back(failure->error);
  });
  ASSERT_TRUE(live.goOnline(QStringLiteral("sim:deaf"), {}));
  live.advance(kMillisecond);
  ASSERT_EQ(live.phase(), ui::LiveSession::Phase::kOnline);
  // With the command that brought it up the queue is full.
  for (std::size_t i = 1; i < CommandQueue::kCapacity; ++i) live.requestState(AlState::kOp);
  EXPECT_TRUE(told.empty());
  live.requestState(AlState::kOp);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().code, ErrorCode::kTimeout);
}

}  // namespace
}  // namespace syncline
