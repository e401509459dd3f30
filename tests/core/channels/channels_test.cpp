// SPDX-License-Identifier: Apache-2.0
#include "channels/master_channels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace syncline {
namespace {

CycleSample numbered(std::uint64_t cycle) {
  CycleSample sample;
  sample.cycle = cycle;
  return sample;
}

TEST(SampleRing, KeepsOrderAndCountsWhatDoesNotFit) {
  SampleRing ring(4);
  for (std::uint64_t i = 0; i < 6; ++i) EXPECT_EQ(ring.push(numbered(i)), i < 4);
  EXPECT_EQ(ring.overruns(), 2U);
  std::vector<CycleSample> out;
  EXPECT_EQ(ring.pop(out, 3), 3U);
  EXPECT_TRUE(ring.push(numbered(6)));
  EXPECT_EQ(ring.pop(out), 2U);
  ASSERT_EQ(out.size(), 5U);
  EXPECT_EQ(out[2].cycle, 2U);
  EXPECT_EQ(out[4].cycle, 6U);
}

TEST(SampleRing, LosesNothingBetweenTwoThreads) {
  SampleRing ring(64);
  constexpr std::uint64_t kCount = 200'000;
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kCount;) {
      if (ring.push(numbered(i))) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::vector<CycleSample> out;
  std::uint64_t expected = 0;
  while (expected < kCount) {
    out.clear();
    if (ring.pop(out) == 0) std::this_thread::yield();
    for (const auto& sample : out) ASSERT_EQ(sample.cycle, expected++);
  }
  producer.join();
}

TEST(SnapshotBox, GivesEachNewsOnce) {
  SnapshotBox box;
  Snapshot in, out;
  EXPECT_FALSE(box.read(out));
  in.cycles = 7;
  box.publish(in);
  EXPECT_TRUE(box.read(out));
  EXPECT_EQ(out.cycles, 7U);
  EXPECT_FALSE(box.read(out));
}

/// Neither thread waits, and what is read is one snapshot, never parts of two.
TEST(SnapshotBox, IsWholeBetweenTwoThreads) {
  SnapshotBox box;
  constexpr std::uint64_t kLast = 100'000;
  Snapshot in;
  in.slaves.resize(8);
  box.publish_first(in);
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kLast; ++i) {
      in.cycles = i;
      for (auto& slave : in.slaves) slave.propagation_delay_ns = static_cast<std::uint32_t>(i);
      box.publish(in);
    }
  });
  Snapshot out;
  for (std::uint64_t before = 0; before < kLast; before = out.cycles) {
    if (!box.read(out)) continue;
    ASSERT_GE(out.cycles, before);
    for (const auto& slave : out.slaves) ASSERT_EQ(slave.propagation_delay_ns, out.cycles);
  }
  writer.join();
  EXPECT_FALSE(box.read(out)) << "the newest was read";
}

TEST(SnapshotBox, KeepsRoomInEverySlotForWhatIsPublishedInACycle) {
  SnapshotBox box;
  Snapshot in, out;
  in.slaves.resize(50);
  box.publish_first(in);
  // Whoever reads gives back the slot that he had; that one has never held a snapshot.
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(box.read(out));
    EXPECT_EQ(out.slaves.size(), 50U);
    box.publish(in);
  }
}

TEST(EventQueue, LosesNothingUntoldBetweenTwoThreads) {
  EventQueue queue(16);
  constexpr int kCount = 200'000;
  std::atomic<bool> done{false};
  std::thread producer([&] {
    for (int i = 0; i < kCount; ++i) queue.push({i, i, events::SlaveLost{}});
    done = true;
  });
  int told = 0, last = -1;
  std::uint64_t lost = 0;
  for (bool at_end = false; !at_end;) {
    at_end = done;
    for (const auto& event : queue.drain()) {
      if (const auto* what = event.as<events::EventsLost>()) {
        lost += what->count;
        continue;
      }
      ASSERT_GT(event.slave, last);
      last = event.slave;
      ++told;
    }
  }
  producer.join();
  EXPECT_EQ(told + static_cast<int>(lost), kCount);
}

TEST(EventQueue, TellsHowManyWereLost) {
  EventQueue queue(2);
  for (int i = 0; i < 5; ++i) {
    queue.push({i, -1, events::Online{}});
  }
  const auto events = queue.drain();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].time, 1);
  ASSERT_TRUE(events[2].is<events::EventsLost>());
  EXPECT_EQ(events[2].as<events::EventsLost>()->count, 3U);
  EXPECT_TRUE(queue.drain().empty());
}

TEST(CommandQueue, IsFirstInFirstOut) {
  CommandQueue queue;
  EXPECT_FALSE(queue.pop());
  queue.push(ClearStatisticsCommand{});
  queue.push(RequestStateCommand{AlState::kOp});
  EXPECT_TRUE(std::holds_alternative<ClearStatisticsCommand>(queue.pop()->command));
  const auto second = queue.pop();
  ASSERT_TRUE(second && std::holds_alternative<RequestStateCommand>(second->command));
  EXPECT_EQ(std::get<RequestStateCommand>(second->command).state, AlState::kOp);
  EXPECT_TRUE(queue.empty());
}

TEST(CommandQueue, AnswersThoseThatWereAsked) {
  CommandQueue queue;
  EXPECT_TRUE(queue.push(ClearStatisticsCommand{}));
  const auto first = queue.ask(RequestStateCommand{AlState::kOp});
  const auto second = queue.ask(ResetDcmStatusCommand{});
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
  EXPECT_FALSE(queue.take_answer());
  for (Nanoseconds time = 1; const auto entry = queue.pop(); ++time) {
    const bool state = std::holds_alternative<RequestStateCommand>(entry->command);
    queue.answer(entry->id, state ? std::optional(Error{ErrorCode::kAlTimeout, "drive", {}}) : std::nullopt, time);
  }
  const auto refused = queue.take_answer();
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->id, *first);
  ASSERT_TRUE(refused->refused);
  EXPECT_EQ(refused->refused->code, ErrorCode::kAlTimeout);
  EXPECT_EQ(refused->time, 2);
  const auto done = queue.take_answer();
  ASSERT_TRUE(done);
  EXPECT_EQ(done->id, *second);
  EXPECT_FALSE(done->refused);
  EXPECT_FALSE(queue.take_answer()) << "who pushed wants none";
}

TEST(CommandQueue, NoAnswerIsLostForWhoDoesNotLook) {
  CommandQueue queue;
  std::size_t asked = 0;
  while (queue.ask(ClearStatisticsCommand{})) {
    ++asked;
    queue.answer(queue.pop()->id, {}, 0);
  }
  EXPECT_EQ(asked, CommandQueue::kCapacity);
  std::size_t answers = 0;
  while (queue.take_answer()) ++answers;
  EXPECT_EQ(answers, asked);
  EXPECT_TRUE(queue.ask(ClearStatisticsCommand{}));
}

TEST(CommandQueue, SaysSoWhenNobodyListens) {
  CommandQueue queue;
  for (std::size_t i = 0; i < CommandQueue::kCapacity; ++i) EXPECT_TRUE(queue.push(ClearStatisticsCommand{}));
  EXPECT_FALSE(queue.push(ClearStatisticsCommand{}));
  EXPECT_TRUE(queue.pop());
  EXPECT_TRUE(queue.push(ClearStatisticsCommand{}));
}

}  // namespace
}  // namespace syncline
