// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/stability_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QMenu>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <sstream>

#include "support/speak.h"
#include "support/ui_test_support.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/mask_chooser.h"
#include "ui/plots/plot_colors.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr Nanoseconds kStudyBegin = 830'000'000 * kSecond;
constexpr std::size_t kStudyCycles = 20'000;

/// Cycles of 1 ms, 20 s, and a task of 4 ms beside them. Slaves 1 and 2 are read in turn: 1 with white noise of
/// -100..100 ns, 2 with -20..20 ns. The DCM error has lines at 33 and 250 Hz. Round trips drift. The largest deviation
/// is constant.
class StabilityViewTest : public testing::Test {
 protected:
  void SetUp() override { begin(configuration()); }
  static NetworkConfig configuration() {
    NetworkConfig config;
    config.cyclic.resize(2);
    config.cyclic[0].cycle_time = kMillisecond;
    config.cyclic[1].cycle_time = 4 * kMillisecond;
    for (const char* name : {"1 Coupler", "2 Servo", "3 Servo"}) config.slaves.emplace_back().name = name;
    config.dc.enabled = true;
    config.dc.sync_window.enabled = true;
    config.dc.sync_window.exponent = 6;
    return config;
  }
  static CycleSample sample(std::size_t i, std::mt19937& random) {
    CycleSample sample;
    sample.cycle = i;
    sample.send_time = kStudyBegin + static_cast<Nanoseconds>(i) * kMillisecond;
    sample.reference_time = sample.send_time;
    sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                   CycleSample::kReferenceValid;
    sample.deviation_ns = 40;
    sample.slave_position = static_cast<std::int16_t>(1 + i % 2);
    sample.slave_deviation_ns =
        i % 2 == 0 ? static_cast<int>(random() % 201) - 100 : static_cast<int>(random() % 41) - 20;
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) * 1e-3;
    sample.dcm_error_ns =
        static_cast<std::int32_t>(std::lround(300 * std::sin(33 * turn) + 1000 * std::sin(250 * turn + 0.5)));
    sample.round_trip_ns = static_cast<std::int32_t>(1e-4 * static_cast<double>(i) * static_cast<double>(i)) +
                           static_cast<std::int32_t>(random() % 21);
    return sample;
  }
  /// Without [gap, gap + 100) of the cycles.
  void begin(const NetworkConfig& config, std::size_t gap = kStudyCycles) {
    auto next = std::make_unique<RunRecord>(config);
    std::mt19937 random(5);
    std::vector<CycleSample> samples;
    for (std::size_t i = 0; i < kStudyCycles; ++i) {
      const auto one = sample(i, random);
      if (i < gap || i >= gap + 100) samples.push_back(one);
    }
    next->add(samples);
    strip.resize(1280, 260);
    strip.setRecord(next.get());
    record = std::move(next);
    strip.timeView()->setSpan(30 * kSecond);
    strip.show();
    strip.showBody(LiveStrip::Body::kStability);
    settle();
  }
  void settle() {
    ASSERT_TRUE(test::waitFor([this] {
      strip.refresh();
      return view().complete();
    }));
  }
  void choose(Signal signal, std::size_t slave = 0) {
    view().setSources({{signal, slave}});
    settle();
  }
  void showFigure(StabilityView::Figure figure) {
    view().setFigure(figure);
    settle();
  }
  StabilityView& view() { return *strip.stability(); }
  std::string words() { return view().words().replace(QChar(0x00A0), u' ').toStdString(); }
  const LogLogPlot::Curve& curve(std::size_t i = 0) { return view().plot()->curves().at(i); }
  std::string reading() { return view().plot()->reading().replace(QChar(0x00A0), u' ').toStdString(); }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
};

TEST_F(StabilityViewTest, WhiteNoiseFallsWithSlopeMinusOneAndIsCalledJitter) {
  ASSERT_TRUE(view().isVisible());
  ASSERT_EQ(view().sources(), (std::vector<SignalSource>{{Signal::kSlaveDeviation, 1}})) << "the first that is read";
  EXPECT_EQ(curve().name, QStringLiteral("#1 2 Servo"));
  ASSERT_GE(curve().line.size(), 10U);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto point = curve().line[i];
    const double tau = 0.002 * std::pow(2, static_cast<double>(i));
    EXPECT_NEAR(point.x(), tau, 1e-6);
    const double wanted = std::sqrt(3) * 58.02e-9 / tau;
    EXPECT_NEAR(point.y(), wanted, 0.05 * wanted) << tau;
  }
  EXPECT_THAT(words(), HasSubstr("Jitter at short times: ADEV falls with slope \u22121.0"));
  EXPECT_THAT(words(), Not(HasSubstr("Drift")));
  EXPECT_THAT(words(), Not(HasSubstr("Hunting")));
  EXPECT_THAT(words(), HasSubstr("10000 samples, one each 2.00 ms, no gap"));
  EXPECT_THAT(words(), Not(HasSubstr("No limit is set"))) << "it is not asked for";
}

TEST_F(StabilityViewTest, NothingIsDrawnForTimesWithTooFewWindows) {
  const auto last = curve().line.back();
  EXPECT_NEAR(last.x(), 4.096, 1e-3) << "four windows in 20 s; of the next there are two";
  EXPECT_TRUE(curve().stops.back().weak);
  EXPECT_FALSE(curve().stops.front().weak);
  EXPECT_THAT(words(), HasSubstr("\u03C4 2.00 ms to 4.10 s"));
}

TEST_F(StabilityViewTest, TellsDriftAndConstantsFromJitter) {
  choose(Signal::kRoundTrip);
  EXPECT_THAT(words(), HasSubstr("Drift at long times: ADEV rises with slope +1.0"));
  choose(Signal::kDeviation);
  EXPECT_THAT(words(), HasSubstr("Constant: nothing moves"));
  EXPECT_THAT(words(), HasSubstr("A magnitude"));
  EXPECT_TRUE(curve().line.empty()) << "no value has a logarithm";
}

TEST_F(StabilityViewTest, MtieIsHeldAgainstTheSyncWindow) {
  showFigure(StabilityView::Figure::kMtie);
  EXPECT_EQ(view().plot()->limit().value, 126) << "values within \u00B163 ns are never further apart";
  EXPECT_THAT(words(), HasSubstr("Beyond the limit: MTIE is above 126 ns for times from 2.00 ms on"));
  EXPECT_THAT(words(), HasSubstr("\u00B163.0 ns"));
  EXPECT_EQ(curve().line.back().y(), 200);
  choose(Signal::kSlaveDeviation, 2);
  EXPECT_THAT(words(), HasSubstr("MTIE keeps the limit: it reaches 40.0 ns of 126 ns"));
  choose(Signal::kDeviation);
  EXPECT_EQ(view().plot()->limit().value, 63) << "a magnitude has no other side";
  showFigure(StabilityView::Figure::kAdev);
  EXPECT_EQ(view().plot()->limit().value, 0);
}

TEST_F(StabilityViewTest, AMaskIsHeldAgainstTheFigureAndItsViolationsAreMarkedAndSaid) {
  showFigure(StabilityView::Figure::kMtie);
  view().mask()->setKind(MaskChooser::Kind::kOwn);
  settle();
  EXPECT_THAT(words(), HasSubstr("There is no mask yet."));
  view().mask()->setOwn(QStringLiteral("10ms 150ns; 100ms 250ns"));
  settle();
  // White noise of -100..100 ns spans nearly 200 ns in ten milliseconds.
  EXPECT_THAT(words(), HasSubstr("Beyond the mask at "));
  EXPECT_THAT(words(), HasSubstr(" observation times, from \u03C4 16.0 ms on; furthest at 16.0 ms: "));
  const auto& stops = curve().stops;
  for (const auto& stop : stops) {
    const double allowed = 150 * std::pow(stop.at.x() / 0.01, std::log10(250.0 / 150));
    const bool asked = stop.at.x() >= 0.01 && stop.at.x() <= 0.1;
    EXPECT_EQ(stop.bad, asked && stop.at.y() > allowed) << stop.at.x();
  }
  EXPECT_TRUE(std::ranges::any_of(stops, &LogLogPlot::Stop::bad));
  const auto& line = view().plot()->limit().line;
  ASSERT_GE(line.size(), 2U);
  EXPECT_DOUBLE_EQ(line.front().x(), 0.01);
  EXPECT_DOUBLE_EQ(line.back().y(), 250);
  view().mask()->setOwn(QStringLiteral("1us"));
  settle();
  EXPECT_THAT(words(), HasSubstr("Keeps the mask; closest to it at \u03C4"));
  EXPECT_TRUE(std::ranges::none_of(curve().stops, &LogLogPlot::Stop::bad));
  view().mask()->setOwn(QStringLiteral("1s 5 apples"));
  settle();
  EXPECT_THAT(words(), HasSubstr("Nobody understands \"1s 5 apples\" in the mask."));
  EXPECT_TRUE(view().plot()->limit().line.empty());
}

TEST_F(StabilityViewTest, ATwentyFifthOfTheCycleIsAMaskOfEachFigure) {
  view().mask()->setKind(MaskChooser::Kind::kCycle);
  for (const auto figure : {StabilityView::Figure::kAdev, StabilityView::Figure::kTdev, StabilityView::Figure::kMtie}) {
    showFigure(figure);
    EXPECT_THAT(words(), HasSubstr("Keeps the mask"));
    EXPECT_GE(view().plot()->limit().line.size(), 2U);
  }
  EXPECT_EQ(view().plot()->limit().line.front().y(), 2 * 40'000) << "twice 1 ms / 25";
  showFigure(StabilityView::Figure::kSpectrum);
  EXPECT_FALSE(view().mask()->isEnabled());
  EXPECT_THAT(words(), Not(HasSubstr("mask")));
}

TEST_F(StabilityViewTest, SaysThatNoLimitIsSet) {
  auto config = configuration();
  config.dc.sync_window.enabled = false;
  begin(config);
  showFigure(StabilityView::Figure::kMtie);
  EXPECT_EQ(view().plot()->limit().value, 0);
  EXPECT_THAT(words(), HasSubstr("No limit is set"));
}

TEST_F(StabilityViewTest, SinesAreLinesWithFrequencyAmplitudeAndWhatTheyMayBe) {
  choose(Signal::kDcmError);
  showFigure(StabilityView::Figure::kSpectrum);
  ASSERT_EQ(curve().stops.size(), 2U);
  EXPECT_NEAR(curve().stops[0].at.x(), 250, 0.01);
  EXPECT_NEAR(curve().stops[0].at.y(), 1000, 10);
  EXPECT_EQ(curve().stops[0].note.toStdString(), "task, 250\u00A0Hz");
  EXPECT_NEAR(curve().stops[1].at.x(), 33, 0.01);
  EXPECT_NEAR(curve().stops[1].at.y(), 300, 3);
  EXPECT_EQ(curve().stops[1].note, QString()) << "nothing known has 33 Hz";
  EXPECT_THAT(words(), HasSubstr("250 Hz"));
  EXPECT_THAT(words(), HasSubstr("a hint, no proof"));
  choose(Signal::kSlaveDeviation, 1);
  EXPECT_THAT(words(), HasSubstr("No line stands out"));
}

TEST_F(StabilityViewTest, GapsAreSaid) {
  begin(configuration(), 12'000);
  EXPECT_THAT(words(), HasSubstr("9950 samples, one each 2.00 ms, 1 gap"));
  EXPECT_NEAR(curve().line.front().y(), std::sqrt(3) * 58.02e-9 / 0.002, 0.05 * std::sqrt(3) * 58.02e-9 / 0.002);
}

TEST_F(StabilityViewTest, CountsBetweenTheCursors) {
  auto* range = view().findChild<QComboBox*>(QStringLiteral("stabilityRange"));
  range->setCurrentIndex(1);
  strip.refresh();
  const auto* state = view().findChild<ValueLabel*>(QStringLiteral("stabilityState"));
  EXPECT_THAT(state->text().toStdString(), HasSubstr("two cursors"));
  EXPECT_TRUE(curve().line.empty()) << "of another range there is nothing to see";
  strip.cursors()->set(CursorSet::kA, kStudyBegin + kSecond);
  strip.cursors()->set(CursorSet::kB, kStudyBegin + 2 * kSecond);
  settle();
  EXPECT_THAT(words(), HasSubstr("501 samples"));
  strip.cursors()->set(CursorSet::kB, kStudyBegin + kSecond + 30 * kMillisecond);
  settle();
  EXPECT_THAT(words(), HasSubstr("Too few samples for a verdict"));
  strip.cursors()->clear();
  strip.refresh();
  EXPECT_TRUE(curve().line.empty());
}

TEST_F(StabilityViewTest, FollowsWhatComesWhileItIsLive) {
  const auto before = words();
  std::mt19937 random(9);
  std::vector<CycleSample> samples;
  for (std::size_t i = kStudyCycles; i < kStudyCycles + 4000; ++i) samples.push_back(sample(i, random));
  record->add(samples);
  settle();
  EXPECT_THAT(words(), HasSubstr("12000 samples"));
}

TEST_F(StabilityViewTest, CurvesLieOverEachOtherAndOneIsInFront) {
  view().setSources({{Signal::kSlaveDeviation, 1}, {Signal::kSlaveDeviation, 2}, {Signal::kDcmError, 0}});
  settle();
  ASSERT_EQ(view().plot()->curves().size(), 3U);
  EXPECT_NE(curve(0).color, curve(1).color);
  EXPECT_EQ(curve(1).color, plot_colors::trace(view().palette(), 1)) << "as in the other plots";
  showFigure(StabilityView::Figure::kMtie);
  EXPECT_THAT(words(), HasSubstr("Beyond the limit"));
  Q_EMIT view().findChild<QTextBrowser*>(QStringLiteral("stabilityWords"))->anchorClicked(QUrl(QStringLiteral("1")));
  settle();
  EXPECT_THAT(words(), HasSubstr("keeps the limit"));
}

TEST_F(StabilityViewTest, KeysReadPointsAndChangeTheCurve) {
  view().setSources({{Signal::kSlaveDeviation, 1}, {Signal::kSlaveDeviation, 2}});
  showFigure(StabilityView::Figure::kMtie);
  auto* plot = view().plot();
  EXPECT_EQ(reading(), "");
  QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_THAT(reading(), HasSubstr("#1 2 Servo\n2.00 ms: "));
  QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_THAT(reading(), HasSubstr("4.00 ms: 20"));
  EXPECT_THAT(reading(), HasSubstr("windows of"));
  EXPECT_THAT(plot->accessibleDescription().toStdString(), HasSubstr("windows of"));
  QTest::keyClick(plot, Qt::Key_Down);
  EXPECT_THAT(reading(), HasSubstr("#2 3 Servo\n4.00 ms: "));
  EXPECT_THAT(words(), HasSubstr("keeps the limit")) << "its words stand beside it";
}

TEST_F(StabilityViewTest, ThePointerReadsThePointUnderIt) {
  showFigure(StabilityView::Figure::kMtie);
  auto* plot = view().plot();
  QTest::mouseMove(plot, plot->placeOf(curve().line[3]).toPoint());
  EXPECT_THAT(reading(), HasSubstr("16.0 ms: 200 ns"));
  choose(Signal::kDcmError);
  showFigure(StabilityView::Figure::kSpectrum);
  QTest::mouseMove(plot, plot->placeOf(curve().stops[1].at).toPoint());
  EXPECT_THAT(reading(), HasSubstr("33.0 Hz: 300 ns"));
}

TEST_F(StabilityViewTest, CurvesAreDrawnWhereTheirPointsAre) {
  auto* plot = view().plot();
  const auto image = plot->grab().toImage();
  const auto place = plot->placeOf(curve().line[2]) * image.devicePixelRatio();
  EXPECT_EQ(image.pixelColor(place.toPoint()), curve().color);
}

TEST_F(StabilityViewTest, OnlyTimesThatComeEvenlyAreOffered) {
  auto* menu = view().findChild<QToolButton*>(QStringLiteral("stabilitySignals"))->menu();
  Q_EMIT menu->aboutToShow();
  QStringList offered;
  for (const auto* action : menu->actions()) offered << action->text();
  EXPECT_TRUE(offered.contains(QStringLiteral("DCM error")));
  EXPECT_FALSE(offered.contains(QStringLiteral("Drift"))) << "a rate is no time";
  EXPECT_FALSE(offered.contains(QStringLiteral("Frame late by"))) << "comes now and then";
}

TEST_F(StabilityViewTest, ExportsWhatIsDrawn) {
  std::istringstream lines(strip.csv());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "signal,tau_s,adev,mdev,tdev_ns,mtie_ns,windows");
  std::getline(lines, line);
  EXPECT_THAT(line, testing::MatchesRegex("deviation_ns #1,0.002,5\\.[0-9]+e-05,.*,199,9999")) << line;
  std::size_t count = 1;
  while (std::getline(lines, line)) ++count;
  EXPECT_EQ(count, curve().line.size());
  showFigure(StabilityView::Figure::kSpectrum);
  EXPECT_THAT(strip.csv(), testing::StartsWith("signal,frequency_hz,amplitude_ns\ndeviation_ns #1,0,"));
  strip.showBody(LiveStrip::Body::kPlots);
  EXPECT_THAT(strip.csv(), Not(HasSubstr("amplitude_ns")));
}

TEST_F(StabilityViewTest, StandsInPlaceOfThePlotsAndOfTheDistribution) {
  auto* distribution = strip.findChild<QToolButton*>(QStringLiteral("distributionButton"));
  auto* stability = strip.findChild<QToolButton*>(QStringLiteral("stabilityButton"));
  distribution->click();
  EXPECT_FALSE(view().isVisible());
  EXPECT_FALSE(stability->isChecked());
  stability->click();
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(distribution->isChecked());
  stability->click();
  EXPECT_FALSE(view().isVisible());
  EXPECT_FALSE(QImage::fromData(pictureFile(strip.picture(), PictureForm::kPng)).isNull());
}

TEST_F(StabilityViewTest, WhatARunWithoutItsSlavesHasIsShown) {
  choose(Signal::kSlaveDeviation, 2);
  NetworkConfig alone = configuration();
  alone.slaves.resize(1);
  const RunRecord other(alone);
  strip.setRecord(&other);
  strip.refresh();
  strip.setRecord(nullptr);
  strip.refresh();
  EXPECT_THAT(strip.csv(), testing::StartsWith("signal,"));
}

TEST_F(StabilityViewTest, SpeaksGerman) {
  const test::Speak speak(QStringLiteral("de"));
  showFigure(StabilityView::Figure::kMtie);
  strip.setRecord(record.get());
  settle();
  EXPECT_THAT(words(), HasSubstr("Grenzwert"));
  EXPECT_THAT(words(), HasSubstr("Jitter bei kurzen Zeiten"));
}

TEST(DecadeAxis, HoldsItsValuesAndLabelsDecades) {
  const DecadeAxis axis(2e-3, 4.1);
  EXPECT_GT(axis.place(2e-3), 0);
  EXPECT_LT(axis.place(4.1), 1);
  EXPECT_NEAR(axis.value(axis.place(0.3)), 0.3, 1e-12);
  std::vector<double> labels;
  for (const auto& tick : axis.ticks(6)) {
    if (tick.labelled) labels.push_back(tick.value);
  }
  ASSERT_EQ(labels.size(), 3U);
  EXPECT_NEAR(labels.front(), 0.01, 1e-12);
  const DecadeAxis narrow(30, 40);
  EXPECT_GT(narrow.high() / narrow.low(), 10) << "a decade at least";
  std::size_t between = 0;
  for (const auto& tick : narrow.ticks(6)) between += tick.labelled && !tick.decade ? 1 : 0;
  EXPECT_GE(between, 1U);
}

TEST(QuantityText, ChoosesTheUnitAndThreeDigits) {
  const auto said = [](Quantity quantity, double value) {
    return quantityText(quantity, value).replace(QChar(0x00A0), u' ').toStdString();
  };
  EXPECT_EQ(said(Quantity::kSeconds, 0.016), "16.0 ms");
  EXPECT_EQ(said(Quantity::kSeconds, 4.096), "4.10 s");
  EXPECT_EQ(said(Quantity::kNanoseconds, 1270), "1.27 \u00B5s");
  EXPECT_EQ(said(Quantity::kNanoseconds, 0.05), "0.0500 ns");
  EXPECT_EQ(said(Quantity::kHertz, 250), "250 Hz");
  EXPECT_EQ(said(Quantity::kRatio, 3.2e-8), "3.20\u00B710\u207B\u2078");
  EXPECT_EQ(axisText(Quantity::kRatio, 1e-6).toStdString(), "10\u207B\u2076");
  EXPECT_EQ(axisText(Quantity::kSeconds, 0.01).replace(QChar(0x00A0), u' ').toStdString(), "10 ms");
}

}  // namespace
}  // namespace syncline::ui
