// SPDX-License-Identifier: Apache-2.0
#include "channels/frame_ring.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "support/random.h"

namespace syncline {
namespace {

/// Its bytes follow from its number, so that a torn one shows.
std::vector<std::uint8_t> frame_of(std::uint64_t number) {
  Random random(number + 1);
  std::vector<std::uint8_t> frame(60 + random.next() % 1455);
  for (auto& byte : frame) byte = static_cast<std::uint8_t>(number + frame.size());
  return frame;
}

struct Taken {
  std::vector<Nanoseconds> times;
  std::uint64_t lost = 0, wrong = 0;
  void operator()(const RingFrame& frame) {
    const auto expected = frame_of(static_cast<std::uint64_t>(frame.time));
    const auto direction = frame.time % 2 == 0 ? FrameDirection::kSent : FrameDirection::kReceived;
    wrong += !std::ranges::equal(frame.bytes, expected) || frame.direction != direction;
    // What is missing is what is said to be lost.
    const auto before = times.empty() ? -1 : times.back();
    wrong += frame.time != before + 1 + static_cast<Nanoseconds>(frame.lost_before);
    lost += frame.lost_before;
    times.push_back(frame.time);
  }
};

void push(FrameRing& ring, std::uint64_t number) {
  const auto frame = frame_of(number);
  ring.push(frame, static_cast<Nanoseconds>(number),
            number % 2 == 0 ? FrameDirection::kSent : FrameDirection::kReceived);
}

TEST(FrameRing, TakesNothingUntilItIsOpen) {
  FrameRing ring;
  push(ring, 0);
  Taken taken;
  ring.read(std::ref(taken));
  EXPECT_TRUE(taken.times.empty());
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_FALSE(ring.is_open());
}

TEST(FrameRing, GivesFramesInTheirOrderAroundItsEnd) {
  FrameRing ring;
  ring.open(FrameRing::WhenFull::kLose, 4096);
  Taken taken;
  for (std::uint64_t i = 0; i < 1'000; ++i) {
    push(ring, i);
    ring.read(std::ref(taken));
  }
  EXPECT_EQ(taken.times.size(), 1'000U);
  EXPECT_EQ(taken.wrong, 0U);
  EXPECT_EQ(ring.lost(), 0U);
}

TEST(FrameRing, CountsWhatDidNotFitWhereItIsMissing) {
  FrameRing ring;
  ring.open(FrameRing::WhenFull::kLose, 1U << 16);
  Taken taken;
  std::uint64_t number = 0;
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 100; ++i) push(ring, number++);
    ring.read(std::ref(taken));
  }
  EXPECT_EQ(taken.wrong, 0U);
  EXPECT_GT(taken.lost, 300U);
  EXPECT_LT(taken.lost, number);
  // What was lost at the end no frame tells yet.
  EXPECT_EQ(taken.times.size() + ring.lost(), number);
  EXPECT_EQ(ring.lost() - taken.lost, number - 1 - static_cast<std::uint64_t>(taken.times.back()));
}

TEST(FrameRing, OpenedAgainItBeginsAnew) {
  FrameRing ring;
  ring.open(FrameRing::WhenFull::kLose, 4096);
  for (std::uint64_t i = 0; i < 20; ++i) push(ring, i);
  EXPECT_GT(ring.lost(), 0U);
  ring.close();
  push(ring, 20);
  ring.open();
  EXPECT_EQ(ring.lost(), 0U);
  push(ring, 0);
  Taken taken;
  ring.read(std::ref(taken));
  EXPECT_EQ(taken.times, std::vector<Nanoseconds>{0});
  EXPECT_EQ(taken.wrong, 0U);
}

TEST(FrameRing, BetweenTwoThreadsNothingIsTorn) {
  for (const auto when_full : {FrameRing::WhenFull::kLose, FrameRing::WhenFull::kWait}) {
    FrameRing ring;
    ring.open(when_full, 1U << 14);
    constexpr std::uint64_t kFrames = 20'000;
    std::atomic<bool> over{false};
    std::thread producer([&] {
      for (std::uint64_t i = 0; i < kFrames; ++i) push(ring, i);
      over = true;
    });
    Taken taken;
    while (!over) ring.read(std::ref(taken));
    producer.join();
    ring.read(std::ref(taken));
    EXPECT_EQ(taken.wrong, 0U);
    EXPECT_EQ(taken.times.size() + ring.lost(), kFrames);
    if (when_full == FrameRing::WhenFull::kWait) {
      EXPECT_EQ(ring.lost(), 0U);
    }
  }
}

/// Nobody is kept waiting by one who reads no more.
TEST(FrameRing, ClosingItEndsTheWaiting) {
  FrameRing ring;
  ring.open(FrameRing::WhenFull::kWait, 4096);
  std::thread producer([&ring] {
    for (std::uint64_t i = 0; i < 100; ++i) push(ring, i);
  });
  ring.close();
  producer.join();
}

}  // namespace
}  // namespace syncline
