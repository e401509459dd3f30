// SPDX-License-Identifier: Apache-2.0
#include "reports/run_plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "record/run_record.h"
#include "reports/run_pictures.h"
#include "trace/min_max_series.h"

namespace syncline::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr Nanoseconds kPlottedFrom = 830'000'000 * kSecond;

NetworkConfig plotted_machine() {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  for (const auto* name : {"Coupler", "Servo <left> & \"right\""}) config.slaves.emplace_back().name = name;
  return config;
}

/// Three seconds with an outage from 1 s to 1.2 s.
class RunPlots : public testing::Test {
 protected:
  RunPlots() {
    for (int i = 0; i < 3000; ++i) {
      CycleSample sample;
      sample.cycle = static_cast<std::uint64_t>(i);
      sample.send_time = kPlottedFrom + i * kMillisecond;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                     CycleSample::kReferenceValid;
      if (i >= 1000 && i < 1200) sample.flags = CycleSample::kFrameLost | CycleSample::kDcmActive;
      sample.deviation_ns = 40;
      sample.dcm_error_ns = i % 2 == 0 ? 300 : -300;
      sample.slave_position = 1;
      sample.slave_deviation_ns = -40;
      record.add(std::span(&sample, 1));
      if (i % 100 != 99) continue;
      Snapshot snapshot;
      snapshot.time = sample.send_time;
      snapshot.online = true;
      snapshot.slaves.resize(2);
      for (auto& slave : snapshot.slaves) slave.present = true;
      snapshot.slaves[1].sm2_missed.known = true;
      snapshot.slaves[1].sm2_missed.missed = i >= 1200 ? 200 : 0;
      record.add(snapshot);
    }
    record.add(Event{kPlottedFrom + kSecond, -1, events::FramesLost{200}});
  }
  std::string plots(std::vector<NamedSignal> signals, Nanoseconds from = 0, Nanoseconds to = 3 * kSecond) {
    return plots_svg({.run = record,
                      .begin = kPlottedFrom + from,
                      .end = kPlottedFrom + to,
                      .signals = std::move(signals),
                      .name = "run <1>.slrec"});
  }
  static std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
  }

  RunRecord record{plotted_machine(), 8192, RunLimits{kMillisecond, 127, 4000}, 0x1000};
};

TEST_F(RunPlots, AreAWholeFileWithAllThatBelongsToThem) {
  const auto usual = usual_plots(record);
  ASSERT_EQ(usual,
            (std::vector<NamedSignal>{{Signal::kDeviation, 0}, {Signal::kDcmError, 0}, {Signal::kSm2Missed, 1}}));
  const auto svg = plots(usual);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  EXPECT_THAT(svg, HasSubstr("run &lt;1&gt;.slrec: 2026-04-20"));
  EXPECT_THAT(svg, HasSubstr("cycle 1000 us"));
  EXPECT_THAT(svg, HasSubstr("#1 Servo &lt;left&gt; &amp; &quot;right&quot;: SM2 events missed"));
  EXPECT_EQ(count(svg, "stroke-dasharray"), 3U) << "one limit of a magnitude, two of what has a sign";
  EXPECT_EQ(count(svg, kFaultInk), 3U) << "the fault in each";
  EXPECT_EQ(count(svg, "opacity=\"0.35\""), 3U) << "the outage in each";
  EXPECT_THAT(svg, HasSubstr(">1.5 s<")) << "the middle of the axis";
}

TEST_F(RunPlots, OfARangeCountFromTheBeginOfTheRun) {
  const auto svg = plots({{Signal::kDcmError, 0}}, 2 * kSecond, 2500 * kMillisecond);
  EXPECT_THAT(svg, HasSubstr(">2 s<"));
  EXPECT_THAT(svg, HasSubstr(">2.5 s<"));
  EXPECT_EQ(count(svg, kFaultInk), 0U);
  EXPECT_EQ(count(svg, "opacity=\"0.35\""), 0U);
}

TEST_F(RunPlots, WithoutAValueSaySo) {
  const auto svg = plots({{Signal::kArrivalPhase, 1}, {Signal::kDeviation, 0}});
  EXPECT_EQ(count(svg, "no value in this range"), 1U);
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS);
}

/// No column of a picture loses the one sample that is unlike the others, and a gap is none of the curve.
TEST(RunPictures, ACourseHasEachValueAndNoGap) {
  MinMaxSeries series(100'000);
  for (int i = 0; i < 60'000; ++i) {
    const bool gap = i >= 30'000 && i < 40'000;
    series.append(kPlottedFrom + i * kMillisecond, gap ? std::nanf("") : i == 12'345 ? 900.0F : 10.0F);
  }
  const auto svg =
      course_svg({.series = series, .begin = kPlottedFrom, .end = kPlottedFrom + 59'999 * kMillisecond, .unit = "ppm"});
  EXPECT_THAT(svg, HasSubstr(">1000 ppm<"));
  const auto path = svg.substr(svg.find("<path"));
  std::size_t columns = 0, tall = 0;
  for (auto at = path.find('M'); at != std::string::npos && at < path.find("/>"); at = path.find('M', at + 1)) {
    double x = 0, y = 0, wide = 0, high = 0;
    ASSERT_EQ(std::sscanf(path.c_str() + at, "M%lf %lfh%lfv%lf", &x, &y, &wide, &high), 4);
    ++columns;
    tall += high > 50 ? 1 : 0;
    EXPECT_FALSE(x > 64 + 624 * 0.51 && x < 64 + 624 * 0.66) << "in the gap";
  }
  EXPECT_EQ(tall, 1U) << "the spike";
  EXPECT_NEAR(static_cast<double>(columns), 624 * 5 / 6.0, 3);
}

}  // namespace
}  // namespace syncline::reports
