// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/frame_tap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "channels/frame_ring.h"
#include "channels/master_channels.h"
#include "link/link.h"
#include "support/clock.h"
#include "support/result.h"

namespace syncline {
namespace {

/// A wire that refuses the second frame, and knows better than its caller when it sends.
class StampedLink final : public Link {
 public:
  Status send(std::span<const std::uint8_t>) override {
    if (++sent_ == 2) return fail(ErrorCode::kLinkDown, "wire");
    return {};
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return 1'000 + sent_; }
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t>, const SendTimeField& field) override {
    return field.send_time + 7;
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds) override {
    if (came_++ > 0) return ReceivedFrame{};
    std::ranges::fill(buffer.first(64), std::uint8_t{9});
    return ReceivedFrame{64, 5'000};
  }
  [[nodiscard]] LinkDescription describe() const override { return {.name = "wire", .kind = "test"}; }

 private:
  int sent_ = 0, came_ = 0;
};

TEST(FrameTap, KeepsWhatIsOnTheWireWithItsTimesAndOnlyOnRequest) {
  VirtualClock clock;
  MasterChannels channels;
  auto ring = channels.frames;
  const auto link = make_frame_tap(std::make_unique<StampedLink>(), clock, channels);
  std::vector<std::uint8_t> frame(60, 1);
  std::array<std::uint8_t, 1514> buffer{};
  EXPECT_TRUE(link->send(frame));
  ring->open();
  EXPECT_FALSE(link->send(frame)) << "the adapter has not taken it";
  EXPECT_TRUE(link->send(frame));
  EXPECT_EQ(link->send_corrected(frame, {.send_time = 2'000}).value_or(0), 2'007);
  EXPECT_EQ(link->receive(buffer, 0)->length, 64U);
  EXPECT_EQ(link->receive(buffer, 0)->length, 0U);
  EXPECT_EQ(link->describe().name, "wire");
  EXPECT_EQ(link->sent_at(), 1'003);

  std::vector<std::pair<Nanoseconds, FrameDirection>> kept;
  std::vector<std::size_t> sizes;
  ring->read([&](const RingFrame& one) {
    kept.emplace_back(one.time, one.direction);
    sizes.push_back(one.bytes.size());
  });
  const std::vector<std::pair<Nanoseconds, FrameDirection>> expected{
      {1'003, FrameDirection::kSent}, {2'007, FrameDirection::kSent}, {5'000, FrameDirection::kReceived}};
  EXPECT_EQ(kept, expected);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{60, 60, 64}));
  EXPECT_EQ(channels.heartbeat, 6U) << "the thread comes back from each, whatever became of it";
}

}  // namespace
}  // namespace syncline
