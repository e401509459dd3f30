// SPDX-License-Identifier: Apache-2.0
#include "record/request_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

using requests::RegisterRead;
using testing::ElementsAre;
using testing::IsEmpty;

/// A queue in front of a desk behind which the test is the master.
class QueueAtADesk : public testing::Test {
 protected:
  void post(RequestQueue::Id id, std::uint16_t slave, RequestUrgency urgency = RequestUrgency::kBackground) {
    queue_.post(id, RegisterRead{slave, static_cast<std::uint16_t>(id), 1}, urgency);
  }
  std::vector<RequestTicket*> with_master() {
    std::vector<RequestTicket*> tickets;
    while (auto* ticket = desk_.pop()) tickets.push_back(ticket);
    return tickets;
  }
  void answer(RequestTicket& ticket) {
    ticket.bytes = {7};
    desk_.answer(ticket, 1);
  }
  void refuse(RequestTicket& ticket, ErrorCode code) {
    ticket.failure = BriefError{.code = code};
    desk_.answer(ticket, 1);
  }
  std::vector<std::pair<RequestQueue::Id, RequestEnd>> ends(RequestDesk* desk) {
    std::vector<std::pair<RequestQueue::Id, RequestEnd>> all;
    for (const auto& ended : queue_.take_ended(desk)) all.emplace_back(ended.id, ended.end);
    return all;
  }

  RequestDesk desk_;
  RequestQueue queue_;
};

TEST_F(QueueAtADesk, MoreThanADeskTakesAreAllAnsweredOnce) {
  constexpr std::size_t kMany = 3 * RequestDesk::kCapacity;
  for (std::size_t i = 0; i < kMany; ++i) post(i, static_cast<std::uint16_t>(i % 5));
  queue_.submit(desk_);
  std::vector<int> answered(kMany);
  for (int round = 0; round < 20; ++round) {
    const auto tickets = with_master();
    EXPECT_LE(tickets.size(), RequestQueue::Room{}.total);
    for (auto* ticket : tickets) answer(*ticket);
    for (const auto& ended : queue_.take_ended(&desk_)) {
      EXPECT_EQ(ended.end, RequestEnd::kAnswered);
      EXPECT_EQ(ended.answer.data, std::vector<std::uint8_t>{7});
      ++answered[ended.id];
    }
  }
  EXPECT_EQ(answered, std::vector<int>(kMany, 1));
  EXPECT_EQ(queue_.waiting(), 0U);
}

TEST_F(QueueAtADesk, APersonComesFirstAndOneSlaveHoldsUpNoOther) {
  const auto of_one = RequestQueue::Room{}.per_slave;
  for (std::size_t i = 0; i < 100; ++i) post(i, 0);
  post(100, 1);
  queue_.submit(desk_);
  const auto first = with_master();
  EXPECT_EQ(first.size(), of_one + 1);
  post(101, 0, RequestUrgency::kPerson);
  answer(*first.front());
  EXPECT_THAT(ends(&desk_), ElementsAre(std::pair(RequestQueue::Id{0}, RequestEnd::kAnswered)));
  const auto next = with_master();
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(std::get<RegisterRead>(next.front()->request).address, 101);
}

TEST_F(QueueAtADesk, EachEndSaysWhoseItIs) {
  for (RequestQueue::Id id = 1; id <= 4; ++id) post(id, 0);
  queue_.submit(desk_);
  auto tickets = with_master();
  ASSERT_EQ(tickets.size(), 4U);
  queue_.cancel(2, &desk_);
  EXPECT_TRUE(tickets[1]->cancelled);
  refuse(*tickets[0], ErrorCode::kNoResponse);
  refuse(*tickets[1], ErrorCode::kCancelled);
  refuse(*tickets[2], ErrorCode::kCancelled);  // by the master, which goes offline
  EXPECT_THAT(ends(&desk_), ElementsAre(std::pair(RequestQueue::Id{1}, RequestEnd::kFailed),
                                        std::pair(RequestQueue::Id{2}, RequestEnd::kCancelled),
                                        std::pair(RequestQueue::Id{3}, RequestEnd::kGone)));
  queue_.end_all();
  EXPECT_THAT(ends(nullptr), ElementsAre(std::pair(RequestQueue::Id{4}, RequestEnd::kGone)));
  EXPECT_THAT(ends(nullptr), IsEmpty()) << "once";
}

TEST_F(QueueAtADesk, WhatTheDeskHasNotGotEndsAtOnce) {
  post(1, 0);
  queue_.post(2, RegisterRead{0, 0, 0});  // no bytes: beyond its limits
  queue_.cancel(1, &desk_);
  EXPECT_TRUE(queue_.has_ended());
  queue_.submit(desk_);
  EXPECT_THAT(with_master(), IsEmpty());
  EXPECT_THAT(ends(&desk_), ElementsAre(std::pair(RequestQueue::Id{1}, RequestEnd::kCancelled),
                                        std::pair(RequestQueue::Id{2}, RequestEnd::kFailed)));
}

TEST_F(QueueAtADesk, OfTheForgottenNobodyHearsAndTheirPlaceIsFree) {
  const auto of_one = RequestQueue::Room{}.per_slave;
  for (std::size_t i = 0; i <= of_one; ++i) post(i, 0);
  queue_.submit(desk_);
  auto tickets = with_master();
  ASSERT_EQ(tickets.size(), of_one);
  queue_.forget(0, &desk_);
  EXPECT_TRUE(tickets[0]->cancelled);
  answer(*tickets[0]);
  EXPECT_THAT(ends(&desk_), IsEmpty());
  EXPECT_EQ(with_master().size(), 1U) << "the last one has its place";
}

}  // namespace
}  // namespace syncline
