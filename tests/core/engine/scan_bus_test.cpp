// SPDX-License-Identifier: Apache-2.0
#include "engine/scan_bus.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <vector>

#include "channels/event.h"
#include "engine/opened_link.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

OpenedLink two_terminals() {
  test::SimulatedNetwork network;
  for (int i = 0; i < 2; ++i) network.add(test::io8());
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  opened.link = network.link(*opened.clock);
  return opened;
}

TEST(ScanBus, TellsProgressAndFindsTheSlaves) {
  std::vector<Event> events;
  ScanRequest request;
  request.on_event = [&](const Event& event) { events.push_back(event); };
  const auto scan = scan_bus(two_terminals(), request);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->slaves.size(), 2U);
  ASSERT_FALSE(events.empty());
  const auto* last = events.back().as<events::ScanProgress>();
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->done, 2U);
  EXPECT_EQ(last->found, 2U);
}

TEST(ScanBus, CanBeCancelled) {
  const std::atomic<bool> cancelled{true};
  ScanRequest request;
  request.cancel = &cancelled;
  const auto scan = scan_bus(two_terminals(), request);
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().code, ErrorCode::kCancelled);
}

TEST(ScanBus, PassesOnWhyALinkWasNotOpened) {
  const auto scan = scan_bus(fail(ErrorCode::kLinkNotFound, "eth9"));
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().code, ErrorCode::kLinkNotFound);
  EXPECT_EQ(scan.error().subject, "eth9");
}

}  // namespace
}  // namespace syncline
