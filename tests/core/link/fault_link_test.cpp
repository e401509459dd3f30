// SPDX-License-Identifier: Apache-2.0
#include "link/fault_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "support/clock.h"

namespace syncline {
namespace {

/// Gives every frame back after 10 us.
class LateEchoLink final : public Link {
 public:
  explicit LateEchoLink(VirtualClock& clock) : clock_(clock) {}
  Status send(std::span<const std::uint8_t> frame) override {
    ++executed;
    frames_.push_back({clock_.now() + 10'000, {frame.begin(), frame.end()}});
    return {};
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (frames_.empty() || frames_.front().first > deadline) {
      clock_.advance_to(std::max(deadline, clock_.now()));
      return ReceivedFrame{};
    }
    const auto [time, bytes] = frames_.front();
    frames_.pop_front();
    clock_.advance_to(std::max(time, clock_.now()));
    std::ranges::copy(bytes, buffer.begin());
    return ReceivedFrame{bytes.size(), time};
  }
  [[nodiscard]] LinkDescription describe() const override { return {"echo", "simulated", {}, true}; }
  int executed = 0;

 private:
  VirtualClock& clock_;
  std::deque<std::pair<Nanoseconds, std::vector<std::uint8_t>>> frames_;
};

struct Bench {
  VirtualClock clock;
  LateEchoLink* echo = nullptr;
  std::unique_ptr<FaultLink> link;

  explicit Bench(const LinkFaults& faults) {
    auto inner = std::make_unique<LateEchoLink>(clock);
    echo = inner.get();
    link = std::make_unique<FaultLink>(std::move(inner), clock, faults);
  }
  void send(std::uint8_t number) {
    const std::array<std::uint8_t, 1> frame{number};
    ASSERT_TRUE(link->send(frame));
  }
  /// Numbers of the frames that come until `patience` has passed.
  std::vector<int> receive_all(Nanoseconds patience = 100 * kMillisecond) {
    std::vector<int> numbers;
    std::array<std::uint8_t, 1514> buffer{};
    const auto deadline = clock.now() + patience;
    for (;;) {
      const auto received = link->receive(buffer, deadline);
      if (!received || received->length == 0) return numbers;
      numbers.push_back(buffer[0]);
    }
  }
};

TEST(FaultLink, ChangesNothingWithoutFaults) {
  Bench bench({});
  for (std::uint8_t i = 0; i < 3; ++i) bench.send(i);
  EXPECT_EQ(bench.receive_all(), (std::vector<int>{0, 1, 2}));
}

TEST(FaultLink, TellsLostRequestsFromLostReplies) {
  Bench requests({.lose_request = 1});
  requests.send(1);
  EXPECT_EQ(requests.echo->executed, 0);
  Bench replies({.lose_reply = 1});
  replies.send(1);
  EXPECT_EQ(replies.echo->executed, 1);
  EXPECT_TRUE(replies.receive_all().empty());
  EXPECT_EQ(replies.link->injected().lost, 1U);
}

TEST(FaultLink, DeliversTwice) {
  Bench bench({.duplicate = 1});
  bench.send(7);
  EXPECT_EQ(bench.receive_all(), (std::vector<int>{7, 7}));
}

TEST(FaultLink, SwapsNeighbours) {
  Bench bench({.reorder = 0.5, .seed = 3});
  for (std::uint8_t i = 0; i < 20; ++i) bench.send(i);
  auto numbers = bench.receive_all();
  EXPECT_FALSE(std::ranges::is_sorted(numbers));
  EXPECT_GT(bench.link->injected().reordered, 0U);
  std::ranges::sort(numbers);
  EXPECT_EQ(numbers.size(), 20U);
}

TEST(FaultLink, HoldsLateFramesBackForTheirTime) {
  Bench bench({.late = 1, .late_by = 30 * kMillisecond});
  bench.send(1);
  EXPECT_TRUE(bench.receive_all(20 * kMillisecond).empty());
  EXPECT_EQ(bench.receive_all(20 * kMillisecond), std::vector<int>{1});
}

TEST(FaultLink, DoesTheSameForTheSameSeed) {
  const LinkFaults faults{
      .lose_request = 0.1, .lose_reply = 0.1, .duplicate = 0.1, .reorder = 0.1, .late = 0.1, .seed = 9};
  Bench first(faults), second(faults);
  for (std::uint8_t i = 0; i < 200; ++i) {
    first.send(i);
    second.send(i);
  }
  EXPECT_EQ(first.receive_all(), second.receive_all());
}

}  // namespace
}  // namespace syncline
