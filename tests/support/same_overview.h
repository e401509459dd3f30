// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "trace/sync_overview.h"

namespace syncline::test {

inline void expect_same(const SyncLamp& is, const SyncLamp& was) {
  EXPECT_EQ(is.state, was.state);
  EXPECT_EQ(is.since, was.since);
  EXPECT_EQ(is.last_lost, was.last_lost);
  EXPECT_EQ(is.times_lost, was.times_lost);
  EXPECT_EQ(is.last_away, was.last_away);
  EXPECT_EQ(is.times_away, was.times_away);
  EXPECT_EQ(is.back_since, was.back_since);
}

/// Bit for bit.
inline void expect_same(const OverviewFigure& is, const OverviewFigure& was) {
  const auto same = [](const std::optional<OverviewFigure::Reading>& a,
                       const std::optional<OverviewFigure::Reading>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->time, b->time);
    EXPECT_EQ(a->value, b->value);
  };
  same(is.now, was.now);
  same(is.largest, was.largest);
  EXPECT_EQ(is.statistics.count(), was.statistics.count());
  EXPECT_EQ(is.statistics.mean(), was.statistics.mean());
  EXPECT_EQ(is.statistics.rms(), was.statistics.rms());
  EXPECT_EQ(is.statistics.min(), was.statistics.min());
  EXPECT_EQ(is.statistics.max(), was.statistics.max());
  EXPECT_EQ(is.magnitudes.count(), was.magnitudes.count());
  for (const double fraction : {0.5, 0.9, 0.999, 0.9999})
    EXPECT_EQ(is.magnitudes.percentile(fraction), was.magnitudes.percentile(fraction));
}

inline void expect_same(const FaultLog& is, const FaultLog& was) {
  EXPECT_EQ(is.count(), was.count());
  ASSERT_EQ(is.episodes().size(), was.episodes().size());
  for (std::size_t i = 0; i < is.episodes().size(); ++i) {
    const auto &a = is.episodes()[i], &b = was.episodes()[i];
    EXPECT_EQ(a.begin, b.begin);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.left_out, b.left_out);
    ASSERT_EQ(a.faults.size(), b.faults.size());
    for (std::size_t j = 0; j < a.faults.size(); ++j) {
      EXPECT_EQ(a.faults[j].first, b.faults[j].first);
      EXPECT_EQ(a.faults[j].last, b.faults[j].last);
      EXPECT_EQ(a.faults[j].slave, b.faults[j].slave);
      EXPECT_EQ(a.faults[j].count, b.faults[j].count);
      EXPECT_EQ(a.faults[j].over, b.faults[j].over);
      ASSERT_EQ(a.faults[j].event.has_value(), b.faults[j].event.has_value());
      if (a.faults[j].event) {
        EXPECT_EQ(a.faults[j].event->kind(), b.faults[j].event->kind());
      }
    }
  }
}

/// Verdicts, figures and faults, bit for bit.
inline void expect_same(const SyncOverview& is, const SyncOverview& was) {
  EXPECT_EQ(is.armed, was.armed);
  EXPECT_EQ(is.begin, was.begin);
  EXPECT_EQ(is.end, was.end);
  EXPECT_EQ(is.state, was.state);
  expect_same(is.slaves, was.slaves);
  expect_same(is.master, was.master);
  expect_same(is.deviation, was.deviation);
  expect_same(is.dcm_error, was.dcm_error);
  expect_same(is.dcm_filtered, was.dcm_filtered);
  ASSERT_EQ(is.dcm_lasting.largest().has_value(), was.dcm_lasting.largest().has_value());
  if (is.dcm_lasting.largest()) {
    EXPECT_EQ(is.dcm_lasting.largest()->time, was.dcm_lasting.largest()->time);
    EXPECT_EQ(is.dcm_lasting.largest()->magnitude, was.dcm_lasting.largest()->magnitude);
  }
  EXPECT_EQ(is.followed, was.followed);
  EXPECT_EQ(is.missed.count, was.missed.count);
  EXPECT_EQ(is.missed.last, was.missed.last);
  EXPECT_EQ(is.missed.by_slave, was.missed.by_slave);
  EXPECT_EQ(is.missed.known, was.missed.known);
  expect_same(is.faults, was.faults);
}

}  // namespace syncline::test
