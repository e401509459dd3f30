// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/cycle_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <memory>
#include <span>

#include "channels/cycle_sample.h"
#include "trace/arrival_bathtub.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/bathtub_plot.h"
#include "ui/plots/cycle_plot.h"
#include "ui/plots/histogram_plot.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

constexpr Nanoseconds kCycleEpoch = 830'000'000 * kSecond;

/// Outputs come 400 us behind SYNC0 and in every hundredth cycle 200 us later; cycle 5000 comes 700 us later and so
/// behind the next SYNC0, and the frame of cycle 7000 is lost.
class CycleViewTest : public testing::Test {
 protected:
  void SetUp() override {
    CyclicCmd command;
    command.command = Command::kLrw;
    command.data_length = 64;
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic[0].cycle_time = kMillisecond;
    config.cyclic[0].frames.resize(1);
    config.cyclic[0].frames[0].commands = {command};
    for (const char* name : {"1 Coupler", "2 Servo"}) config.slaves.emplace_back().name = name;
    config.slaves[1].dc = SlaveDcConfig{true, false, kMillisecond, 0, 40 * kMicrosecond, 0x0300};
    config.slaves[1].send = ImageRange{0, 64};
    config.dc.enabled = true;
    record = std::make_unique<RunRecord>(config);
    Snapshot snapshot;
    snapshot.online = true;
    snapshot.time = kCycleEpoch - kMillisecond;
    snapshot.slaves.resize(2);
    for (auto& slave : snapshot.slaves) {
      slave.present = slave.dc_enabled = true;
      slave.al_status = 8;
      slave.propagation_delay_ns = 1'000;
    }
    snapshot.slaves[1].evidence.calc_and_copy_ns = 62'500;
    record->add(snapshot);
    const auto wire = record->samples().sync0(1).wire;
    std::vector<CycleSample> samples(10'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      auto& sample = samples[i];
      sample.cycle = i;
      sample.send_time = kCycleEpoch + static_cast<Nanoseconds>(i) * kMillisecond;
      sample.sync_base = 0;
      sample.flags = CycleSample::kReferenceValid | CycleSample::kSyncBaseValid;
      const Nanoseconds late = i == 5'000 ? 700'000 : i % 100 == 7 ? 200'000 : 0;
      sample.reference_time = sample.send_time + 440'000 - 1'000 - wire + late;
      if (i == 7'000) sample.flags = CycleSample::kFrameLost | CycleSample::kSyncBaseValid;
    }
    for (std::size_t i = 0; i < samples.size(); i += 1'000) {
      record->add(std::span(samples).subspan(i, 1'000));
      snapshot.time = samples[i + 999].send_time;
      record->add(snapshot);
    }
    strip.resize(1280, 230);
    strip.setRecord(record.get(), true);
    strip.show();
    strip.showBody(LiveStrip::Body::kCycle);
    settle();
  }
  void settle() {
    for (int i = 0; i < 8; ++i) {
      strip.refresh();
      QApplication::processEvents();
    }
  }
  CycleView& view() { return *strip.cycle(); }
  const CyclePlot::Picture& picture() { return view().plot()->picture(); }
  std::string said() { return view().findChild<QLabel*>(QStringLiteral("cycleFigures"))->text().toStdString(); }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
};

TEST_F(CycleViewTest, ShowsEveryArrivalWhereItCameInThePeriod) {
  ASSERT_TRUE(view().isVisible());
  EXPECT_EQ(view().slave(), 1) << "the coupler has no SYNC0";
  EXPECT_EQ(picture().period, kMillisecond);
  EXPECT_EQ(picture().figures.count, 9'999U);
  const auto& bins = picture().figures.bins;
  EXPECT_EQ(bins.at(160).count, 9'898U);
  EXPECT_EQ(bins.at(240).count, 100U);
  EXPECT_EQ(bins.at(40).count, 1U) << "behind the next SYNC0";
  EXPECT_DOUBLE_EQ(view().plot()->xOf(kMillisecond / 2), view().plot()->area().center().x());
}

TEST_F(CycleViewTest, SaysMarginsSlipsAndTheSlavesTimes) {
  EXPECT_THAT(said(), HasSubstr("margin at least 400.000"));
  EXPECT_THAT(said(), HasSubstr("99.9 %: 400.000"));
  EXPECT_THAT(said(), HasSubstr("calculating and copying 62.500"));
  EXPECT_THAT(said(), HasSubstr("setpoint slips: 3")) << "a late one makes two, a lost one makes one";
  EXPECT_THAT(said(), HasSubstr("shift +40.000"));
  EXPECT_EQ(view().plot()->accessibleDescription().toStdString(), said());
}

/// Set value, delay and the time of the outputs on the wire say where they are to come; nobody holds them there where
/// the master is not controlled.
TEST_F(CycleViewTest, ShowsWhereOutputsNominallyCome) {
  EXPECT_FALSE(picture().nominal);
  auto snapshot = record->snapshot();
  // A picture that stands is not made again: each time a cycle more.
  const auto go_on = [&] {
    CycleSample sample;
    snapshot.time += kMillisecond;
    sample.send_time = snapshot.time;
    record->add(std::span(&sample, 1));
    record->add(snapshot);
    settle();
  };
  snapshot.dcm.mode = DcmMode::kBusShift;
  snapshot.dcm.set_value_ns = 600'000;
  const auto bare = view().plot()->grab().toImage();
  go_on();
  ASSERT_TRUE(picture().nominal);
  // The frame passes the reference clock 600 us before the grid, SYNC0 comes 40 us behind that.
  const auto wire = record->samples().sync0(1).wire;
  EXPECT_EQ(*picture().nominal, kMillisecond - 640'000 + 1'000 + wire);
  EXPECT_THAT(said(), HasSubstr("nominally 6"));
  EXPECT_NE(view().plot()->grab().toImage(), bare);
  snapshot.dcm.control_off = true;
  go_on();
  EXPECT_FALSE(picture().nominal);
}

/// Newest strong, older fading; SYNC0 uses what came before the shaded time.
TEST_F(CycleViewTest, OlderArrivalsFade) {
  const auto* plot = view().plot();
  for (const bool dark : {false, true}) {
    auto colours = plot->palette();
    colours.setColor(QPalette::Base, dark ? Qt::black : Qt::white);
    view().plot()->setPalette(colours);
    const auto image = view().plot()->grab().toImage();
    const auto at = [&](Nanoseconds phase) {
      const double ratio = image.devicePixelRatio();
      const QPointF place(plot->xOf(phase) + 0.6, plot->area().bottom() - 3);
      return image.pixelColor((place * ratio).toPoint());
    };
    const auto far = [&](const QColor& color) { return std::abs(color.lightness() - (dark ? 0 : 255)); };
    EXPECT_GT(far(at(400'000)), far(at(100'000))) << "the newest is newer than that of cycle 5000";
    EXPECT_GT(far(at(100'000)), 10) << "which is seen";
    EXPECT_NE(at(970'000), at(800'000)) << "calculating and copying";
  }
}

TEST_F(CycleViewTest, IsSavedAsATableAndAPicture) {
  const auto csv = strip.csv();
  EXPECT_THAT(csv, testing::StartsWith("from_ns,to_ns,arrivals\n0,2500,0\n"));
  EXPECT_THAT(csv, HasSubstr("\n400000,402500,9898\n"));
  EXPECT_FALSE(QImage::fromData(pictureFile(strip.picture(), PictureForm::kPng)).isNull());
}

TEST_F(CycleViewTest, TheToolbarChangesBetweenItAndThePlots) {
  auto* button = strip.findChild<QToolButton*>(QStringLiteral("cycleButton"));
  EXPECT_TRUE(button->isChecked());
  button->click();
  EXPECT_FALSE(view().isVisible());
  button->click();
  EXPECT_TRUE(view().isVisible());
}

/// One in a hundred comes 200 us later: 400 us of room are left then, and nobody has come later than that.
TEST_F(CycleViewTest, TheBathtubTellsHowProbableLateArrivalsAre) {
  view().setFigure(CycleView::Figure::kBathtub);
  settle();
  EXPECT_TRUE(view().bathtub()->isVisible());
  EXPECT_FALSE(view().plot()->isVisible());
  const auto& bathtub = view().bathtub()->picture().bathtub;
  EXPECT_EQ(bathtub.count, 9'999U);
  const auto often = ArrivalBathtub::room(bathtub.late, 0.1);
  ASSERT_TRUE(often);
  EXPECT_NEAR(often->room, 600'000, 1);
  const auto seldom = ArrivalBathtub::room(bathtub.late, 1e-3);
  ASSERT_TRUE(seldom);
  EXPECT_NEAR(seldom->room, 400'000, 1);
  EXPECT_TRUE(seldom->extrapolated);
  auto words = view().words();
  words.replace(QChar(0x00A0), u' ');
  EXPECT_THAT(words.toStdString(),
              HasSubstr("room before SYNC0: +400.000 \u00B5s (extrapolated) in all but 10\u207B\u00B3"));
  EXPECT_THAT(words.toStdString(), HasSubstr("calculating and copying (62.500 \u00B5s) always has its time"));
  EXPECT_THAT(view().csv(), testing::StartsWith("probability,room_to_sync0_ns,room_behind_sync0_ns,extrapolated\n1,"));

  const auto place = view().bathtub()->placeOf(400'000, 1e-3);
  EXPECT_NEAR(place.x(), view().bathtub()->area().left() + 0.4 * view().bathtub()->area().width(), 1e-6);
  EXPECT_NEAR(place.y(), view().bathtub()->area().top() + view().bathtub()->area().height() / 3, 1e-6);
  QImage image(view().bathtub()->size(), QImage::Format_RGB32);
  view().bathtub()->render(&image);
  const auto wall = view().bathtub()->placeOf(600'000, 1e-6).toPoint();
  bool drawn = false;
  for (int y = wall.y() - 12; y < wall.y() + 12; ++y) {
    for (int x = wall.x() - 2; x <= wall.x() + 2; ++x) drawn = drawn || QColor(image.pixel(x, y)).saturation() > 60;
  }
  EXPECT_TRUE(drawn) << "the wall is dashed, and there";
  view().setFigure(CycleView::Figure::kArrivals);
  settle();
  EXPECT_THAT(said(), HasSubstr("margin at least"));
}

TEST_F(CycleViewTest, WithoutSync0ItSaysSo) {
  NetworkConfig config;
  config.slaves.resize(2);
  RunRecord other(config);
  strip.setRecord(&other);
  EXPECT_EQ(view().slave(), -1);
  EXPECT_THAT(said(), HasSubstr("No slave with SYNC0"));
  strip.setRecord(nullptr);
}

/// The chooser of the other views offers the phase of those who have one.
TEST_F(CycleViewTest, TheArrivalPhaseIsASignalOfTheDistribution) {
  strip.showBody(LiveStrip::Body::kDistribution);
  auto* menu = strip.distribution()->findChild<QToolButton*>(QStringLiteral("distributionSignals"))->menu();
  Q_EMIT menu->aboutToShow();
  QStringList offered;
  for (const auto* action : menu->actions()) {
    if (action->menu() == nullptr || action->text() != QStringLiteral("Arrival phase of a slave")) continue;
    for (const auto* slave : action->menu()->actions()) offered << slave->text();
  }
  EXPECT_EQ(offered, QStringList{QStringLiteral("#1 2 Servo: Arrival phase")});
  strip.distribution()->setSources({{Signal::kArrivalPhase, 1}});
  settle();
  std::uint64_t counted = 0;
  for (const auto count : strip.distribution()->plot()->steps().at(0).bins) counted += count;
  EXPECT_EQ(counted, 9'999U);
  EXPECT_THAT(strip.csv(), testing::StartsWith("from,to,arrival_phase_ns #1\n"));
}

/// However little room there is.
TEST_F(CycleViewTest, IsDrawnInAnySize) {
  for (const auto& size : {QSize(8, 8), QSize(60, 30), QSize(75, 41), QSize(900, 40), QSize(40, 400)}) {
    CyclePlot plot;
    plot.setPicture(picture());
    plot.resize(size);
    EXPECT_EQ(plot.grab().toImage().size(), size);
  }
}

}  // namespace
}  // namespace syncline::ui
