// SPDX-License-Identifier: Apache-2.0
#include "master/startup/slave_visit.h"

#include <gtest/gtest.h>

#include <numeric>

#include "findings/error_text.h"
#include "master/mailbox/foe_client.h"
#include "protocol/registers.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// What a visit must not change.
struct Found {
  std::array<std::uint8_t, 2> al_status{}, station{};
  std::array<std::uint8_t, 16> managers{};
  std::array<std::uint8_t, 1> sii_owner{};
  bool operator==(const Found&) const = default;
};

/// Two drives of which the second one is visited; both had the same address given by somebody else.
class SlaveVisitTest : public ::testing::TestWithParam<AlState> {
 protected:
  SlaveVisitTest() {
    network.add(test::servo(), "servo-y");
    network.add(test::servo(), "servo-y");
    link = network.link(clock);
    exchange.emplace(*link, clock);
    bus.emplace(*exchange, clock);
  }
  [[nodiscard]] Found found(std::uint16_t position) {
    Found all;
    const auto adp = Position{position}.auto_increment_address();
    EXPECT_TRUE(bus->exchange(Command::kAprd, adp, reg::kAlStatus, all.al_status));
    EXPECT_TRUE(bus->exchange(Command::kAprd, adp, reg::kStationAddress, all.station));
    EXPECT_TRUE(bus->exchange(Command::kAprd, adp, reg::kSyncManager, all.managers));
    EXPECT_TRUE(bus->exchange(Command::kAprd, adp, 0x0500, all.sii_owner));
    all.managers[5] = all.managers[13] = 0;  // what is in the mailboxes just then
    return all;
  }

  VirtualClock clock;
  test::SimulatedNetwork network;
  std::unique_ptr<Link> link;
  std::optional<FrameExchange> exchange;
  std::optional<Bus> bus;
};

TEST_P(SlaveVisitTest, LeavesTheSlaveAsItWasFound) {
  for (const std::uint16_t position : {0, 1}) {
    ASSERT_TRUE(bus->write<std::uint16_t>(Command::kApwr, Position{position}.auto_increment_address(),
                                          reg::kStationAddress, 7));
  }
  {  // Somebody led it there.
    SlaveVisit earlier(*bus, 1);
    ASSERT_TRUE(earlier.look());
    ASSERT_TRUE(earlier.lead_to(GetParam()));
  }
  const auto other = found(0), before = found(1);
  std::vector<std::uint8_t> file(700);
  std::iota(file.begin(), file.end(), std::uint8_t{3});
  for (const bool boot : {false, true}) {
    SlaveVisit visit(*bus, 1);
    ASSERT_TRUE(visit.look());
    if (boot) {
      ASSERT_TRUE(visit.lead_to(AlState::kBoot));
    }
    const auto opened = visit.open_mailbox();
    ASSERT_TRUE(opened) << describe(opened.error());
    EXPECT_EQ(visit.state() == AlState::kBoot, boot || GetParam() == AlState::kBoot);
    const auto written = FoeClient(visit.mailbox()).write("firmware.bin", file);
    ASSERT_TRUE(written) << describe(written.error());
    EXPECT_EQ(FoeClient(visit.mailbox()).read("firmware.bin").value(), file);
    const auto left = visit.leave();
    ASSERT_TRUE(left) << describe(left.error());
    EXPECT_EQ(found(1), before) << "boot " << boot;
    EXPECT_EQ(found(0), other);
  }
}

INSTANTIATE_TEST_SUITE_P(From, SlaveVisitTest, ::testing::Values(AlState::kInit, AlState::kPreop, AlState::kBoot),
                         [](const auto& state) { return std::string(al_state_name(state.param)); });

TEST_F(SlaveVisitTest, NeitherCancelNorInterruptKeepsItFromLeaving) {
  std::atomic<bool> cancel{false};
  Bus cancellable(*exchange, clock, &cancel);
  bool interrupted = false;
  cancellable.set_interrupt([&] { return interrupted; });
  const auto before = found(1);
  SlaveVisit visit(cancellable, 1);
  ASSERT_TRUE(visit.look());
  ASSERT_TRUE(visit.open_mailbox());
  cancel = interrupted = true;
  EXPECT_EQ(visit.lead_to(AlState::kBoot).error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(visit.leave());
  EXPECT_EQ(found(1), before);
}

}  // namespace
}  // namespace syncline
