// SPDX-License-Identifier: Apache-2.0
// What is read as evidence while the bus runs takes one datagram a cycle at most.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

constexpr std::uint16_t kFirstTerminal = 1003;

/// The inputs of a servo are behind its two mailboxes, whose status is asked for on their own account.
bool is_evidence(std::uint16_t address, std::size_t length, unsigned input_manager) {
  const bool manager_status = address == reg::sync_manager(input_manager) + 5;
  return address == reg::kRxErrorCounter || address == reg::kWatchdogCounterProcessData ||
         address == reg::kSpeedCounterDiff || (manager_status && length == 1);
}

/// Counts what is asked of single slaves as evidence, by the cycle in which it is asked.
class CountingLink final : public Link {
 public:
  struct Counts {
    std::map<Nanoseconds, int> by_cycle;
    std::set<std::pair<std::uint16_t, std::uint16_t>> asked;  // station and register
  };
  CountingLink(std::unique_ptr<Link> inner, Clock& clock, Counts& counts)
      : inner_(std::move(inner)), clock_(clock), counts_(counts) {}
  Status send(std::span<const std::uint8_t> frame) override {
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    FrameReader reader(bytes);
    while (const auto datagram = reader.next()) {
      if (datagram->header.command != Command::kFprd) continue;
      const auto station = static_cast<std::uint16_t>(datagram->header.address & 0xFFFFU);
      const auto address = static_cast<std::uint16_t>(datagram->header.address >> 16U);
      if (!is_evidence(address, datagram->data.size(), station < kFirstTerminal ? 3 : 1)) continue;
      ++counts_.by_cycle[clock_.now() / kMillisecond];
      counts_.asked.emplace(station, address);
    }
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return inner_->receive(buffer, deadline);
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  Clock& clock_;
  Counts& counts_;
};

TEST(EvidenceShare, IsOneDatagramACycle) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 2; ++i) network.add(test::servo(), "servo-y");
  for (int i = 0; i < 3; ++i) network.add(test::io8());
  VirtualClock clock;
  CountingLink::Counts counts;
  MasterService service(std::make_unique<CountingLink>(network.link(clock), clock, counts), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  service.run_for(6 * kSecond);
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  ASSERT_EQ(snapshot.state, AlState::kOp);
  counts = {};
  constexpr std::size_t kCycles = 1000;
  service.run_for(kCycles * kMillisecond);
  int most = 0;
  for (const auto& [cycle, count] : counts.by_cycle) most = std::max(most, count);
  EXPECT_EQ(most, 1);
  EXPECT_GT(counts.by_cycle.size(), kCycles * 9 / 10) << "it is used";
  // Of five slaves: port errors, watchdogs, speed counter and the buffers of the inputs.
  EXPECT_EQ(counts.asked.size(), 20U);
}

}  // namespace
}  // namespace syncline
