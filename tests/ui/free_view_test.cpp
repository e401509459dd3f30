// SPDX-License-Identifier: Apache-2.0
// The user's own plots: any signals of a run in any number of plots, kept with the project.
#include "ui/panels/free_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <qwt_scale_div.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QSplitter>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/ui_test_support.h"
#include "ui/dialogs/plot_dialog.h"
#include "ui/panels/free_plot.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/picture_file.h"
#include "ui/plots/band_item.h"
#include "ui/plots/series_csv.h"
#include "ui/plots/signal_source.h"

namespace syncline::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr Nanoseconds kBegin = 830'000'000 * kSecond;

ViewSignal ofBus(const char* key) { return {ViewSignal::Of::kBus, key, 0, false, false, false}; }
ViewSignal ofSlave(std::uint16_t station, const char* key) {
  return {ViewSignal::Of::kSlave, key, station, false, false, false};
}
MonitorView viewWith(std::vector<ViewSignal> signals, const char* name = "Mine") {
  ViewPlot plot;
  plot.signals = std::move(signals);
  return {name, {plot}};
}

class FreeViewTest : public testing::Test {
 protected:
  void SetUp() override {
    run({"Coupler", "Servo"});
    strip.resize(1200, 460);
    QObject::connect(strip.free(), &FreeView::viewsEdited, &strip,
                     [this](const std::vector<MonitorView>& views) { told.push_back(views); });
    strip.showBody(LiveStrip::Body::kFree);
  }
  /// A run of ten seconds: the frames of 4 s to 4.2 s are lost, the servo falls to SAFEOP with an error at 6 s and is
  /// back in OP at 8 s; a cable of the coupler damages frames.
  void run(const std::vector<std::string>& names) {
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic[0].cycle_time = kMillisecond;
    for (std::size_t i = 0; i < names.size(); ++i) {
      config.slaves.emplace_back().name = names[i];
      config.slaves.back().station_address = static_cast<std::uint16_t>(1001 + i);
    }
    auto next = std::make_unique<RunRecord>(std::move(config), 20'000, RunLimits{kMillisecond, 127, 4000}, 0x1000);
    strip.setRecord(next.get());
    record = std::move(next);
    for (int tenth = 0; tenth < 100; ++tenth) add(tenth, names.size());
    strip.setRecord(record.get(), true);
  }
  void add(int tenth, std::size_t slaves) {
    std::vector<CycleSample> samples(100);
    for (int i = 0; i < 100; ++i) {
      auto& sample = samples[static_cast<std::size_t>(i)];
      const int number = tenth * 100 + i;
      sample.cycle = static_cast<std::uint64_t>(number);
      sample.send_time = kBegin + number * kMillisecond;
      sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
      sample.dcm_error_ns = number % 2 == 0 ? 200 : -200;
      sample.drift_ppm = 12.5F;
      if (number >= 4000 && number < 4200) sample.flags = CycleSample::kFrameLost | CycleSample::kDcmActive;
    }
    record->add(samples);
    Snapshot snapshot;
    snapshot.time = samples.back().send_time;
    snapshot.online = true;
    snapshot.lost_frames = tenth >= 40 ? 200 : 0;
    snapshot.slaves.resize(slaves);
    for (auto& slave : snapshot.slaves) {
      slave.present = true;
      slave.al_status = 8;
    }
    if (slaves > 1 && tenth >= 60 && tenth < 80) snapshot.slaves[1].al_status = 0x14;
    auto& evidence = snapshot.slaves.front().evidence;
    evidence.ports_time = snapshot.time;
    evidence.ports[1].invalid_frames = static_cast<std::uint32_t>(std::max(0, tenth - 49) * 3);
    evidence.ports[1].at_least = tenth == 99;
    record->add(snapshot);
  }
  void settle() {
    strip.show();
    for (int round = 0; round < 2; ++round) {
      strip.refresh();
      QApplication::processEvents();
    }
  }
  void showView(const MonitorView& view) {
    strip.setViews({view});
    free().choose(0);
    settle();
  }
  FreeView& free() { return *strip.free(); }
  FreePlot& plot(std::size_t number) { return *free().plots().at(number); }
  std::string legend(std::size_t number) {
    return plot(number).legend()->text().replace(QChar(0x00A0), u' ').toStdString();
  }
  std::vector<std::string> viewNames() {
    std::vector<std::string> names;
    for (const auto& view : free().views()) names.push_back(view.name);
    return names;
  }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
  std::vector<std::vector<MonitorView>> told;
};

TEST_F(FreeViewTest, BeginsWithUsualViewsThatBecomeTheProjectsWhenTheyAreChanged) {
  settle();
  EXPECT_TRUE(free().showsUsual());
  ASSERT_EQ(free().plots().size(), 2U);
  EXPECT_THAT(legend(0), HasSubstr("DCM error"));
  EXPECT_TRUE(told.empty()) << "looking changes nothing";
  const auto name = free().current().name;
  free().addPlot();
  EXPECT_FALSE(free().showsUsual());
  EXPECT_THAT(viewNames(), ElementsAre(name));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.back().front().plots.size(), 3U);
  // Once more: another view, with another name.
  free().chooseUsual(0);
  free().removePlot(1);
  EXPECT_THAT(viewNames(), ElementsAre(name, name + " (2)"));
  free().renameView(QStringLiteral(" Drives "));
  EXPECT_THAT(viewNames(), ElementsAre(name, "Drives"));
  free().duplicateView();
  EXPECT_THAT(viewNames(), ElementsAre(name, "Drives", "Drives (2)"));
  free().removeView();
  free().removeView();
  EXPECT_THAT(viewNames(), ElementsAre(name));
  free().removeView();
  EXPECT_TRUE(free().showsUsual());
  EXPECT_TRUE(told.back().empty());
}

TEST_F(FreeViewTest, OfAProjectsViewsTheFirstIsShown) {
  settle();
  auto first = free().current(), second = first;
  first.name = "Drives";
  second.name = "Terminals";
  strip.setViews({first, second});
  EXPECT_EQ(free().current().name, "Drives");
  // The one that is shown stays, wherever it stands; without it the first again.
  free().choose(1);
  strip.setViews({second, first});
  EXPECT_EQ(free().current().name, "Terminals");
  strip.setViews({first});
  EXPECT_EQ(free().current().name, "Drives");
}

TEST_F(FreeViewTest, EachUsualViewShowsSomething) {
  for (int number = 0; number < 4; ++number) {
    free().chooseUsual(number);
    settle();
    ASSERT_FALSE(free().plots().empty()) << number;
    bool any = false;
    for (const auto* one : free().plots()) any = any || !one->plot()->items().empty() || !one->plot()->bands().empty();
    EXPECT_TRUE(any) << free().current().name;
  }
}

TEST_F(FreeViewTest, TheExternalClockHasAPlotWhereThereIsOne) {
  const auto titles = [this] {
    free().chooseUsual(0);
    settle();
    std::vector<std::string> all;
    for (const auto& one : free().current().plots) all.push_back(one.title);
    return all;
  };
  EXPECT_EQ(titles(), (std::vector<std::string>{"DCM error", "Adjustment and drift"}));
  std::vector<CycleSample> samples(100);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].cycle = 10'000 + i;
    samples[i].send_time = kBegin + static_cast<Nanoseconds>(samples[i].cycle) * kMillisecond;
    samples[i].external_error_ns = -16'000;
  }
  record->add(samples);
  EXPECT_EQ(titles(), (std::vector<std::string>{"DCM error", "External clock", "Adjustment and drift"}));
}

TEST_F(FreeViewTest, StatesAreBandsWithTheirNames) {
  showView(viewWith({ofSlave(1001, "al_status"), ofSlave(1002, "al_status")}));
  ASSERT_EQ(plot(0).plot()->bands().size(), 2U);
  EXPECT_TRUE(std::ranges::none_of(plot(0).plot()->items(), &SeriesItem::isVisible));
  const auto& band = *plot(0).plot()->bands()[1];
  std::vector<int> values;
  for (const auto& stretch : band.stretches()) {
    if (!stretch.changes) values.push_back(stretch.value);
  }
  // Nobody heard of it while the frames were lost.
  EXPECT_THAT(values, ElementsAre(8, 8, 0x14, 8));
  EXPECT_EQ(band.stateAt(kBegin + 7 * kSecond), QStringLiteral("SAFEOP + ERR"));
  EXPECT_EQ(band.stateAt(kBegin + 5 * kSecond), QStringLiteral("OP"));
  EXPECT_EQ(band.stateAt(kBegin + 60 * kSecond), QString()) << "nobody has heard of it";
  EXPECT_THAT(legend(0), HasSubstr("#1 Servo OP"));
}

/// The oldest states are below the name: what is drawn of them is seen.
TEST_F(FreeViewTest, NamesOfBandsHideNoState) {
  BandItem band(QStringLiteral("A slave with a long name"));
  HeldSeries states(64);
  states.hear(kBegin, 8);
  states.hear(kBegin + 50 * kMillisecond, 4);
  states.hear(kBegin + 100 * kMillisecond, 8);
  states.hear(kBegin + 1000 * kMillisecond, 8);
  band.setSeries(&states.series(), &states, [](int value) {
    return BandItem::State{{}, value == 4 ? Qt::red : Qt::green, Qt::black};
  });
  band.setColors(Qt::black, Qt::white);
  band.setLane(0, 20);
  band.prepare(ColumnGrid::of(kBegin, kBegin + kSecond, 400));
  QImage image(400, 40, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  QwtScaleMap x, y;
  x.setPaintInterval(0, 400);
  band.draw(&painter, x, y, QRectF(0, 0, 400, 40));
  painter.end();
  int fallen = 0;
  for (int column = 0; column < 60; ++column) fallen += image.pixelColor(column, 2) == QColor(Qt::red) ? 1 : 0;
  EXPECT_GE(fallen, 15) << "50 ms of a second on 400 columns, below the name";
}

/// A state that changes faster than columns can tell costs no more, and says so.
TEST_F(FreeViewTest, WhatChangesWithinAColumnIsNoState) {
  HeldSeries fast(1U << 16);
  for (int i = 0; i < 40'000; ++i) fast.hear(kBegin + i * 100 * kMicrosecond, i % 2 == 0 ? 8.0F : 4.0F);
  BandItem band({});
  band.setSeries(&fast.series(), &fast, [](int) { return BandItem::State{}; });
  band.prepare(ColumnGrid::of(kBegin, kBegin + 4 * kSecond, 100));
  ASSERT_FALSE(band.stretches().empty());
  EXPECT_LE(band.stretches().size(), 3U);
  EXPECT_TRUE(band.stretches()[band.stretches().size() / 2].changes);
}

TEST_F(FreeViewTest, StepsCostNoMoreThanTheColumns) {
  HeldSeries fast(1U << 16);
  for (int i = 0; i < 40'000; ++i) fast.hear(kBegin + i * 100 * kMicrosecond, static_cast<float>(i));
  SeriesItem item({});
  item.setShape(SeriesItem::Shape::kStep);
  item.setSeries(&fast.series());
  item.setHeldBy(&fast);
  item.prepare(ColumnGrid::of(kBegin, kBegin + 4 * kSecond, 100));
  EXPECT_TRUE(item.points().empty());
  EXPECT_LE(item.columns().size(), 100U);
  ASSERT_TRUE(item.extent());
  EXPECT_EQ(item.extent()->max, 39'999);
}

TEST_F(FreeViewTest, CountsAreTotalsOrRates) {
  auto rate = ofSlave(1001, "port1_invalid_frames");
  rate.rate = rate.right = true;
  showView(viewWith({ofSlave(1001, "port1_invalid_frames"), rate}));
  const auto& items = plot(0).plot()->items();
  ASSERT_EQ(items.size(), 2U);
  const auto total = items[0]->valueAt(kBegin + 9 * kSecond);
  ASSERT_TRUE(total);
  EXPECT_NEAR(total->value, 120, 3);
  const auto now = items[1]->valueAt(kBegin + 9 * kSecond);
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->value, 30, 3) << "three in a tenth of a second";
  const auto before = items[1]->valueAt(kBegin + 3 * kSecond);
  ASSERT_TRUE(before);
  EXPECT_EQ(before->value, 0);
  EXPECT_THAT(legend(0), HasSubstr("\u2265 150")) << "the counter has stood at its end stop";
  EXPECT_THAT(legend(0), HasSubstr("1/s"));
}

TEST_F(FreeViewTest, ACountIsALowerBoundFromTheMomentOnAtWhichItsCounterStoodAtItsEndStop) {
  showView(viewWith({ofSlave(1001, "port1_invalid_frames"), ofSlave(1001, "counts_at_least")}));
  EXPECT_THAT(legend(0), HasSubstr("\u2265 150"));
  EXPECT_THAT(legend(0), HasSubstr("Port 1"));
  strip.timeView()->setSpan(kSecond);
  strip.timeView()->goTo(kBegin + 8 * kSecond);
  settle();
  EXPECT_THAT(legend(0), Not(HasSubstr("\u2265"))) << "before it did";
}

TEST_F(FreeViewTest, UnitsThatDifferHaveAnAxisEach) {
  auto drift = ofBus("drift_ppm");
  showView(viewWith({ofBus("dcm_error_ns"), drift}));
  const auto right = plot(0).plot()->axis(TracePlot::kRight).id();
  EXPECT_FALSE(plot(0).plot()->isAxisVisible(right));
  drift.right = true;
  showView(viewWith({ofBus("dcm_error_ns"), drift}));
  EXPECT_TRUE(plot(0).plot()->isAxisVisible(right));
  EXPECT_LE(plot(0).plot()->axis(TracePlot::kLeft).low(), -200);
  EXPECT_LT(plot(0).plot()->axis(TracePlot::kRight).high(), 20);
  EXPECT_GT(plot(0).plot()->axis(TracePlot::kRight).low(), 5);
  EXPECT_THAT(legend(0), HasSubstr("(right)"));
}

TEST_F(FreeViewTest, ScaleAndLimitsAreThoseOfTheView) {
  auto view = viewWith({ofBus("dcm_error_ns")});
  view.plots[0].scale = ValueScale::kSignedLog;
  view.plots[0].left = AxisLimits{-1e6, 1e6};
  showView(view);
  auto& axis = plot(0).plot()->axis(TracePlot::kLeft);
  EXPECT_EQ(axis.scale(), ValueScale::kSignedLog);
  EXPECT_TRUE(axis.isFixed());
  EXPECT_EQ(axis.high(), 1e6);
  const auto map = plot(0).plot()->canvasMap(axis.id());
  const double middle = map.transform(0);
  EXPECT_NEAR(map.transform(1e6) + map.transform(-1e6), 2 * middle, 1e-6);
  EXPECT_GT(middle - map.transform(1000), (middle - map.transform(1e6)) * 0.45) << "decades";
  const auto ticks = plot(0).plot()->axisScaleDiv(axis.id()).ticks(QwtScaleDiv::MajorTick);
  EXPECT_TRUE(ticks.contains(0));
  EXPECT_TRUE(std::ranges::is_sorted(ticks));
  EXPECT_GT(ticks.size(), 2);
  // From the menu: the view is another one then.
  plot(0).setScale(ValueScale::kLog);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back()[0].plots[0].scale, ValueScale::kLog);
  plot(0).setLimits(TracePlot::kLeft, std::nullopt);
  settle();
  EXPECT_FALSE(plot(0).plot()->axis(TracePlot::kLeft).isFixed());
  EXPECT_EQ(told.back()[0].plots[0].left, std::nullopt);
  EXPECT_GE(plot(0).plot()->axis(TracePlot::kLeft).low(), 1e-3) << "what is below zero asks for no thirty decades";
}

TEST_F(FreeViewTest, APlotWithItsOwnTimeGoesItsOwnWay) {
  auto view = viewWith({ofBus("dcm_error_ns")});
  view.plots.push_back(view.plots.front());
  view.plots[1].own_time = true;
  showView(view);
  auto& linked = *plot(0).plot();
  auto& own = *plot(1).plot();
  EXPECT_EQ(linked.timeView(), strip.timeView());
  ASSERT_NE(own.timeView(), strip.timeView());
  EXPECT_EQ(own.timeView()->begin(), strip.timeView()->begin()) << "it begins as the others";
  own.timeView()->setSpan(kSecond);
  settle();
  EXPECT_NE(strip.timeView()->span(), kSecond);
  EXPECT_NEAR(static_cast<double>(own.grid().width * own.grid().columns), 1e9, 1e6);
  EXPECT_THAT(own.axisTitle(QwtPlot::xBottom).text().toStdString(), HasSubstr("not linked"));
  // The keys are those of the plot that has the focus.
  own.setFocus();
  strip.activateWindow();
  QTest::qWait(0);
  const auto before = strip.timeView()->span();
  QTest::keyClick(&own, Qt::Key_Plus);
  ASSERT_TRUE(own.hasFocus());
  EXPECT_EQ(own.timeView()->span(), kSecond / 2);
  EXPECT_EQ(strip.timeView()->span(), before);
  plot(1).setOwnTime(false);
  EXPECT_EQ(own.timeView(), strip.timeView());
}

TEST_F(FreeViewTest, WhatTheMachineLacksStaysInItsPlace) {
  const auto view = viewWith({ofSlave(1002, "al_status"),
                              ofSlave(1777, "deviation_ns"),
                              ofBus("tomorrow_ns"),
                              {ViewSignal::Of::kVariable, "Servo.Outputs.Target", 0, true, false, false}});
  showView(view);
  EXPECT_THAT(legend(0), HasSubstr("1777: Deviation not there"));
  EXPECT_THAT(legend(0), HasSubstr("tomorrow_ns not there"));
  EXPECT_THAT(legend(0), HasSubstr("Servo.Outputs.Target not there"));
  EXPECT_EQ(free().current(), view) << "nothing is lost";
  EXPECT_TRUE(told.empty());
  run({"Coupler"});  // another machine: the servo is gone
  settle();
  EXPECT_THAT(legend(0), HasSubstr("1002: AL state not there"));
  run({"Coupler", "Servo"});
  settle();
  EXPECT_THAT(legend(0), HasSubstr("#1 Servo: AL state OP"));
  EXPECT_EQ(free().current(), view);
  strip.setRecord(nullptr);
  settle();
}

TEST_F(FreeViewTest, NothingIsPaintedThatIsNotSeen) {
  showView(viewWith({ofBus("dcm_error_ns")}));
  auto& canvas = *plot(0).plot();
  const auto before = canvas.paintCount();
  strip.showBody(LiveStrip::Body::kPlots);
  strip.timeView()->pan(-kSecond);
  settle();
  EXPECT_EQ(canvas.paintCount(), before);
  strip.showBody(LiveStrip::Body::kFree);
  settle();
  EXPECT_GT(canvas.paintCount(), before);
  const auto shown = canvas.paintCount();
  for (int i = 0; i < 20; ++i) strip.refresh();
  EXPECT_EQ(canvas.paintCount(), shown) << "nothing has changed";
}

TEST_F(FreeViewTest, TheTableOfARangeHasItsSignals) {
  auto rate = ofSlave(1001, "port1_invalid_frames");
  rate.rate = true;
  auto view = viewWith({ofBus("dcm_error_ns"), rate});
  view.plots.push_back(viewWith({ofBus("dcm_error_ns"), ofSlave(1002, "al_status")}).plots.front());
  showView(view);
  const auto table = strip.csv();
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "time_ns,time_utc,cycle,dcm_error_ns,port1_invalid_frames #0 per s,al_status #1");
  EXPECT_THAT(table, HasSubstr(",20"));
  EXPECT_THAT(table, HasSubstr(",30,"));
}

TEST_F(FreeViewTest, FiguresAreALineForEachCurve) {
  showView(viewWith({ofBus("dcm_error_ns"), ofBus("drift_ppm")}));
  auto text = strip.figures().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(text, HasSubstr("Signal\tUnit\tAt A\tAt B"));
  EXPECT_THAT(text, HasSubstr("DCM error\tns\t\t\t\t-200\t200\t0\t200\t9800"));
  strip.cursors()->set(CursorSet::kA, kBegin + kSecond);
  strip.cursors()->set(CursorSet::kB, kBegin + kSecond + 9 * kMillisecond);
  text = strip.figures().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(text, HasSubstr("DCM error\tns\t200\t-200\t-400\t-200\t200\t0\t200\t10\t\n"));
  EXPECT_THAT(text, HasSubstr("Drift\tppm\t12.5\t"));
}

/// All plots, whatever the scroll area shows, and no buttons.
TEST_F(FreeViewTest, ThePictureIsOfAllPlots) {
  auto view = viewWith({ofBus("dcm_error_ns")});
  for (int i = 0; i < 5; ++i) {
    view.plots.push_back(view.plots.front());
    view.plots.back().title = "Plot number " + std::to_string(i);
  }
  showView(view);
  const auto svg = QString::fromUtf8(pictureFile(strip.picture(), PictureForm::kSvg));
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(svg.contains(QStringLiteral("Plot number %1").arg(i))) << i;
  EXPECT_FALSE(svg.contains(QStringLiteral("Signals")));
  EXPECT_TRUE(plot(0).findChild<QToolButton*>(QStringLiteral("freePlotSignals"))->isVisible());
}

/// The store keeps sixteen arrival phases at once; others than these twelve are named and not drawn.
TEST_F(FreeViewTest, ArrivalPhasesAreAsManyAsAreKept) {
  std::vector<ViewSignal> phases;
  for (int i = 0; i < 10; ++i) phases.push_back(ofSlave(static_cast<std::uint16_t>(1001 + i % 2), "arrival_phase_ns"));
  auto view = viewWith(phases);
  view.plots.push_back(view.plots.front());
  showView(view);
  const auto drawn = [this](std::size_t number) {
    return std::ranges::count_if(plot(number).plot()->items(), &SeriesItem::isVisible);
  };
  EXPECT_EQ(drawn(0), 10);
  EXPECT_EQ(drawn(1), 2);
  EXPECT_THAT(legend(1), HasSubstr("not drawn"));
  free().removePlot(0);
  settle();
  EXPECT_EQ(drawn(0), 10);
}

/// A band without its name says nothing of whose it is.
TEST_F(FreeViewTest, BandsHaveRoomForTheirNames) {
  std::vector<ViewSignal> states;
  for (int i = 0; i < 20; ++i) states.push_back(ofSlave(static_cast<std::uint16_t>(1001 + i % 2), "al_status"));
  strip.resize(1000, 300);
  showView(viewWith(states));
  const auto& canvas = *plot(0).plot()->canvas();
  EXPECT_GE(canvas.height(), 20 * (canvas.fontMetrics().height() - 1)) << "the rest is scrolled to";
  EXPECT_LE(strip.height(), 320);
}

TEST_F(FreeViewTest, PlotsAreMovedAndGrow) {
  auto view = viewWith({ofBus("dcm_error_ns")});
  view.plots.push_back(viewWith({ofBus("drift_ppm")}).plots.front());
  view.plots[0].height = 300;
  strip.resize(1200, 1000);
  showView(view);
  auto& splitter = *test::find<QSplitter>(strip, "freeViewSplitter");
  EXPECT_GT(splitter.sizes()[0], 2 * splitter.sizes()[1]);
  free().movePlot(1, -1);
  settle();
  EXPECT_EQ(told.back()[0].plots[0].signals[0].key, "drift_ppm");
  EXPECT_GT(splitter.sizes()[1], 2 * splitter.sizes()[0]) << "a plot keeps its height";
  free().movePlot(0, -1);
  EXPECT_EQ(told.back()[0].plots[0].signals[0].key, "drift_ppm");
  auto* menu = test::find<QMenu>(plot(0), "freePlotActions");
  Q_EMIT menu->aboutToShow();
  auto actions = menu->actions();
  const auto remove = std::ranges::find(actions, QStringLiteral("Remove plot"), &QAction::text);
  ASSERT_NE(remove, actions.end());
  (*remove)->trigger();
  settle();
  ASSERT_EQ(free().plots().size(), 1U);
  EXPECT_EQ(free().current().plots[0].signals[0].key, "dcm_error_ns");
}

// ---- what is chosen ---------------------------------------------------------------------------

class PlotDialogTest : public FreeViewTest {
 protected:
  void open(ViewPlot plot = {}) {
    dialog = std::make_unique<PlotDialog>(*record, std::move(plot), AxisLimits{0, 1}, AxisLimits{0, 1});
    dialog->show();
    QApplication::processEvents();
  }
  template <class Widget>
  Widget& field(const char* name) {
    return *test::find<Widget>(*dialog, name);
  }
  std::unique_ptr<PlotDialog> dialog;
};

TEST_F(PlotDialogTest, FindsSignalsBySlaveAndNameAndAddsThemByKeyboard) {
  open();
  auto& search = field<QLineEdit>("plotSearch");
  QTest::keyClicks(&search, QStringLiteral("servo al state"));
  QTest::keyClick(&search, Qt::Key_Return);
  ASSERT_EQ(dialog->plot().signals.size(), 1U);
  EXPECT_EQ(dialog->plot().signals[0], ofSlave(1002, "al_status"));
  QTest::keyClick(&search, Qt::Key_Return);
  EXPECT_EQ(dialog->plot().signals.size(), 1U) << "it is there already";
  // Several slaves at once.
  search.clear();
  QTest::keyClicks(&search, QStringLiteral("deviation_ns #"));
  auto& offer = field<QTreeView>("plotOffer");
  QTest::keyClick(&offer, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&offer, Qt::Key_Return);
  ASSERT_EQ(dialog->plot().signals.size(), 3U);
  EXPECT_EQ(dialog->plot().signals[1], ofSlave(1001, "deviation_ns"));
  EXPECT_EQ(dialog->plot().signals[2], ofSlave(1002, "deviation_ns"));
  auto& chosen = field<QTableWidget>("plotChosen");
  chosen.setCurrentCell(0, 0);
  QTest::keyClick(&chosen, Qt::Key_Delete);
  EXPECT_EQ(dialog->plot().signals.size(), 2U);
}

TEST_F(PlotDialogTest, SaysHowFarToBelieveWhatIsMarked) {
  open();
  QTest::keyClicks(&field<QLineEdit>("plotSearch"), QStringLiteral("dcm_error_ns"));
  const auto about = field<QLabel>("plotAbout").text().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(about, HasSubstr("dcm_error_ns"));
  EXPECT_THAT(about, HasSubstr("1000 readings a second"));
  EXPECT_THAT(about, HasSubstr("by the reference clock and the host's clock"));
  EXPECT_THAT(about, HasSubstr("nobody tells who stamped the moment"));
}

TEST_F(PlotDialogTest, AnotherUnitGoesToTheOtherAxis) {
  open(viewWith({ofBus("dcm_error_ns")}).plots.front());
  auto& search = field<QLineEdit>("plotSearch");
  QTest::keyClicks(&search, QStringLiteral("drift_ppm"));
  QTest::keyClick(&search, Qt::Key_Return);
  ASSERT_EQ(dialog->plot().signals.size(), 2U);
  EXPECT_TRUE(dialog->plot().signals[1].right);
  auto& chosen = field<QTableWidget>("plotChosen");
  chosen.item(1, 2)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(dialog->plot().signals[1].right);
  EXPECT_FALSE(chosen.item(1, 1)->flags().testFlag(Qt::ItemIsUserCheckable)) << "a drift is no count";
}

TEST_F(PlotDialogTest, CountsAreTotalsUnlessTheyAreWantedAsRates) {
  open(viewWith({ofSlave(1001, "port0_lost_links")}).plots.front());
  auto& chosen = field<QTableWidget>("plotChosen");
  chosen.setCurrentCell(0, 1);
  QTest::keyClick(&chosen, Qt::Key_Space);
  EXPECT_TRUE(dialog->plot().signals[0].rate);
}

TEST_F(PlotDialogTest, TakesLimitsWithUnitsAndRefusesWhatAreNone) {
  open(viewWith({ofBus("dcm_error_ns")}).plots.front());
  auto& ok = *dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  field<QCheckBox>("plotLeftFixed").setChecked(true);
  auto& low = field<QLineEdit>("plotLeftLow");
  auto& high = field<QLineEdit>("plotLeftHigh");
  const auto type = [](QLineEdit& edit, const char* text) {
    edit.selectAll();
    QTest::keyClicks(&edit, QString::fromUtf8(text));
  };
  type(low, "-1.5 us");
  type(high, "2ms");
  EXPECT_TRUE(ok.isEnabled());
  EXPECT_EQ(dialog->plot().left, (AxisLimits{-1500, 2e6}));
  type(high, "-2 ms");
  EXPECT_FALSE(ok.isEnabled());
  type(high, "many");
  EXPECT_FALSE(ok.isEnabled());
  type(high, "10");
  EXPECT_TRUE(ok.isEnabled());
  field<QRadioButton>("plotLog").setChecked(true);
  EXPECT_FALSE(ok.isEnabled()) << "what is below zero has no logarithm";
  field<QCheckBox>("plotLeftFixed").setChecked(false);
  EXPECT_TRUE(ok.isEnabled());
  EXPECT_EQ(dialog->plot().left, std::nullopt);
  EXPECT_EQ(dialog->plot().scale, ValueScale::kLog);
}

}  // namespace
}  // namespace syncline::ui
