// SPDX-License-Identifier: Apache-2.0
#include "channels/bounded_queue.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>

namespace syncline {
namespace {

TEST(BoundedQueue, IsFirstInFirstOutAndFullAtItsCapacity) {
  BoundedQueue<std::string> queue(3);
  EXPECT_EQ(queue.capacity(), 3U);
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.pop());
  for (int round = 0; round < 5; ++round) {
    for (const char* text : {"one", "two", "three"}) EXPECT_TRUE(queue.push(std::string(text)));
    std::string more = "a fourth that must not be lost";
    EXPECT_FALSE(queue.push(std::move(more)));
    EXPECT_EQ(more, "a fourth that must not be lost");
    EXPECT_EQ(queue.pop(), "one");
    EXPECT_TRUE(queue.push(std::move(more)));
    EXPECT_EQ(queue.pop(), "two");
    EXPECT_EQ(queue.pop(), "three");
    EXPECT_EQ(queue.pop(), "a fourth that must not be lost");
    EXPECT_TRUE(queue.empty());
  }
}

TEST(BoundedQueue, WhatIsInItEndsWithItOrWithWhoTookIt) {
  const auto counted = std::make_shared<int>();
  {
    BoundedQueue<std::shared_ptr<int>> queue(8);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(queue.push(std::shared_ptr<int>(counted)));
    EXPECT_EQ(counted.use_count(), 6);
    (void)queue.pop();
    EXPECT_EQ(counted.use_count(), 5) << "a place that was taken from keeps nothing";
  }
  EXPECT_EQ(counted.use_count(), 1);
}

TEST(BoundedQueue, LosesNothingBetweenTwoThreads) {
  BoundedQueue<std::unique_ptr<int>> queue(7);
  constexpr int kCount = 100'000;
  std::thread producer([&queue] {
    for (int i = 0; i < kCount; ++i) {
      auto value = std::make_unique<int>(i);
      while (!queue.push(std::move(value))) std::this_thread::yield();
    }
  });
  for (int expected = 0; expected < kCount;) {
    const auto value = queue.pop();
    if (!value) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(**value, expected);
    ++expected;
  }
  producer.join();
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace syncline
