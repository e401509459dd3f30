// SPDX-License-Identifier: Apache-2.0
#include "channels/request_desk.h"

#include <gtest/gtest.h>

#include "findings/error_text.h"

namespace syncline {
namespace {

using requests::RegisterRead;
using requests::SdoRead;

TEST(RequestDesk, EachAskerGetsHisOwnAnswerOnce) {
  RequestDesk desk;
  const auto first = desk.submit(RegisterRead{0, 0x0130, 2}), second = desk.submit(RegisterRead{1, 0x0130, 2});
  ASSERT_TRUE(first && second);
  EXPECT_FALSE(desk.take(*first)) << "it is on its way";
  auto *one = desk.pop(), *two = desk.pop();
  ASSERT_TRUE(one != nullptr && two != nullptr);
  EXPECT_EQ(desk.pop(), nullptr);
  two->bytes = {2};
  desk.answer(*two, 7);
  EXPECT_FALSE(desk.take(*first));
  one->bytes = {1};
  desk.answer(*one, 8);
  const auto of_first = desk.take(*first), of_second = desk.take(*second);
  ASSERT_TRUE(of_first && of_second);
  EXPECT_EQ(of_first->data, std::vector<std::uint8_t>{1});
  EXPECT_EQ(of_second->data, std::vector<std::uint8_t>{2});
  EXPECT_EQ(of_second->time, 7);
  EXPECT_FALSE(desk.take(*first)) << "once";
  EXPECT_EQ(desk.open(), 0U);
}

TEST(RequestDesk, TheAnswersRoomIsThereBeforeTheMasterSeesTheRequest) {
  RequestDesk desk;
  ASSERT_TRUE(desk.submit(SdoRead{0, {0x1008, 0}, false, 3000}));
  EXPECT_GE(desk.pop()->bytes.capacity(), 3000U);
}

TEST(RequestDesk, RefusesWhatIsBeyondItsLimitsInWords) {
  RequestDesk desk;
  EXPECT_FALSE(desk.submit(SdoRead{0, {0x1008, 0}, false, SdoRead::kMost + 1}));
  EXPECT_FALSE(desk.submit(RegisterRead{0, 0xFFFF, 2}));
  EXPECT_FALSE(desk.submit(RegisterRead{0, 0, 0}));
  EXPECT_FALSE(desk.submit(requests::EepromWrite{0, 4, {1, 2, 3}}));
  EXPECT_FALSE(desk.submit(requests::EepromRead{0, 0xFFFF'FFFF, 4}));
  for (std::size_t i = 0; i < RequestDesk::kCapacity; ++i) ASSERT_TRUE(desk.submit(RegisterRead{0, 0, 1}));
  const auto refused = desk.submit(RegisterRead{0, 0, 1});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().detail.text().find("wait"), std::string::npos);
  desk.answer(*desk.pop(), 0);
  EXPECT_TRUE(desk.submit(RegisterRead{0, 0, 1})) << "one has come back";
}

TEST(RequestDesk, AnAbortComesWithItsWords) {
  RequestDesk desk;
  const auto id = desk.submit(SdoRead{3, {0x6040, 1}});
  auto* ticket = desk.pop();
  ticket->failure = BriefError{.code = ErrorCode::kSdoAbort, .received = 0x06020000};
  ticket->slave = SharedText("slave 3 (drive)");
  desk.answer(*ticket, 0);
  const auto answer = desk.take(*id);
  ASSERT_TRUE(answer && answer->error);
  const auto text = describe(*answer->error);
  EXPECT_NE(text.find("slave 3 (drive), object 0x6040:01"), std::string::npos) << text;
  EXPECT_NE(text.find("does not exist"), std::string::npos) << text;
}

TEST(RequestDesk, NobodyWaitsForWhatIsForgotten) {
  RequestDesk desk;
  const auto id = desk.submit(SdoRead{0, {0x1008, 0}});
  auto* ticket = desk.pop();
  desk.forget(*id);
  EXPECT_TRUE(ticket->cancelled);
  desk.answer(*ticket, 0);
  EXPECT_FALSE(desk.take(*id));
  EXPECT_EQ(desk.open(), 0U);
}

}  // namespace
}  // namespace syncline
