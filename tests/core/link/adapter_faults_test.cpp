// SPDX-License-Identifier: Apache-2.0
#include "link/adapter_faults.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "config/sim_config.h"
#include "link/link.h"
#include "link/simulated_link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/sim_bus.h"
#include "support/byte_order.h"
#include "support/clock.h"
#include "tests/support/machine_devices.h"

namespace syncline {
namespace {

/// One terminal; frames that ask it for its time are numbered, and what comes back is noted with when.
class AdapterFaultsTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  Nanoseconds begin = clock.now();
  SimConfig sim;
  std::unique_ptr<Link> link;
  std::uint8_t number = 0;

  void fault(FaultKind kind, Nanoseconds at, Nanoseconds until, Nanoseconds value = 0) {
    FaultConfig made;
    made.kind = kind;
    made.at = at;
    made.until = until;
    made.value_ns = value;
    sim.faults.push_back(made);
  }
  void SetUp() override {
    auto& slave = sim.slaves.emplace_back();
    slave.behaviour = "generic";
    slave.device = test::io8();
    fault(FaultKind::kLoseFrames, kSecond, 0);  // none of the adapter's, and later than all that happens here
  }
  void make() {
    auto bus = sim::SimBus::create(sim, clock.now());
    ASSERT_TRUE(bus);
    SimulatedHost host;
    host.adapter = AdapterFaults::of(sim, clock.now());
    link = make_simulated_link("card", std::move(*bus), clock, host);
  }
  [[nodiscard]] Nanoseconds now() const { return clock.now() - begin; }
  Status send(Nanoseconds at) {
    clock.advance_to(begin + at);
    FrameBuilder builder;
    EXPECT_TRUE(
        builder.add(Command::kBrd, ++number, device_address(0, reg::kSystemTime), std::array<std::uint8_t, 4>{}));
    return link->send(builder.finish());
  }
  struct Received {
    int number = 0;
    Nanoseconds arrival = 0, passed = 0;  // the terminal, by its clock
  };
  /// All that comes until then.
  std::vector<Received> receive(Nanoseconds until) {
    std::vector<Received> all;
    std::array<std::uint8_t, 1514> buffer{};
    for (;;) {
      const auto received = link->receive(buffer, begin + until);
      if (!received || received->length == 0) return all;
      FrameReader reader(std::span<std::uint8_t>(buffer).first(received->length));
      const auto datagram = reader.next();
      all.push_back({datagram->header.index, received->arrival_time - begin,
                     static_cast<Nanoseconds>(load_le<std::uint32_t>(datagram->data))});
    }
  }
  /// Of frames at 1, 2, 3 and 4.1 ms.
  std::vector<Received> answers_of_four() {
    make();
    for (const auto at : {1'000, 2'000, 3'000, 4'100}) EXPECT_TRUE(send(at * kMicrosecond));
    return receive(10 * kMillisecond);
  }
};

TEST_F(AdapterFaultsTest, FramesThatAreHeldUpReachTheBusLaterAndInTheirOrder) {
  fault(FaultKind::kHoldFrames, 2 * kMillisecond, 4 * kMillisecond, 1'500 * kMicrosecond);
  const auto all = answers_of_four();
  ASSERT_EQ(all.size(), 4U);
  const auto way = all[0].arrival - kMillisecond;
  EXPECT_LT(way, 20 * kMicrosecond);
  EXPECT_EQ(all[1].arrival, 3'500 * kMicrosecond + way);
  EXPECT_EQ(all[1].passed - all[0].passed, 2'500 * kMicrosecond);
  EXPECT_EQ(all[2].arrival, 4'500 * kMicrosecond + way);
  // Behind the one in front of it, though nobody holds it up any more.
  EXPECT_EQ(all[3].number, 4);
  EXPECT_GT(all[3].arrival, all[2].arrival);
  EXPECT_LT(all[3].arrival, all[2].arrival + 20 * kMicrosecond);
}

TEST_F(AdapterFaultsTest, AnswersThatAreHeldUpHavePassedTheBusInTime) {
  fault(FaultKind::kHoldAnswers, 2 * kMillisecond, 4 * kMillisecond, 1'500 * kMicrosecond);
  const auto all = answers_of_four();
  ASSERT_EQ(all.size(), 4U);
  const auto way = all[0].arrival - kMillisecond;
  EXPECT_EQ(all[1].passed - all[0].passed, kMillisecond);
  EXPECT_EQ(all[1].arrival, 3'500 * kMicrosecond + way);
  EXPECT_EQ(all[2].arrival, 4'500 * kMicrosecond + way);
  EXPECT_EQ(all[3].passed - all[2].passed, 1'100 * kMicrosecond);
  EXPECT_EQ(all[3].arrival, all[2].arrival);
}

/// Not to its end: whoever waits is told at once.
TEST_F(AdapterFaultsTest, AnAdapterThatIsOffSendsNothingAndLosesWhatComes) {
  fault(FaultKind::kAdapterOff, 2'005 * kMicrosecond, 4 * kMillisecond);
  make();
  std::array<std::uint8_t, 1514> buffer{};
  ASSERT_TRUE(send(1'000 * kMicrosecond));
  ASSERT_TRUE(send(2'000 * kMicrosecond));
  const auto first = link->receive(buffer, begin + 3 * kMillisecond);
  ASSERT_TRUE(first);
  EXPECT_GT(first->length, 0U);
  const auto down = link->receive(buffer, begin + 3 * kMillisecond);
  ASSERT_FALSE(down);
  EXPECT_EQ(down.error().code, ErrorCode::kLinkDown);
  EXPECT_EQ(now(), 2'005 * kMicrosecond);
  EXPECT_FALSE(link->describe().up);
  const auto sent = send(3'000 * kMicrosecond);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, ErrorCode::kLinkDown);
  clock.advance_to(begin + 4 * kMillisecond);
  EXPECT_TRUE(link->describe().up);
  ASSERT_TRUE(send(4'000 * kMicrosecond));
  const auto later = receive(5 * kMillisecond);
  ASSERT_EQ(later.size(), 1U) << "the second one came while it was off";
  EXPECT_EQ(later[0].number, number);
}

TEST_F(AdapterFaultsTest, WithoutAnEndTheyLast) {
  fault(FaultKind::kHoldFrames, 0, 0, 100 * kMicrosecond);
  make();
  ASSERT_TRUE(send(900 * kMillisecond));
  const auto all = receive(910 * kMillisecond);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_GT(all[0].arrival, 900'100 * kMicrosecond);
}

}  // namespace
}  // namespace syncline
