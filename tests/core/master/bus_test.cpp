// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/bus.h"

#include <gtest/gtest.h>

#include "tests/core/master/terminals_bed.h"

namespace syncline {
namespace {

class BusTest : public test::TerminalsBed {
 protected:
  void SetUp() override {
    test::give_addresses(link, 3);
    for (std::uint16_t i = 0; i < 3; ++i) ASSERT_TRUE(link.set<std::uint32_t>(i, 0x1000, 0x1111'1111U * (i + 1)));
  }
};

TEST_F(BusTest, PacksManyDatagramsIntoOneFrame) {
  std::array<std::array<std::uint8_t, 4>, 3> bytes{};
  std::vector<Datagram> reads;
  for (std::uint16_t i = 0; i < 3; ++i) {
    reads.push_back({Command::kFprd, device_address(static_cast<std::uint16_t>(1001 + i), 0x1000), bytes[i]});
  }
  ASSERT_TRUE(bus.transact(reads));
  EXPECT_EQ(link.frames_sent, 1U);
  EXPECT_EQ(load_le<std::uint32_t>(bytes[2]), 0x3333'3333U);
  for (const auto& read : reads) EXPECT_EQ(read.wkc, 1);
}

TEST_F(BusTest, SpreadsWhatDoesNotFit) {
  std::vector<std::vector<std::uint8_t>> bytes(3, std::vector<std::uint8_t>(1000));
  std::vector<Datagram> reads;
  for (auto& b : bytes) reads.push_back({Command::kFprd, device_address(1002, 0x1000), b});
  ASSERT_TRUE(bus.transact(reads));
  EXPECT_EQ(link.frames_sent, 3U);
  for (const auto& b : bytes) EXPECT_EQ(load_le<std::uint32_t>(b), 0x2222'2222U);
}

TEST_F(BusTest, RepeatsLostFramesAndCountsThem) {
  link.lose(3);
  const auto value = bus.read<std::uint32_t>(1001, 0x1000, "slave");
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 0x1111'1111U);
  EXPECT_EQ(exchange.lost_frames(), 3U);
}

TEST_F(BusTest, SaysWhenNothingComesBack) {
  link.lose(1000);
  const auto value = bus.read<std::uint32_t>(1001, 0x1000, "slave");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::kNoResponse);
}

TEST_F(BusTest, SaysWhenNoSlaveAnswers) {
  const auto value = bus.read<std::uint32_t>(1999, 0x1000, "slave 9");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().subject, "slave 9");
}

TEST_F(BusTest, EndsWhenCancelled) {
  cancel = true;
  const auto status = bus.wait(kSecond);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kCancelled);
  bus.set_cancellable(false);
  const auto before = clock.now();
  EXPECT_TRUE(bus.wait(kSecond));
  EXPECT_GE(clock.now() - before, kSecond);
}

/// Delivers frames of a former exchange before the right one.
class LateLink final : public Link {
 public:
  explicit LateLink(Link& inner) : inner_(inner) {}
  Status send(std::span<const std::uint8_t> frame) override { return inner_.send(frame); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_.receive(buffer, deadline);
    if (!received || received->length == 0) return received;
    std::vector<std::uint8_t> now(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(received->length));
    if (held_.empty()) {
      held_ = std::move(now);
      return ReceivedFrame{};  // too late for its own exchange
    }
    if (!delivered_) {
      delivered_ = true;
      std::ranges::copy(held_, buffer.begin());
      pending_ = std::move(now);
      return ReceivedFrame{held_.size(), received->arrival_time};
    }
    return received;
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_.describe(); }
  std::vector<std::uint8_t> held_, pending_;
  bool delivered_ = false;

 private:
  Link& inner_;
};

TEST_F(BusTest, TakesNoAnswerOfAnEarlierFrame) {
  LateLink late(link);
  FrameExchange other(late, clock);
  Bus late_bus(other, clock);
  const auto value = late_bus.read<std::uint32_t>(1002, 0x1000, "slave");
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 0x2222'2222U);
  EXPECT_EQ(other.stray_frames(), 1U);
}

}  // namespace
}  // namespace syncline
