// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/process_data_watch.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "channels/event_queue.h"
#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"
#include "protocol/registers.h"
#include "support/random.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A terminal without SYNC0, which writes its inputs anew at the end of each frame that brings outputs.
class WatchedTerminal : public ::testing::Test {
 protected:
  static NetworkConfig machine(bool inputs, std::optional<int> cycles_of_sync0 = {}) {
    auto device = test::io8();
    if (!inputs) {
      device.fmmus.pop_back();
      device.sync_managers.pop_back();
      device.tx_pdos.clear();
    }
    test::SimulatedNetwork network;
    network.add(device);
    if (cycles_of_sync0) {
      network.project.slaves[0].dc.sync0.cycle_factor = *cycles_of_sync0;
    } else {
      network.project.slaves[0].dc.op_mode.clear();
    }
    return network.compiled();
  }
  explicit WatchedTerminal(bool inputs = true) : WatchedTerminal(machine(inputs)) {}
  explicit WatchedTerminal(NetworkConfig config) : config_(std::move(config)) {
    snapshot_.slaves.resize(1);
    snapshot_.slaves[0].present = true;
    snapshot_.slaves[0].al_status = static_cast<std::uint16_t>(AlState::kOp);
  }
  /// The frames of a cycle: what is asked for goes behind the process data, or not at all.
  bool cycle(bool goes, bool works = true, Nanoseconds late = 0, bool regular = true) {
    const auto wish = watch_.next();
    if (wish && goes) {
      wish->datagram->data[0] = static_cast<std::uint8_t>(buffer_ << 4);
      wish->datagram->answered = true;
      wish->datagram->wkc = 1;
    }
    if (works) buffer_ ^= 1;
    now_ += config_.cycle_time();
    watch_.take(now_ + late, regular);
    return wish.has_value();
  }
  std::vector<bool> told() {
    std::vector<bool> begun;
    for (const auto& event : queue_.drain()) {
      if (const auto* stale = event.as<events::StaleProcessData>()) begun.push_back(stale->begun);
    }
    return begun;
  }

  static constexpr int kLearning = 400;  // cycles, of some three a reading
  NetworkConfig config_;
  Snapshot snapshot_;
  EventQueue queue_{64};
  EventTeller teller_{config_, queue_};
  ProcessDataWatch watch_{config_, snapshot_, teller_};
  std::uint8_t buffer_ = 0;
  Nanoseconds now_ = 0;
};

/// Not every cycle has room for what asks it; that says nothing of the slave.
TEST_F(WatchedTerminal, IsNotAccusedByCyclesInWhichItWasNotAsked) {
  for (int i = 0; i < kLearning; ++i) cycle(true);
  Random random(1);
  for (int i = 0; i < 20'000; ++i) cycle(random.next() % 2 == 0);
  EXPECT_EQ(told(), std::vector<bool>{});
  for (int i = 0; i < 4'000; ++i) cycle(random.next() % 2 == 0, i % 3 == 0);
  EXPECT_EQ(told(), std::vector<bool>{true}) << "it takes every third only";
  for (int i = 0; i < 4'000; ++i) cycle(random.next() % 2 == 0);
  EXPECT_EQ(told(), std::vector<bool>{false});
}

/// By its own timer, whose moment lies among those at which frames come: some bring nothing new, as many bring two.
TEST_F(WatchedTerminal, ThatRunsByItselfIsNotAccusedWhereFramesComeAroundItsMoment) {
  for (int i = 0; i < kLearning; ++i) cycle(true);
  Random random(1);
  constexpr Nanoseconds kMoment = 500;
  Nanoseconds late = 0;
  for (int i = 0; i < 100'000; ++i) {
    const bool passed = late > kMoment;  // by the frame before
    late = static_cast<Nanoseconds>(random.next() % 1'000);
    // Two renewals end in another buffer as one does.
    if (!passed || late > kMoment) buffer_ ^= 1;
    cycle(true, false, late + static_cast<Nanoseconds>(random.next() % 150));
  }
  EXPECT_EQ(told(), std::vector<bool>{});
}

/// Cycles were left out, in which nobody renewed anything.
TEST_F(WatchedTerminal, IsNotJudgedByTheFirstFrameBehindAStandstill) {
  Random random(1);
  const auto some = [&](bool regular, bool slow) {
    for (int i = 0; i < 4'000; ++i)
      cycle(true, !slow || i % 3 == 0, static_cast<Nanoseconds>(random.next() % 5'000), regular);
  };
  some(true, false);
  some(false, true);
  EXPECT_EQ(told(), std::vector<bool>{});
  some(true, true);
  some(true, false);
  EXPECT_EQ(told(), (std::vector<bool>{true, false}));
}

/// With SYNC0 in every second cycle.
class WatchedSlowSync : public WatchedTerminal {
 protected:
  WatchedSlowSync() : WatchedTerminal(machine(true, 2)) {}
};

/// In which cycle it does its work is another matter when an odd number of them was left out, and in which cycles there
/// is room to look follows the same rhythm.
TEST_F(WatchedSlowSync, IsNotHeldToEveryCycle) {
  constexpr std::array kRoom{true, true, false, true, false, false, false, false};
  for (const int moment : {0, 1, 0}) {
    for (std::size_t i = 0; i < 20'000; ++i) cycle(kRoom[i % kRoom.size()], static_cast<int>(i % 2) == moment);
  }
  EXPECT_EQ(told(), std::vector<bool>{});
  for (std::size_t i = 0; i < 40'000; ++i) cycle(kRoom[i % kRoom.size()], i % 6 == 0);
  EXPECT_EQ(told(), std::vector<bool>{true}) << "nobody has looked";
}

TEST_F(WatchedSlowSync, IsToldWhereItDoesNotDoItEachTime) {
  for (int i = 0; i < 4'000; ++i) cycle(true, i % 2 == 0);
  for (int i = 0; i < 4'000; ++i) cycle(true, i % 6 == 0);
  EXPECT_EQ(told(), std::vector<bool>{true});
  for (int i = 0; i < 4'000; ++i) cycle(true, i % 2 == 0);
  EXPECT_EQ(told(), std::vector<bool>{false});
}

class WatchedSlowOutputs : public WatchedTerminal {
 protected:
  WatchedSlowOutputs() : WatchedTerminal(machine(false, 2)) {}
};

/// Which of the two cycles shows whether it took them is by chance.
TEST_F(WatchedSlowOutputs, AreNotAskedFor) {
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(cycle(true));
}

class WatchedOutputs : public WatchedTerminal {
 protected:
  WatchedOutputs() : WatchedTerminal(false) {}
  /// What the slave says of its SyncManagers: those whose buffer its firmware has not read.
  void say(std::uint8_t events, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      const auto wish = watch_.next();
      if (wish) {
        addresses.insert(static_cast<std::uint16_t>(wish->datagram->address >> 16));
        wish->datagram->data[0] = events;
        wish->datagram->answered = true;
        wish->datagram->wkc = 1;
      }
      now_ += config_.cycle_time();
      watch_.take(now_, true);
    }
  }
  std::set<std::uint16_t> addresses;
};

/// Its outputs are those of SyncManager 0, whatever is new in the others.
TEST_F(WatchedOutputs, OnlyTheEventOfTheirSyncManagerCounts) {
  constexpr std::uint8_t kOutputs = 1U << 0;
  say(0, kLearning);
  say(static_cast<std::uint8_t>(~kOutputs), 4'000);
  EXPECT_EQ(told(), std::vector<bool>{});
  say(kOutputs, 4'000);
  EXPECT_EQ(told(), std::vector<bool>{true});
  EXPECT_EQ(addresses, (std::set<std::uint16_t>{reg::kAlEventRequest + 1}));
}

/// Nobody rides in a cycle that has no room for it.
TEST_F(WatchedOutputs, LeaveCyclesToOthersWhereNothingComesOfIt) {
  int taken = 0;
  constexpr int kCycles = 3'000;
  for (int i = 0; i < kCycles; ++i) taken += cycle(false) ? 1 : 0;
  EXPECT_GT(taken, 0);
  EXPECT_LE(taken, kCycles * 2 / 3);
}

}  // namespace
}  // namespace syncline
