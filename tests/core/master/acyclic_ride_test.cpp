// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

struct SentFrames {
  std::size_t count = 0, shortest = SIZE_MAX, longest = 0;
};

/// Counts what leaves.
class SentLink final : public Link {
 public:
  SentLink(std::unique_ptr<Link> inner, SentFrames& sent) : inner_(std::move(inner)), sent_(sent) {}
  Status send(std::span<const std::uint8_t> frame) override {
    ++sent_.count;
    sent_.shortest = std::min(sent_.shortest, frame.size());
    sent_.longest = std::max(sent_.longest, frame.size());
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return inner_->receive(buffer, deadline);
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  SentFrames& sent_;
};

/// A frame of its own for some bytes of reading would be most of what a cycle costs the host.
TEST(AcyclicRide, ReadingsGoWithTheCyclicFrame) {
  VirtualClock clock;
  SentFrames sent;
  const auto network = test::two_axes();
  MasterService service(std::make_unique<SentLink>(network.link(clock), sent), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  service.run_for(6 * kSecond);
  Snapshot before, after;
  service.channels().snapshot.read(before);
  ASSERT_EQ(before.state, AlState::kOp);
  sent = {};
  service.run_for(2 * kSecond);
  service.channels().snapshot.read(after);
  EXPECT_GE(sent.count, 2'000U);
  EXPECT_LE(sent.count, 2'500U) << "mailboxes have frames of their own, now and then";
  EXPECT_LE(sent.longest - sent.shortest, 200U);
  for (const auto& slave : after.slaves) EXPECT_TRUE(slave.present);
  EXPECT_GT(after.slaves[1].deviation_time, before.slaves[1].deviation_time) << "and they are read all the same";
  EXPECT_GT(after.slaves[1].sm2_missed.time, before.slaves[1].sm2_missed.time);
}

}  // namespace
}  // namespace syncline
