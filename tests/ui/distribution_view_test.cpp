// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/distribution_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <memory>

#include "channels/cycle_sample.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/histogram_plot.h"

namespace syncline::ui {
namespace {

constexpr Nanoseconds kFirstCycle = 830'000'000 * kSecond;

/// Deviations 0..99 ns in turn, 100 of each; one of 900 ns at 5 s.
class DistributionViewTest : public testing::Test {
 protected:
  void SetUp() override {
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic.front().cycle_time = kMillisecond;
    for (const char* name : {"1 Coupler", "2 Servo"}) config.slaves.emplace_back().name = name;
    config.dc.enabled = true;
    config.dc.sync_window.enabled = true;
    config.dc.sync_window.exponent = 6;
    record = std::make_unique<RunRecord>(config);
    std::vector<CycleSample> samples(10'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      auto& sample = samples[i];
      sample.cycle = i;
      sample.send_time = kFirstCycle + static_cast<Nanoseconds>(i) * kMillisecond;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                     CycleSample::kReferenceValid;
      sample.deviation_ns = i == 5000 ? 900 : static_cast<std::uint32_t>(i % 100);
      sample.slave_position = 1;
      sample.slave_deviation_ns = i % 2 == 0 ? -20 : 20;
    }
    record->add(samples);
    strip.resize(1280, 230);
    strip.setRecord(record.get());
    strip.timeView()->setSpan(20 * kSecond);
    strip.show();
    strip.showBody(LiveStrip::Body::kDistribution);
    settle();
  }
  void settle() {
    for (int i = 0; i < 3; ++i) {
      strip.refresh();
      QApplication::processEvents();
    }
  }
  DistributionView& view() { return *strip.distribution(); }
  QTableWidget* table(const char* name) { return view().findChild<QTableWidget*>(QLatin1String(name)); }
  std::string figure(int row, int column = 0) {
    return table("distributionFigures")->item(row, column)->text().toStdString();
  }
  const HistogramPlot::Steps& steps(std::size_t i = 0) { return view().plot()->steps().at(i); }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
};

TEST_F(DistributionViewTest, CountsEverySampleAndSaysTheQuantiles) {
  ASSERT_TRUE(view().isVisible());
  EXPECT_TRUE(view().complete());
  std::uint64_t sum = 0;
  for (const auto count : steps().bins) sum += count;
  EXPECT_EQ(sum + steps().below + steps().above, 10'000U);
  EXPECT_EQ(figure(0), "50 ns");
  EXPECT_EQ(figure(1), "99 ns");
  EXPECT_EQ(figure(4), "900 ns") << "a single sample is the largest";
  EXPECT_EQ(figure(5), "10000");
}

/// An or of magnitudes is more than any of them.
TEST_F(DistributionViewTest, AnUpperEstimateIsCalledOne) {
  EXPECT_EQ(figure(4), "900 ns");
  std::vector<CycleSample> more(11'000);
  for (std::size_t i = 0; i < more.size(); ++i) {
    auto& sample = more[i];
    sample.cycle = 10'000 + i;
    sample.send_time = kFirstCycle + static_cast<Nanoseconds>(sample.cycle) * kMillisecond;
    sample.flags = CycleSample::kFollowersRead | CycleSample::kDeviationValid;
    sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
    sample.slaves_sync = sample.master_sync = SyncState::kInSync;
    sample.deviation_ns = sample.deviation_ored_ns = 15;
    sample.slave_position = -1;
  }
  record->add(more);
  settle();
  ASSERT_TRUE(record->overview().is_deviation_ored());
  EXPECT_EQ(figure(0), "\u2264 15 ns");
  EXPECT_EQ(figure(4), "\u2264 900 ns");
  EXPECT_NE(figure(5).find("000"), std::string::npos) << "a count is none";
}

TEST_F(DistributionViewTest, WhatLiesOutsideIsCountedAtTheEnds) {
  view().findChild<QComboBox*>(QStringLiteral("distributionAxis"))->setCurrentIndex(1);  // limit 63 ns
  settle();
  EXPECT_EQ(steps().above, 1U);
  EXPECT_EQ(steps().below, 0U);
  EXPECT_EQ(figure(4), "900 ns");
}

TEST_F(DistributionViewTest, ABinListsItsSamplesAndLeadsToTheirMoment) {
  const auto& bins = steps().bins;
  std::size_t last = bins.size();
  while (bins[last - 1] == 0) --last;
  auto* plot = view().plot();
  QTest::mouseClick(plot, Qt::LeftButton, {}, plot->binArea(static_cast<std::ptrdiff_t>(last) - 1).center().toPoint());
  auto* moments = table("distributionMoments");
  ASSERT_TRUE(moments->isVisible());
  ASSERT_EQ(moments->rowCount(), 1);
  EXPECT_EQ(moments->item(0, 0)->text(), QStringLiteral("5.000000 s"));
  EXPECT_EQ(moments->item(0, 1)->text(), QStringLiteral("900 ns"));
  Q_EMIT moments->itemActivated(moments->item(0, 0));
  EXPECT_FALSE(view().isVisible()) << "the plots show the moment";
  EXPECT_EQ(strip.cursors()->at(CursorSet::kA), kFirstCycle + 5 * kSecond);
}

TEST_F(DistributionViewTest, CountsBetweenTheCursors) {
  view().findChild<QComboBox*>(QStringLiteral("distributionRange"))->setCurrentIndex(1);
  settle();
  const auto* state = view().findChild<QLabel*>(QStringLiteral("distributionState"));
  EXPECT_THAT(state->text().toStdString(), testing::HasSubstr("two cursors"));
  strip.cursors()->set(CursorSet::kA, kFirstCycle + kSecond);
  strip.cursors()->set(CursorSet::kB, kFirstCycle + 2 * kSecond);
  settle();
  EXPECT_EQ(figure(5), "1001");
  EXPECT_EQ(figure(4), "99 ns");
}

TEST_F(DistributionViewTest, SignalsLieOverEachOtherAndInTheTable) {
  view().setSources({{Signal::kDeviation, 0}, {Signal::kSlaveDeviation, 1}});
  settle();
  ASSERT_EQ(view().plot()->steps().size(), 2U);
  EXPECT_EQ(steps(1).name, QStringLiteral("#1 2 Servo"));
  EXPECT_EQ(figure(0, 1), "-20 ns");
  EXPECT_EQ(figure(4, 1), "20 ns");
  EXPECT_THAT(strip.csv(), testing::StartsWith("from,to,deviation_ns,deviation_ns #1\n,"));
}

TEST_F(DistributionViewTest, ABarStandsWhereItsBinIs) {
  const auto image = view().plot()->grab().toImage();
  const auto* plot = view().plot();
  const auto color = [&](std::ptrdiff_t bin) {
    const auto box = plot->binArea(bin);
    const double ratio = image.devicePixelRatio();
    return image.pixelColor(QPoint(static_cast<int>(box.center().x() * ratio),
                                   static_cast<int>((box.bottom() - plot->heightOf(1) / 2) * ratio)));
  };
  const auto& bins = steps().bins;
  const auto bare = color(-1);
  std::size_t empty = 0;
  while (bins[empty] != 0) ++empty;
  EXPECT_NE(color(0), bare);
  EXPECT_NE(color(0), color(static_cast<std::ptrdiff_t>(empty)));
}

}  // namespace
}  // namespace syncline::ui
