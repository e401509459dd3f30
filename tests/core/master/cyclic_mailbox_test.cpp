// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_mailbox.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <span>

#include "channels/snapshot.h"
#include "protocol/al_state.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::test {
namespace {

using Kind = CyclicMailbox::Answer::Kind;

/// The mailbox of one slave in OP.
class CyclicMailboxTest : public ::testing::Test {
 protected:
  CyclicMailboxTest() {
    snapshot.slaves.resize(1);
    snapshot.slaves[0].present = true;
    snapshot.slaves[0].al_status = static_cast<std::uint16_t>(AlState::kOp);
  }
  /// A datagram a cycle.
  std::optional<CyclicMailbox::Answer> ask(coe::ObjectAddress object) {
    EXPECT_TRUE(mailbox.ready_for(0));
    mailbox.upload(0, object);
    for (int cycle = 0; cycle < 20'000; ++cycle) {
      bed.clock.advance_to(bed.clock.now() + kMillisecond);
      auto* datagram = mailbox.next(bed.clock.now());
      if (datagram != nullptr) {
        EXPECT_TRUE(bed.bus->transact(*datagram));
      }
      mailbox.take(bed.clock.now());
      if (auto answer = mailbox.answer()) return answer;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::uint32_t silences() const { return snapshot.slaves[0].evidence.mailbox_silences; }

  MailboxBed bed;
  Snapshot snapshot;
  CyclicMailbox mailbox{snapshot, std::span(&bed.mailbox, 1)};
};

/// An abort is an answer, and no value.
TEST_F(CyclicMailboxTest, TellsValuesAbortsAndSilenceApart) {
  bed.slave->handler = [](const MailboxMessage&) -> std::vector<MailboxMessage> { return {}; };
  for (std::uint32_t times = 1; times <= 2; ++times) {
    const auto silent = ask({0x1C32, 5});
    ASSERT_TRUE(silent);
    EXPECT_EQ(silent->kind, Kind::kNothing);
    EXPECT_EQ(silent->value, 0U);
    EXPECT_EQ(silences(), times);
  }
  bed.slave->handler = [](const MailboxMessage&) {
    return std::vector{coe_message(coe::Abort{{0x1C32, 5}, 0x06090011})};
  };
  const auto refused = ask({0x1C32, 5});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->kind, Kind::kAbort);
  EXPECT_EQ(refused->value, 0x06090011U);
  EXPECT_EQ(silences(), 0U);
  bed.slave->handler = [](const MailboxMessage&) {
    return std::vector{coe_message(coe::UploadResponse{{0x1C32, 5}, false, true, 2, {0x34, 0x12}})};
  };
  const auto value = ask({0x1C32, 5});
  ASSERT_TRUE(value);
  EXPECT_EQ(value->kind, Kind::kValue);
  EXPECT_EQ(value->value, 0x1234U);
}

TEST_F(CyclicMailboxTest, ASlaveThatIsGoneIsNotWaitedFor) {
  bed.slave->handler = [this](const MailboxMessage&) -> std::vector<MailboxMessage> {
    snapshot.slaves[0].present = false;
    return {};
  };
  const auto begin = bed.clock.now();
  const auto answer = ask({0x1C32, 5});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->kind, Kind::kNothing);
  EXPECT_LT(bed.clock.now() - begin, 20 * kMillisecond);
  EXPECT_TRUE(mailbox.idle());
}

}  // namespace
}  // namespace syncline::test
