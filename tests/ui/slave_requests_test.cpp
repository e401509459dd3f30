// SPDX-License-Identifier: Apache-2.0
// The way of a request from a page to the master and back, with a master that answers as the test says.
#include "ui/session/slave_requests.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/patient_master.h"
#include "support/ui_test_support.h"
#include "ui/session/live_session.h"

namespace syncline::ui {
namespace {

using requests::RegisterRead;

class RequestsOfTheWindow : public ::testing::Test {
 protected:
  RequestsOfTheWindow()
      : run_([this](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
          auto master = std::make_unique<test::PatientMaster>();
          master_ = master.get();
          return master;
        }),
        live_(run_),
        requests_(live_) {}
  ~RequestsOfTheWindow() override { live_.shutDown(); }

  void goOnline() {
    live_.setAutoAdvance(false);
    ASSERT_TRUE(live_.goOnline(QStringLiteral("sim:patient"), {}));
    live_.advance(kMillisecond);
  }
  SlaveRequests::Id ask(std::uint16_t slave, std::uint16_t address,
                        RequestUrgency urgency = RequestUrgency::kBackground) {
    return requests_.post(
        RegisterRead{slave, address, 1}, page_,
        [this, address](const RequestOutcome& outcome) { told_.emplace_back(address, outcome); }, urgency);
  }
  std::vector<RequestTicket*> taken() { return master_->taken(); }
  void answer(RequestTicket& ticket) {
    ticket.bytes.push_back(7);
    master_->channels().requests.answer(ticket, 0);
  }

  test::PatientMaster* master_ = nullptr;
  NetworkRun run_;
  LiveSession live_;
  SlaveRequests requests_;
  QObject page_;
  std::vector<std::pair<std::uint16_t, RequestOutcome>> told_;
};

TEST_F(RequestsOfTheWindow, OfflineTheySayWhatToDo) {
  ask(0, 1);
  EXPECT_TRUE(told_.empty()) << "not before post() has returned";
  ASSERT_TRUE(test::waitFor([this] { return !told_.empty(); }));
  EXPECT_EQ(told_.front().second.end, RequestEnd::kGone);
  EXPECT_TRUE(told_.front().second.why.contains(QStringLiteral("go online")));
}

TEST_F(RequestsOfTheWindow, AnswersComeOnATick) {
  goOnline();
  const auto id = ask(0, 5);
  EXPECT_TRUE(requests_.isWaiting(id));
  const auto tickets = taken();
  ASSERT_EQ(tickets.size(), 1U);
  answer(*tickets.front());
  EXPECT_TRUE(told_.empty());
  live_.advance(kMillisecond);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_TRUE(told_.front().second.ok());
  EXPECT_EQ(told_.front().second.answer.data, std::vector<std::uint8_t>{7});
  EXPECT_FALSE(requests_.isWaiting(id));
}

TEST_F(RequestsOfTheWindow, FailuresComeInWords) {
  goOnline();
  ask(0, 5);
  auto* ticket = taken().at(0);
  ticket->failure = BriefError{.code = ErrorCode::kNoResponse};
  master_->channels().requests.answer(*ticket, 0);
  live_.advance(kMillisecond);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_.front().second.end, RequestEnd::kFailed);
  EXPECT_FALSE(told_.front().second.why.isEmpty());
}

TEST_F(RequestsOfTheWindow, WhatIsBeyondItsLimitsFails) {
  goOnline();
  requests_.post(RegisterRead{0, 0, 0}, page_,
                 [this](const RequestOutcome& outcome) { told_.emplace_back(0, outcome); });
  EXPECT_TRUE(told_.empty());
  ASSERT_TRUE(test::waitFor([this] { return !told_.empty(); }));
  EXPECT_EQ(told_.front().second.end, RequestEnd::kFailed);
}

TEST_F(RequestsOfTheWindow, APersonDoesNotWaitBehindADictionary) {
  goOnline();
  for (std::uint16_t i = 0; i < 100; ++i) ask(0, i);
  for (std::uint16_t i = 100; i < 110; ++i) ask(1, i);
  ask(0, 500, RequestUrgency::kPerson);
  const auto first = taken();
  EXPECT_EQ(first.size(), RequestQueue::Room{}.per_slave + 10) << "another slave's go on";
  answer(*first.front());
  live_.advance(kMillisecond);
  const auto next = taken();
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(std::get<RegisterRead>(next.front()->request).address, 500);
}

TEST_F(RequestsOfTheWindow, AllAreCarriedOutInTheEnd) {
  goOnline();
  for (std::uint16_t i = 0; i < 200; ++i) ask(static_cast<std::uint16_t>(i % 5), i);
  for (int round = 0; round < 40 && told_.size() < 200; ++round) {
    const auto tickets = taken();
    EXPECT_LE(tickets.size(), RequestQueue::Room{}.total);
    for (auto* ticket : tickets) answer(*ticket);
    live_.advance(kMillisecond);
  }
  EXPECT_EQ(told_.size(), 200U);
  EXPECT_EQ(requests_.waiting(page_), 0U);
}

TEST_F(RequestsOfTheWindow, CancelledOnesSaySo) {
  goOnline();
  const auto given = ask(0, 1);
  for (std::uint16_t i = 0; i < RequestQueue::Room{}.per_slave; ++i) ask(0, 2);
  const auto kept = ask(0, 3);
  requests_.cancel(given);
  requests_.cancel(kept);
  auto* ticket = taken().front();
  EXPECT_TRUE(ticket->cancelled);
  ticket->failure = BriefError{.code = ErrorCode::kCancelled};
  master_->channels().requests.answer(*ticket, 0);
  live_.advance(kMillisecond);
  ASSERT_TRUE(test::waitFor([this] { return told_.size() == 2; }));
  for (const auto& [address, outcome] : told_) EXPECT_EQ(outcome.end, RequestEnd::kCancelled) << address;
}

TEST_F(RequestsOfTheWindow, WhoDropsOrGoesHearsNothing) {
  goOnline();
  ask(0, 1);
  int heard = 0;
  {
    QObject other;
    requests_.post(RegisterRead{0, 2, 1}, other, [&heard](const RequestOutcome&) { ++heard; });
  }
  requests_.drop(page_);
  EXPECT_EQ(requests_.waiting(page_), 0U);
  for (auto* ticket : taken()) answer(*ticket);
  live_.advance(kMillisecond);
  EXPECT_TRUE(told_.empty());
  EXPECT_EQ(heard, 0);
}

/// The answer is of the slave that was asked, whichever network is in work when it comes.
TEST_F(RequestsOfTheWindow, AreAnsweredAlsoWhenAnotherRunIsShown) {
  goOnline();
  ask(3, 1);
  EXPECT_FALSE(requests_.writing());
  requests_.post(requests::RegisterWrite{3, 2, {1}}, page_, [](const RequestOutcome&) {});
  EXPECT_TRUE(requests_.writing());
  NetworkRun other([](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
    return std::make_unique<test::PatientMaster>();
  });
  live_.show(other);
  EXPECT_FALSE(requests_.possible());
  for (auto* ticket : taken()) answer(*ticket);
  run_.advance(kMillisecond);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_TRUE(told_.front().second.ok());
  EXPECT_FALSE(requests_.writing());
  ask(3, 4);
  QCoreApplication::processEvents();
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_EQ(told_.back().second.end, RequestEnd::kGone) << "the one that is shown now is offline";
  live_.show(run_);
}

TEST_F(RequestsOfTheWindow, TheEndOfTheBusEndsThem) {
  goOnline();
  for (std::uint16_t i = 0; i < 20; ++i) ask(0, i);
  live_.shutDown();
  EXPECT_EQ(live_.phase(), LiveSession::Phase::kOffline);
  ASSERT_EQ(told_.size(), 20U);
  for (const auto& [address, outcome] : told_) EXPECT_EQ(outcome.end, RequestEnd::kGone) << address;
}

}  // namespace
}  // namespace syncline::ui
