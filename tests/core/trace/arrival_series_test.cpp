// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "dc/sync0_arrival.h"
#include "support/random.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

constexpr Nanoseconds kArrivalEpoch = 850'000'000LL * kSecond;

SampleStore::Layout arrival_layout() {
  SampleStore::Layout layout;
  layout.slaves = 4;
  layout.cycle_capacity = 8192;
  layout.sync0 = {
      {kMillisecond, 40'000, 20'000, 1}, {6 * kMillisecond, -30'000, 25'000, 6}, {125'000, 0, 20'000, 0}, {}};
  layout.sync_grid = 6 * kMillisecond;
  return layout;
}

Snapshot with_delays(Nanoseconds time) {
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.slaves.resize(4);
  for (std::size_t i = 0; i < 4; ++i) {
    snapshot.slaves[i].present = snapshot.slaves[i].dc_enabled = true;
    snapshot.slaves[i].propagation_delay_ns = static_cast<std::uint32_t>(700 * i);
  }
  return snapshot;
}

CycleSample arriving(std::uint64_t cycle, Nanoseconds late) {
  CycleSample s;
  s.cycle = cycle;
  s.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.reference_time = kArrivalEpoch + s.send_time + late;
  s.sync_base = 123'456;
  s.flags = CycleSample::kReferenceValid | CycleSample::kSyncBaseValid;
  return s;
}

/// Who was not looked at for long makes room, and is made again.
TEST(ArrivalSeries, KeepsThoseThatWereAskedForLast) {
  auto layout = arrival_layout();
  layout.slaves = 40;
  layout.sync0.assign(40, {kMillisecond, 40'000, 20'000, 1});
  SampleStore store(layout);
  auto delays = with_delays(0);
  delays.slaves.resize(40, delays.slaves[1]);
  store.append(delays);
  for (std::uint64_t cycle = 1; cycle <= 500; ++cycle) {
    const auto sample = arriving(cycle, 100'000);
    store.append(std::span(&sample, 1));
  }
  for (std::size_t slave = 0; slave < ArrivalSeries::kMostKept; ++slave)
    (void)store.series(Signal::kArrivalPhase, slave);
  const auto full = store.memory_bytes();
  const auto* const kept = &store.series(Signal::kArrivalPhase, 0);
  for (std::size_t slave = ArrivalSeries::kMostKept; slave < 40; ++slave) {
    EXPECT_EQ(store.series(Signal::kArrivalPhase, slave).count(INT64_MIN, INT64_MAX), 500U) << slave;
    EXPECT_EQ(&store.series(Signal::kArrivalPhase, 0), kept) << "it is looked at all the time";
    EXPECT_LE(store.memory_bytes(), full) << slave;
  }
  EXPECT_EQ(store.series(Signal::kArrivalPhase, 1).count(INT64_MIN, INT64_MAX), 500U) << "made again";
}

/// One series of the bus is enough for all of them, exactly, however often somebody looks meanwhile.
TEST(ArrivalSeries, OfEachSlaveIsThatOfItsOwnGrid) {
  SampleStore store(arrival_layout());
  store.append(with_delays(0));
  Random random(3);
  std::vector<CycleSample> samples;
  for (std::uint64_t cycle = 1; cycle <= 5'000; ++cycle) {
    samples.push_back(arriving(cycle, static_cast<Nanoseconds>(random.next() % 900'000)));
    store.append(std::span(&samples.back(), 1));
    if (random.next() % 100 == 0) (void)store.series(Signal::kArrivalPhase, random.next() % 4);
  }
  for (std::size_t slave = 0; slave < 3; ++slave) {
    const auto sync0 = store.sync0(slave);
    std::size_t i = 0;
    store.series(Signal::kArrivalPhase, slave).for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds time, float phase) {
      const auto& of = samples.at(i++);
      const auto came = dc::outputs_arrival(of.reference_time, static_cast<Nanoseconds>(700 * slave), sync0.wire);
      const dc::Sync0Grid grid{of.sync_base + sync0.shift, sync0.period};
      ASSERT_EQ(time, of.send_time);
      ASSERT_EQ(static_cast<Nanoseconds>(phase), dc::sync0_arrival(grid, came).phase) << slave << ' ' << i;
    });
    EXPECT_EQ(i, samples.size());
  }
  EXPECT_TRUE(store.series(Signal::kArrivalPhase, 3).empty()) << "not known";
}

TEST(ArrivalSeries, WhatIsNotKnownIsAGap) {
  SampleStore store(arrival_layout());
  store.append(std::vector{arriving(1, 0)});
  store.append(with_delays(2 * kMillisecond - 1));
  auto lost = arriving(3, 0);
  lost.flags = CycleSample::kFrameLost | CycleSample::kSyncBaseValid;
  auto old = arriving(4, 0);
  old.flags = CycleSample::kReferenceValid;
  store.append(std::vector{arriving(2, 0), lost, old, arriving(5, 0), arriving(9, 0)});
  std::vector<bool> known;
  store.series(Signal::kArrivalPhase, 0).for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds, float phase) {
    known.push_back(!std::isnan(phase));
  });
  EXPECT_EQ(known, (std::vector{false, true, false, false, true, false, true}))
      << "no delay yet, a frame, one lost, one without the base, a frame, cycles missing, a frame";
}

}  // namespace
}  // namespace syncline
