// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/acyclic_requests.h"

#include <gtest/gtest.h>

#include <functional>

#include "channels/master_channels.h"
#include "master/exchange/run_state.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Messages = std::vector<MailboxMessage>;
using requests::SdoRead;
using requests::SdoWrite;

Messages value(coe::ObjectAddress object, std::uint8_t byte) {
  return {coe_message(coe::UploadResponse{object, false, true, 1, {byte}})};
}

/// Requests on one slave that is nothing but a mailbox, whose answers are the test's.
class AcyclicRequestsTest : public ::testing::Test {
 protected:
  AcyclicRequestsTest() {
    config.slaves.resize(1);
    auto& slave = config.slaves.front();
    slave.name = "drive";
    slave.station_address = MailboxSlave::kStation;
    slave.mailbox.emplace();
    slave.mailbox->send = {MailboxSlave::kSend, 128};
    slave.mailbox->receive = {MailboxSlave::kReceive, 128};
    slave.mailbox->coe = slave.mailbox->foe = true;
    run = std::make_unique<RunState>(config, channels);
    run->snapshot.slaves.front().present = true;
    run->snapshot.slaves.front().al_status = static_cast<std::uint16_t>(AlState::kOp);
    requests = std::make_unique<AcyclicRequests>(config, run->snapshot, run->mailboxes, channels.requests);
  }
  RequestId submit(SlaveRequest request) {
    const auto id = channels.requests.submit(std::move(request));
    EXPECT_TRUE(id);
    return id.value_or(0);
  }
  SlaveAnswer wait_for(RequestId id) {
    const auto end = bed.clock.now() + 10 * kSecond;
    while (bed.clock.now() < end) {
      const auto sent = requests->run_round(*bed.bus);
      EXPECT_TRUE(sent);
      if (auto answer = channels.requests.take(id)) return std::move(*answer);
      bed.clock.advance_to(bed.clock.now() + kMillisecond);
    }
    ADD_FAILURE() << "no answer";
    return {};
  }
  /// The object of a request, whatever of it this is.
  static coe::ObjectAddress object_of(const MailboxMessage& message) {
    const auto request = coe::decode_request(message.data);
    const auto* upload = request ? std::get_if<coe::UploadRequest>(&*request) : nullptr;
    return upload == nullptr ? coe::ObjectAddress{} : upload->object;
  }

  MailboxBed bed;
  NetworkConfig config;
  MasterChannels channels;
  std::unique_ptr<RunState> run;
  std::unique_ptr<AcyclicRequests> requests;
};

TEST_F(AcyclicRequestsTest, ASlaveThatNeverAnswersIsGivenUpInItsTime) {
  bed.slave->handler = [](const MailboxMessage&) { return Messages{}; };
  const auto answer = wait_for(submit(SdoRead{0, {0x1018, 1}}));
  ASSERT_TRUE(answer.error);
  EXPECT_EQ(answer.error->code, ErrorCode::kMailboxTimeout);
  EXPECT_EQ(answer.error->subject, "slave 0 (drive), object 0x1018:01");
  EXPECT_LT(bed.elapsed(), 4 * kSecond);
}

TEST_F(AcyclicRequestsTest, ALateAnswerIsNobodyElses) {
  Messages late;
  bed.slave->handler = [&](const MailboxMessage& message) {
    const auto object = object_of(message);
    if (object.index == 0x1018) {
      late = value(object, 1);
      return Messages{};
    }
    auto answers = late;
    late.clear();
    for (auto& answer : value(object, 2)) answers.push_back(std::move(answer));
    return answers;
  };
  const auto first = wait_for(submit(SdoRead{0, {0x1018, 1}}));
  EXPECT_TRUE(first.error);
  const auto second = wait_for(submit(SdoRead{0, {0x1000, 0}}));
  EXPECT_EQ(second.data, Bytes{2});
}

TEST_F(AcyclicRequestsTest, ALateAbortIsNobodyElses) {
  bed.slave->handler = [&](const MailboxMessage& message) {
    auto answers = Messages{coe_message(coe::Abort{{0x2000, 1}, 0x06090011})};
    for (auto& answer : value(object_of(message), 7)) answers.push_back(std::move(answer));
    return answers;
  };
  EXPECT_EQ(wait_for(submit(SdoRead{0, {0x1018, 1}})).data, Bytes{7});
}

TEST_F(AcyclicRequestsTest, ASlaveThatCountsWronglyIsUnderstood) {
  for (const std::uint8_t counter : {3, 7}) {  // the same one again and again
    bed.slave->handler = [&](const MailboxMessage& message) {
      auto answers = value(object_of(message), counter);
      answers.front().counter = counter;
      return answers;
    };
    run->mailboxes.front().restart();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(wait_for(submit(SdoRead{0, {0x1018, 1}})).data, Bytes{counter});
  }
}

TEST_F(AcyclicRequestsTest, AnAbortKeepsItsCode) {
  bed.slave->handler = [](const MailboxMessage&) { return Messages{coe_message(coe::Abort{{0x6040, 0}, 0x08000022})}; };
  const auto answer = wait_for(submit(SdoWrite{0, {0x6040, 0}, {1, 2}}));
  ASSERT_TRUE(answer.error);
  EXPECT_EQ(answer.error->code, ErrorCode::kSdoAbort);
  EXPECT_EQ(answer.error->received, 0x08000022);
}

TEST_F(AcyclicRequestsTest, AnEmergencyInBetweenIsToldAndIsNoAnswer) {
  bed.slave->handler = [](const MailboxMessage& message) {
    Messages answers{coe_message(coe::Emergency{0x8700, 1, {}})};
    for (auto& answer : value(object_of(message), 9)) answers.push_back(std::move(answer));
    return answers;
  };
  EXPECT_EQ(wait_for(submit(SdoRead{0, {0x1018, 1}})).data, Bytes{9});
  const auto events = channels.events.drain();
  ASSERT_EQ(events.size(), 1U);
  ASSERT_TRUE(events.front().is<events::Emergency>());
  EXPECT_EQ(events.front().as<events::Emergency>()->error_code, 0x8700);
}

/// A download that is refused in its middle ends on the slave's side, too, so that the next one finds it ready.
TEST_F(AcyclicRequestsTest, AWrongToggleBitIsAborted) {
  std::optional<coe::Abort> aborted;
  bed.slave->handler = [&](const MailboxMessage& message) -> Messages {
    const auto request = *coe::decode_request(message.data);
    if (const auto* abort = std::get_if<coe::Abort>(&request)) {
      aborted = *abort;
      return {};
    }
    if (std::holds_alternative<coe::DownloadRequest>(request)) return {coe_message(coe::DownloadResponse{{0x2000, 1}})};
    return {coe_message(coe::DownloadSegmentResponse{true})};
  };
  const auto answer = wait_for(submit(SdoWrite{0, {0x2000, 1}, Bytes(300, 1)}));
  ASSERT_TRUE(answer.error);
  ASSERT_TRUE(aborted);
  EXPECT_EQ(aborted->code, 0x05030000U);
  EXPECT_EQ(aborted->object, (coe::ObjectAddress{0x2000, 1}));
}

TEST_F(AcyclicRequestsTest, TwoUsersOfOneMailboxTakeTurns) {
  std::vector<coe::ObjectAddress> order;
  bed.slave->handler = [&](const MailboxMessage& message) {
    order.push_back(object_of(message));
    return value(order.back(), order.back().sub_index);
  };
  std::vector<RequestId> ids;
  for (std::uint8_t sub = 1; sub <= 6; ++sub) ids.push_back(submit(SdoRead{0, {0x2000, sub}}));
  for (std::uint8_t sub = 6; sub >= 1; --sub) EXPECT_EQ(wait_for(ids[sub - 1U]).data, Bytes{sub});
  ASSERT_EQ(order.size(), 6U);
  for (std::uint8_t sub = 1; sub <= 6; ++sub) EXPECT_EQ(order[sub - 1U].sub_index, sub);
}

TEST_F(AcyclicRequestsTest, WhatIsReservedIsLeftAlone) {
  bed.slave->handler = [&](const MailboxMessage& message) { return value(object_of(message), 1); };
  ++run->mailboxes.front().reserved;
  const auto id = submit(SdoRead{0, {0x1018, 1}});
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(requests->run_round(*bed.bus).value());
  EXPECT_EQ(bed.slave->requests, 0U);
  --run->mailboxes.front().reserved;
  EXPECT_EQ(wait_for(id).data, Bytes{1});
}

TEST_F(AcyclicRequestsTest, NoFrameThatIsLostEndsARequest) {
  MailboxBed lossy(0.2, 128, 3);
  lossy.slave->handler = [&](const MailboxMessage& message) { return value(object_of(message), 4); };
  for (int i = 0; i < 50; ++i) {
    const auto id = submit(SdoRead{0, {0x1018, 1}});
    std::optional<SlaveAnswer> answer;
    for (int round = 0; round < 4000 && !answer; ++round) {
      ASSERT_TRUE(requests->run_round(*lossy.bus));
      lossy.clock.advance_to(lossy.clock.now() + kMillisecond);
      answer = channels.requests.take(id);
    }
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->data, Bytes{4}) << (answer->error ? answer->error->detail.text() : "");
  }
}

}  // namespace
}  // namespace syncline::test
