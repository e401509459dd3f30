// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/process_data_watch.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "channels/event_queue.h"
#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"
#include "support/random.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A terminal without SYNC0, which writes its inputs anew at the end of each frame that brings outputs.
class WatchedTerminal : public ::testing::Test {
 protected:
  static NetworkConfig machine() {
    test::SimulatedNetwork network;
    network.add(test::io8());
    network.project.slaves[0].dc.op_mode.clear();
    return network.compiled();
  }
  WatchedTerminal() {
    snapshot_.slaves.resize(1);
    snapshot_.slaves[0].present = true;
    snapshot_.slaves[0].al_status = static_cast<std::uint16_t>(AlState::kOp);
  }
  /// The frames of a cycle: what is asked for rides behind the process data, or comes in a frame of its own.
  void cycle(bool rides, bool works = true) {
    PendingFrame frame;
    (void)watch_.add_to(frame);
    const auto before = buffer_;
    if (works) buffer_ ^= 1;
    for (auto* datagram : frame.datagrams()) {
      datagram->data[0] = static_cast<std::uint8_t>((rides ? before : buffer_) << 4);
      datagram->answered = true;
      datagram->wkc = 1;
    }
    now_ += config_.cycle_time();
    watch_.take(now_, {.read = true, .rode = rides});
  }
  std::vector<bool> told() {
    std::vector<bool> begun;
    for (const auto& event : queue_.drain()) {
      if (const auto* stale = event.as<events::StaleProcessData>()) begun.push_back(stale->begun);
    }
    return begun;
  }

  static constexpr int kLearning = 400;  // cycles, of some three a reading
  NetworkConfig config_ = machine();
  Snapshot snapshot_;
  EventQueue queue_{64};
  EventTeller teller_{config_, queue_};
  ProcessDataWatch watch_{config_, snapshot_, teller_};
  std::uint8_t buffer_ = 0;
  Nanoseconds now_ = 0;
};

/// What else is asked for in the cycle decides whether it rides; that says nothing of the slave.
TEST_F(WatchedTerminal, IsNotAccusedByTheFrameInWhichItWasAsked) {
  for (int i = 0; i < kLearning; ++i) cycle(true);
  Random random(1);
  for (int i = 0; i < 20'000; ++i) cycle(random.next() % 2 == 0);
  EXPECT_EQ(told(), std::vector<bool>{});
  for (int i = 0; i < 4'000; ++i) cycle(random.next() % 2 == 0, i % 3 == 0);
  EXPECT_EQ(told(), std::vector<bool>{true}) << "it takes every third only";
  for (int i = 0; i < 4'000; ++i) cycle(random.next() % 2 == 0);
  EXPECT_EQ(told(), std::vector<bool>{false});
}

TEST_F(WatchedTerminal, IsToldWhicheverWayItIsAsked) {
  for (const bool rides : {true, false}) {
    for (int i = 0; i < kLearning; ++i) cycle(rides);
    for (int i = 0; i < 4'000; ++i) cycle(rides, i % 3 == 0);
    for (int i = 0; i < 4'000; ++i) cycle(rides);
    EXPECT_EQ(told(), (std::vector<bool>{true, false}));
  }
}

}  // namespace
}  // namespace syncline
