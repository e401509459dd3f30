// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/slaves_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QApplication>
#include <QImage>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <sstream>

#include "support/speak.h"
#include "support/ui_test_support.h"
#include "ui/models/slave_figures_model.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/heat_legend.h"
#include "ui/theme/theme.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using SlavesColumn = SlaveFiguresModel::Column;

constexpr Nanoseconds kHeatBegin = 830'000'000 * kSecond;
constexpr std::size_t kHeatCycles = 10'000;

/// Cycles of 1 ms, 10 s, a sync window of 127 ns. Slave 0 is the reference clock, 1 to 3 are read in turn, 4 has no DC.
/// Slave 1: 40 ns. Slave 2: -20 ns, one spike of -900 ns at 5002 ms. Slave 3: 100 ns, absent from 3 to 4 s.
class SlavesViewTest : public testing::Test {
 protected:
  void SetUp() override {
    theme::apply(theme::Mode::kLight);
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic[0].cycle_time = kMillisecond;
    for (const char* name : {"Coupler", "Servo A", "Servo B", "Servo C", "Terminal"})
      config.slaves.emplace_back().name = name;
    config.slaves[0].dc.emplace().reference_clock = true;
    config.dc.enabled = true;
    config.dc.sync_window.enabled = true;
    config.dc.sync_window.exponent = 7;
    record = std::make_unique<RunRecord>(config);
    std::vector<CycleSample> samples;
    for (std::size_t i = 0; i < kHeatCycles; ++i) samples.push_back(sample(i));
    record->add(samples);
    strip.resize(1280, 260);
    strip.setRecord(record.get());
    strip.timeView()->setSpan(10 * kSecond);
    strip.show();
    strip.showBody(LiveStrip::Body::kSlaves);
    settle();
  }
  void TearDown() override { theme::apply(theme::Mode::kLight); }
  static CycleSample sample(std::size_t i) {
    CycleSample sample;
    sample.cycle = i;
    sample.send_time = kHeatBegin + static_cast<Nanoseconds>(i) * kMillisecond;
    sample.round_trip_ns = 20'000;
    sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows;
    const int slave = static_cast<int>(1 + i % 3);
    sample.slave_position = static_cast<std::int16_t>(slave);
    sample.slave_deviation_ns = slave == 1 ? 40 : slave == 2 ? -20 : 100;
    if (i == 5002) sample.slave_deviation_ns = -900;
    if (slave == 3 && i >= 3000 && i < 4000) sample.slave_position = -1;
    if (i % 500 == 0) {
      sample.sm2_position = 1;
      sample.slave_sm2_missed = i < 5000 ? 2 : 5;
    }
    return sample;
  }
  void settle() {
    ASSERT_TRUE(test::waitFor([this] {
      strip.refresh();
      return view().complete();
    }));
  }
  SlavesView& view() { return *strip.slaves(); }
  HeatMapPlot& plot() { return *view().plot(); }
  QTableView& table() { return *view().findChild<QTableView*>(QStringLiteral("slavesTable")); }
  std::string cell(int row, int column) {
    return table().model()->index(row, column).data().toString().replace(QChar(0x00A0), u' ').toStdString();
  }
  std::vector<std::string> order() {
    std::vector<std::string> names;
    for (int row = 0; row < table().model()->rowCount(); ++row)
      names.push_back(QString::fromStdString(cell(row, SlavesColumn::kSlave)).section(u' ', 0, 0).toStdString());
    return names;
  }
  int rowOf(const std::string& name) {
    const auto names = order();
    return static_cast<int>(std::ranges::find(names, name) - names.begin());
  }
  std::size_t columnAt(Nanoseconds since_begin) {
    const auto& grid = plot().cells().grid();
    return static_cast<std::size_t>((kHeatBegin + since_begin - grid.origin) / grid.width);
  }
  QColor pixel(std::size_t slave, Nanoseconds since_begin) {
    const auto image = plot().grab().toImage();
    return image.pixelColor((plot().placeOf(slave, columnAt(since_begin)) * image.devicePixelRatio()).toPoint());
  }
  QColor wanted(float part) { return QColor(HeatScale(plot().palette()).color(part)); }
  std::string reading() {
    return view()
        .findChild<ValueLabel*>(QStringLiteral("slavesReading"))
        ->text()
        .replace(QChar(0x00A0), u' ')
        .toStdString();
  }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
};

TEST_F(SlavesViewTest, CellsAreDrawnInTheColoursOfTheScaleInBothThemes) {
  ASSERT_TRUE(view().isVisible());
  for (const auto mode : {theme::Mode::kLight, theme::Mode::kDark}) {
    theme::apply(mode);
    strip.refresh();
    EXPECT_EQ(pixel(1, 2 * kSecond), wanted(40 / 127.F));
    EXPECT_EQ(pixel(3, 2 * kSecond), wanted(100 / 127.F));
    EXPECT_EQ(pixel(2, 5002 * kMillisecond), wanted(2)) << "one sample over the limit is seen";
    EXPECT_EQ(pixel(2, 5100 * kMillisecond), wanted(20 / 127.F));
  }
}

TEST_F(SlavesViewTest, ANewSpikeIsSeenAtEveryZoom) {
  for (const auto span : {100 * kMillisecond, kSecond, 10 * kSecond, 600 * kSecond}) {
    strip.timeView()->setSpan(span);
    strip.timeView()->goTo(kHeatBegin + 5002 * kMillisecond);
    strip.refresh();
    EXPECT_EQ(pixel(2, 5002 * kMillisecond), wanted(2)) << span;
  }
}

TEST_F(SlavesViewTest, WhereASlaveWasAbsentNothingIsSaid) {
  const auto image = plot().grab().toImage();
  const auto colors = [&](Nanoseconds from, Nanoseconds to) {
    std::set<QRgb> seen;
    for (auto column = columnAt(from); column < columnAt(to); ++column)
      seen.insert(image.pixel((plot().placeOf(3, column) * image.devicePixelRatio()).toPoint()));
    return seen;
  };
  EXPECT_EQ(colors(4100 * kMillisecond, 9 * kSecond), std::set<QRgb>{wanted(100 / 127.F).rgb()});
  EXPECT_EQ(colors(3100 * kMillisecond, 3900 * kMillisecond).count(wanted(100 / 127.F).rgb()), 0U);
  EXPECT_EQ(colors(3100 * kMillisecond, 3900 * kMillisecond).count(wanted(0).rgb()), 0U) << "nor zero";
  QTest::mouseMove(&plot(), plot().placeOf(3, columnAt(3500 * kMillisecond)).toPoint());
  EXPECT_THAT(reading(), HasSubstr("no reading"));
}

TEST_F(SlavesViewTest, TheReferenceClockHasARowButNoCells) {
  ASSERT_EQ(plot().rows().size(), 4U) << "what has no DC is in the table only";
  EXPECT_TRUE(plot().rows()[0].is_reference);
  EXPECT_FALSE(plot().spotAt(plot().placeOf(0, 100)));
  EXPECT_EQ(cell(rowOf("#0"), SlavesColumn::kNow), "reference");
  EXPECT_EQ(cell(rowOf("#4"), SlavesColumn::kNow), "no DC");
}

TEST_F(SlavesViewTest, ThePointerReadsSlaveTimeValueAgeAndLimit) {
  QTest::mouseMove(&plot(), plot().placeOf(1, columnAt(2 * kSecond)).toPoint());
  EXPECT_THAT(reading(), HasSubstr("#1 Servo A"));
  EXPECT_THAT(reading(), HasSubstr("+40 ns"));
  EXPECT_THAT(reading(), HasSubstr(" old"));
  EXPECT_THAT(reading(), HasSubstr("limit \u00B1127 ns"));
  QTest::mouseMove(&plot(), plot().placeOf(2, columnAt(5002 * kMillisecond)).toPoint());
  EXPECT_THAT(reading(), HasSubstr("up to 900 ns in the cell"));
  EXPECT_EQ(plot().accessibleDescription().toStdString().empty(), false);
}

TEST_F(SlavesViewTest, TheTableHasTheWorstFirstAndSortsNumbersAsNumbers) {
  EXPECT_THAT(order(), testing::ElementsAre("#2", "#3", "#1", testing::_, testing::_));
  EXPECT_EQ(cell(0, SlavesColumn::kNow), "\u221220 ns");
  EXPECT_EQ(cell(0, SlavesColumn::kMax), "900 ns");
  EXPECT_EQ(cell(1, SlavesColumn::kMean), "+100 ns");
  EXPECT_EQ(cell(1, SlavesColumn::kRms), "100 ns");
  EXPECT_EQ(cell(0, SlavesColumn::kOver), "0.03 %");
  EXPECT_EQ(cell(0, SlavesColumn::kMissed), "\u2013");
  EXPECT_EQ(cell(2, SlavesColumn::kMissed), "3");
  table().sortByColumn(SlavesColumn::kMean, Qt::AscendingOrder);
  EXPECT_THAT(order(), testing::ElementsAre(testing::_, testing::_, "#2", "#1", "#3")) << "20, 40, 100";
  table().sortByColumn(SlavesColumn::kSlave, Qt::AscendingOrder);
  EXPECT_THAT(order(), testing::ElementsAre("#0", "#1", "#2", "#3", "#4"));
  EXPECT_EQ(cell(1, SlavesColumn::kAge), "0 ns");
  EXPECT_EQ(cell(3, SlavesColumn::kAge), "1.000 ms");
}

TEST_F(SlavesViewTest, TheFiguresAreOfTheRangeShown) {
  strip.timeView()->setSpan(kSecond);
  settle();
  EXPECT_EQ(order().front(), "#3");
  EXPECT_EQ(cell(rowOf("#2"), SlavesColumn::kMax), "20 ns");
}

TEST_F(SlavesViewTest, WhatIsChosenInOneIsMarkedInTheOther) {
  table().setCurrentIndex(table().model()->index(1, 0));
  EXPECT_EQ(plot().selected(), 3);
  EXPECT_THAT(reading(), HasSubstr("#3 Servo C"));
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Up);
  EXPECT_EQ(plot().selected(), 2);
  EXPECT_EQ(table().currentIndex().row(), 0);
  QTest::keyClick(&plot(), Qt::Key_Up);
  QTest::keyClick(&plot(), Qt::Key_Up);
  EXPECT_EQ(plot().selected(), 1) << "the reference clock has nothing to choose";
  QTest::keyClick(&plot(), Qt::Key_Down);
  EXPECT_EQ(plot().selected(), 2);
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, plot().placeOf(3, 200).toPoint());
  EXPECT_EQ(plot().selected(), 3);
  EXPECT_EQ(table().currentIndex().row(), 1);
  EXPECT_TRUE(strip.cursors()->at(CursorSet::kA).has_value());
  table().sortByColumn(SlavesColumn::kSlave, Qt::AscendingOrder);
  EXPECT_EQ(table().currentIndex().row(), 3) << "it stays marked";
  EXPECT_EQ(plot().selected(), 3);
}

TEST_F(SlavesViewTest, ADoubleClickOrEnterLeadsToTheMomentAndTheSlave) {
  std::vector<int> wanted_slaves;
  QObject::connect(&strip, &LiveStrip::slaveWanted, &strip, [&](int slave) { wanted_slaves.push_back(slave); });
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, plot().placeOf(2, columnAt(5002 * kMillisecond)).toPoint());
  EXPECT_FALSE(view().isVisible());
  EXPECT_EQ(strip.cursors()->at(CursorSet::kA), kHeatBegin + 5002 * kMillisecond) << "of the reading itself";
  EXPECT_EQ(wanted_slaves, std::vector<int>{2});
  EXPECT_EQ(strip.panels().front()->pickedSlave(), 2);
  strip.cursors()->clear();
  strip.showBody(LiveStrip::Body::kSlaves);
  strip.timeView()->goLive();
  strip.refresh();
  view().select(2);
  QTest::keyClick(&plot(), Qt::Key_Return);
  EXPECT_EQ(strip.cursors()->at(CursorSet::kA), kHeatBegin + 5002 * kMillisecond) << "the worst of the row";
  EXPECT_FALSE(view().isVisible());
}

/// At the foot all events, in a row its slave's own; what has no row (slave 4) is at the foot alone.
TEST_F(SlavesViewTest, EventsStandAtTheFootAndInTheRowOfTheirSlave) {
  const auto fault = kHeatBegin + 4 * kSecond;
  const auto bus = kHeatBegin + 6 * kSecond;
  const auto healed = kHeatBegin + 8 * kSecond;
  const auto at = [&](Nanoseconds time) { return columnAt(time - kHeatBegin); };
  const auto empty_row = plot().grab().toImage();
  record->add(Event{fault, 3, events::SlaveLost{}});
  record->add(Event{fault + 1, -1, events::LinkUp{}});
  record->add(Event{bus, -1, events::LinkDown{}});
  record->add(Event{healed, 4, events::SlaveFound{}});
  strip.refresh();
  const auto bad = theme::toneColor(plot().palette(), theme::Tone::kBad);
  const auto good = theme::toneColor(plot().palette(), theme::Tone::kGood);
  const auto image = plot().grab().toImage();
  const auto shown = [&](const QPointF& place) {
    return image.pixelColor((place * image.devicePixelRatio()).toPoint());
  };
  const auto foot = [&](Nanoseconds time) {
    return QPointF(plot().placeOf(1, at(time)).x(), std::floor(plot().eventsArea().center().y()));
  };
  EXPECT_EQ(shown(foot(fault) + QPointF(0, 2)), bad);
  EXPECT_EQ(shown(foot(bus) + QPointF(0, 2)), bad);
  EXPECT_EQ(shown(foot(healed)), good);
  EXPECT_EQ(shown(plot().placeOf(3, at(fault)) + QPointF(0, 1)), bad) << "in the row of its slave";
  EXPECT_NE(shown(plot().placeOf(2, at(fault)) + QPointF(0, 1)), bad) << "and in no other";
  EXPECT_NE(image, empty_row);

  std::vector<Nanoseconds> clicked;
  QObject::connect(&strip, &LiveStrip::eventClicked, &strip, [&](Nanoseconds time) { clicked.push_back(time); });
  QTest::mouseMove(&plot(), foot(bus).toPoint());
  EXPECT_THAT(reading(), HasSubstr("Network adapter"));
  EXPECT_THAT(reading(), Not(HasSubstr("more here")));
  QTest::mouseMove(&plot(), plot().placeOf(3, at(fault)).toPoint());
  EXPECT_THAT(reading(), HasSubstr("Servo C"));
  EXPECT_THAT(reading(), Not(HasSubstr("limit"))) << "what happened goes before what was read";
  EXPECT_THAT(reading(), Not(HasSubstr("more here"))) << "what is not the slave's stands at the foot";
  QTest::mouseMove(&plot(), foot(fault).toPoint());
  EXPECT_THAT(reading(), HasSubstr("(and 1 more here)"));
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, plot().placeOf(3, at(fault)).toPoint());
  EXPECT_EQ(clicked, std::vector{fault});
  EXPECT_EQ(plot().selected(), 3);
  EXPECT_TRUE(view().isVisible()) << "the map has the time of the plots";
  EXPECT_EQ(strip.cursors()->at(CursorSet::kA), fault);
}

TEST_F(SlavesViewTest, TimeIsThatOfThePlots) {
  const auto middle = plot().area().center();
  QWheelEvent wheel(middle, plot().mapToGlobal(middle), {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&plot(), &wheel);
  EXPECT_EQ(strip.timeView()->span(), 8 * kSecond);
  const auto begin = strip.timeView()->begin();
  QTest::mousePress(&plot(), Qt::LeftButton, {}, middle.toPoint());
  QTest::mouseMove(&plot(), middle.toPoint() + QPoint(60, 0));
  QTest::mouseRelease(&plot(), Qt::LeftButton, {}, middle.toPoint() + QPoint(60, 0));
  EXPECT_LT(strip.timeView()->begin(), begin);
  EXPECT_EQ(plot().selected(), -1) << "a drag chooses nothing";
}

TEST_F(SlavesViewTest, FollowsTheRun) {
  std::vector<CycleSample> more;
  for (std::size_t i = kHeatCycles; i < kHeatCycles + 1000; ++i) {
    more.push_back(sample(i));
    if (more.back().slave_position == 1) more.back().slave_deviation_ns = 300;
  }
  record->add(more);
  settle();
  EXPECT_EQ(pixel(1, 10'500 * kMillisecond), wanted(2));
  EXPECT_EQ(pixel(1, 9'500 * kMillisecond), wanted(40 / 127.F));
}

/// While time goes on, and when one looks back, what stood before is moved: it shows what is drawn anew.
TEST_F(SlavesViewTest, WhatMovesOnIsAsItIsDrawnAnew) {
  const auto cellsOf = [](HeatMapPlot& map) {
    return map.grab(map.area().toAlignedRect()).toImage().convertToFormat(QImage::Format_RGB32);
  };
  const auto anew = [&] {
    HeatMapPlot other(strip.timeView(), strip.cursors());
    other.resize(plot().size());
    other.setRecord(record.get());
    other.setRows(plot().rows());
    other.refresh();
    return cellsOf(other);
  };
  const auto same = [&](const char* when) {
    plot().refresh();
    EXPECT_EQ(cellsOf(plot()), anew()) << when;
  };
  plot().setSelected(-1);
  same("at first");
  std::size_t cycle = kHeatCycles;
  for (const std::size_t portion : {37U, 1U, 400U, 2500U, 9000U}) {
    std::vector<CycleSample> more;
    for (const auto end = cycle + portion; cycle < end; ++cycle) {
      more.push_back(sample(cycle));
      more.back().slave_deviation_ns += static_cast<std::int32_t>(cycle % 211);
    }
    record->add(more);
    strip.refresh();
    same("later");
  }
  strip.timeView()->pan(-3 * kSecond);
  same("looked back");
  strip.timeView()->pan(kSecond);
  same("and on");
  strip.timeView()->zoom(0.5, strip.timeView()->begin());
  same("closer");
  auto rows = plot().rows();
  std::ranges::reverse(rows);
  plot().setRows(rows);
  same("other rows");
  theme::apply(theme::Mode::kDark);
  QApplication::processEvents();
  same("another theme");
}

/// Of what is not shown no words are made; shown again it has those of now.
TEST_F(SlavesViewTest, ThePlotsHaveTheirWordsWhenTheyAreShownAgain) {
  const auto said = [this] { return strip.panels().front()->plot()->accessibleDescription(); };
  const auto before = said();
  std::vector<CycleSample> more;
  for (std::size_t i = kHeatCycles; i < kHeatCycles + 1000; ++i) {
    more.push_back(sample(i));
    more.back().slave_deviation_ns = 555;
    more.back().deviation_ns = 555;
  }
  record->add(more);
  for (int i = 0; i < 40; ++i) strip.refresh();
  EXPECT_EQ(said(), before) << "another view stands there";
  // Whenever that is: words are made every few ticks, and at once here.
  for (int tick = 0; tick < 12; ++tick) {
    more.front().cycle = more.back().cycle + 1;
    more.front().send_time = more.back().send_time + kMillisecond;
    more.front().deviation_ns = more.front().slave_deviation_ns = static_cast<std::int32_t>(600 + tick);
    more = {more.front()};
    record->add(more);
    strip.refresh();
    strip.showBody(LiveStrip::Body::kPlots);
    EXPECT_TRUE(said().contains(QString::number(600 + tick))) << tick << ' ' << qPrintable(said());
    strip.showBody(LiveStrip::Body::kSlaves);
  }
}

TEST_F(SlavesViewTest, ExportsTheCellsShown) {
  std::istringstream lines(strip.csv());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time_ns,time_utc,width_ns,deviation_ns #1 Servo A,deviation_ns #2 Servo B,deviation_ns #3 Servo C");
  std::vector<std::string> all;
  while (std::getline(lines, line)) all.push_back(line);
  ASSERT_EQ(all.size(), plot().cells().grid().columns);
  EXPECT_THAT(all[columnAt(5002 * kMillisecond)], testing::EndsWith(",40,900,100"));
  EXPECT_THAT(all[columnAt(3500 * kMillisecond)], testing::EndsWith(",40,20,"));
  strip.showBody(LiveStrip::Body::kPlots);
  EXPECT_THAT(strip.csv(), Not(HasSubstr("width_ns")));
}

TEST_F(SlavesViewTest, StandsInPlaceOfThePlotsAndOfTheOthers) {
  auto* slaves = strip.findChild<QToolButton*>(QStringLiteral("slavesButton"));
  auto* stability = strip.findChild<QToolButton*>(QStringLiteral("stabilityButton"));
  EXPECT_TRUE(slaves->isChecked());
  stability->click();
  EXPECT_FALSE(view().isVisible());
  EXPECT_FALSE(slaves->isChecked());
  slaves->click();
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(stability->isChecked());
  EXPECT_FALSE(QImage::fromData(pictureFile(strip.picture(), PictureForm::kPng)).isNull());
  const auto pdf = pictureFile(strip.picture(), PictureForm::kPdf);
  EXPECT_TRUE(pdf.contains("/Subtype /Image"));
  EXPECT_FALSE(pdf.contains("/DCTDecode")) << "the cells have other colours";
  slaves->click();
  EXPECT_FALSE(view().isVisible());
}

TEST_F(SlavesViewTest, ARecordingAndNothingAreShown) {
  strip.setRecord(record.get(), true);
  strip.showBody(LiveStrip::Body::kSlaves);
  settle();
  EXPECT_EQ(order().front(), "#2");
  strip.setRecord(nullptr);
  strip.refresh();
  EXPECT_THAT(strip.csv(), StartsWith("time_ns"));
  EXPECT_EQ(table().model()->rowCount(), 0);
}

TEST_F(SlavesViewTest, RowsLowerThanAPixelShareALineAndTheWorstIsSeen) {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic[0].cycle_time = kMillisecond;
  for (int i = 0; i < 500; ++i) config.slaves.emplace_back().name = "S" + std::to_string(i);
  config.dc.enabled = true;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = 7;
  RunRecord many(config);
  std::vector<CycleSample> samples;
  for (std::size_t i = 0; i < 5000; ++i) {
    auto one = sample(i);
    one.slave_position = static_cast<std::int16_t>(i % 500);
    one.slave_deviation_ns = one.slave_position == 333 ? 500 : 10;
    samples.push_back(one);
  }
  many.add(samples);
  strip.setRecord(&many);
  strip.showBody(LiveStrip::Body::kSlaves);
  settle();
  ASSERT_LT(plot().area().height(), 400);
  EXPECT_EQ(pixel(333, 2 * kSecond), wanted(2));
  const auto spot = plot().spotAt(plot().placeOf(333, columnAt(2 * kSecond)));
  ASSERT_TRUE(spot);
  EXPECT_EQ(spot->slave, 333U);
  EXPECT_EQ(order().front(), "#333");
  strip.setRecord(nullptr);
}

TEST_F(SlavesViewTest, WithoutALimitNothingIsOverIt) {
  auto config = record->config();
  config.dc.sync_window.enabled = false;
  RunRecord free(config);
  std::vector<CycleSample> samples;
  for (std::size_t i = 0; i < kHeatCycles; ++i) samples.push_back(sample(i));
  free.add(samples);
  strip.setRecord(&free);
  strip.showBody(LiveStrip::Body::kSlaves);
  settle();
  if (free.limits().deviation_ns != 0) GTEST_SKIP() << "another limit";
  EXPECT_EQ(plot().full(), 1000) << "a round number above all";
  EXPECT_EQ(pixel(2, 5002 * kMillisecond), wanted(0.9F));
  EXPECT_EQ(cell(0, SlavesColumn::kOver), "\u2013");
  EXPECT_THAT(view().findChild<HeatLegend*>()->text().toStdString(), Not(HasSubstr("limit")));
  strip.setRecord(nullptr);
}

TEST_F(SlavesViewTest, SpeaksGerman) {
  const test::Speak speak(QStringLiteral("de"));
  QTest::mouseMove(&plot(), plot().placeOf(1, columnAt(2 * kSecond)).toPoint());
  EXPECT_THAT(reading(), HasSubstr("Grenzwert"));
  EXPECT_EQ(table().model()->headerData(SlavesColumn::kMissed, Qt::Horizontal).toString(),
            QStringLiteral("SM2 verpasst"));
}

/// Lightness of OKLab, which equal steps look equal in.
double oklabLightness(QRgb color) {
  const auto linear = [](int code) {
    const double part = code / 255.0;
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  const double r = linear(qRed(color)), g = linear(qGreen(color)), b = linear(qBlue(color));
  return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
         0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
         0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

/// As somebody without the red or the green receptors sees it: these two carry the same (after Vienot and others).
QRgb withoutRedGreen(QRgb color) {
  const int yellow = static_cast<int>(0.29 * qRed(color) + 0.71 * qGreen(color));
  return qRgb(yellow, yellow, qBlue(color));
}

TEST(HeatScale, RunsInEqualStepsAndIsNeverTakenForOver) {
  for (const auto mode : {theme::Mode::kLight, theme::Mode::kDark}) {
    theme::apply(mode);
    const HeatScale scale(QApplication::palette());
    const double whole = oklabLightness(scale.color(1)) - oklabLightness(scale.color(0));
    EXPECT_GT(std::abs(whole), 0.4);
    for (int i = 0; i < 16; ++i) {
      const auto part = static_cast<float>(i) / 16;
      const double step = oklabLightness(scale.color(part + 1 / 16.F)) - oklabLightness(scale.color(part));
      EXPECT_NEAR(step, whole / 16, 0.006) << i;
      const auto far = [&](QRgb a, QRgb b) {
        return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
      };
      EXPECT_GT(far(scale.color(part), scale.over()), 150) << i;
      EXPECT_GT(far(withoutRedGreen(scale.color(part)), withoutRedGreen(scale.over())), 120) << i;
    }
    EXPECT_EQ(scale.color(1.01F), scale.over());
    EXPECT_NE(scale.color(1), scale.over()) << "the limit itself is kept";
  }
  theme::apply(theme::Mode::kLight);
}

}  // namespace
}  // namespace syncline::ui
