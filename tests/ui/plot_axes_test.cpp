// SPDX-License-Identifier: Apache-2.0
// Axes and cursors of all plots of the monitor: scales, ways to tell moments, own time, distances, limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <qwt_text.h>

#include <QApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>
#include <QWidget>
#include <cmath>
#include <vector>

#include "support/running_window.h"
#include "support/ui_test_support.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/time_axis.h"
#include "ui/plots/value_transform.h"
#include "ui/session/project_limits.h"
#include "ui/text/typed_value.h"

namespace syncline::ui {
namespace {

using Notation = TimeView::Notation;

constexpr Nanoseconds kAxisStart = 830'000'000 * kSecond + 123'456'789;  // 2026-04-20 11:33:20

TEST(ValueTransform, IsItsOwnWayBack) {
  for (const auto scale : {ValueScale::kLinear, ValueScale::kSignedLog, ValueScale::kLog}) {
    const ValueTransform values(scale, 0.01);
    for (const double value : {1e-3, 0.5, 12.0, 4e6}) {
      EXPECT_NEAR(values.value(values.place(value)), value, value * 1e-9);
      if (scale == ValueScale::kLog) continue;
      EXPECT_NEAR(values.value(values.place(-value)), -value, value * 1e-9);
    }
  }
  const ValueTransform log(ValueScale::kLog, 1);
  EXPECT_TRUE(std::isfinite(log.place(0)));
  EXPECT_TRUE(std::isfinite(log.place(-5)));
  EXPECT_LT(log.place(-5), log.place(1e-9));
  const ValueTransform both(ValueScale::kSignedLog, 1);
  EXPECT_EQ(both.place(0), 0);
  EXPECT_NEAR(both.place(1e6) - both.place(1e5), 1, 1e-4) << "decades";
  EXPECT_EQ(both.place(-1e6), -both.place(1e6));
}

TEST(TypedValue, TakesUnitsAndNoNonsense) {
  EXPECT_EQ(typedTime(QStringLiteral("12.5 ms")), 12'500'000);
  EXPECT_EQ(typedTime(QStringLiteral("-250us")), -250'000);
  EXPECT_EQ(typedTime(QStringLiteral("1.000000001 s")), 1'000'000'001) << "exact";
  EXPECT_EQ(typedTime(QStringLiteral("9000000.000000001 s")), 9'000'000'000'000'001) << "no double";
  EXPECT_EQ(typedTime(QString::fromUtf8("3 µs")), 3000);
  EXPECT_EQ(typedTime(QStringLiteral("7")), 7'000'000) << "without a unit ms";
  EXPECT_EQ(typedTime(QStringLiteral("-0.5 ms")), -500'000);
  for (const char* none : {"", "ms", "1.5 ns", "1 h", "1,2,3 s", "ten s"})
    EXPECT_EQ(typedTime(QLatin1String(none)), std::nullopt) << none;
  EXPECT_EQ(typedDistance(QStringLiteral("50 Hz")), 20'000'000);
  EXPECT_EQ(typedDistance(QStringLiteral("-4 Hz")), -250'000'000);
  EXPECT_EQ(typedDistance(QStringLiteral("0 Hz")), std::nullopt);
  EXPECT_EQ(typedDistance(QStringLiteral("0 ms")), std::nullopt);
  EXPECT_EQ(typedValue(QStringLiteral("1e3"), false), 1000);
  EXPECT_EQ(typedValue(QStringLiteral("1 ms"), false), std::nullopt);
}

TEST(CursorSet, HeldCursorsStayOnTheScreen) {
  CursorSet cursors;
  cursors.follow(kAxisStart, 10 * kSecond);
  cursors.set(CursorSet::kA, kAxisStart + 2 * kSecond);
  cursors.follow(kAxisStart + kSecond, 10 * kSecond);
  EXPECT_EQ(cursors.at(CursorSet::kA), kAxisStart + 2 * kSecond) << "they are moments of the data";
  cursors.setHeld(true);
  cursors.follow(kAxisStart + 3 * kSecond, 20 * kSecond);
  EXPECT_EQ(cursors.at(CursorSet::kA), kAxisStart + 5 * kSecond) << "a tenth from the left, whatever is shown";
  cursors.set(CursorSet::kB, kAxisStart + 13 * kSecond);
  cursors.follow(kAxisStart, 10 * kSecond);
  EXPECT_EQ(cursors.at(CursorSet::kB), kAxisStart + 5 * kSecond);
  cursors.setHeld(false);
  cursors.follow(kAxisStart + kSecond, 10 * kSecond);
  EXPECT_EQ(cursors.at(CursorSet::kB), kAxisStart + 5 * kSecond);
}

class TimeAxisTest : public testing::Test {
 protected:
  TimeAxisTest() {
    view.setFollowable(false);
    view.setBounds(kAxisStart, kAxisStart + 10 * kSecond);
    view.setSpan(10 * kSecond);
    view.showAll();
  }
  std::vector<std::string> labels(int most = 6) {
    std::vector<std::string> words;
    for (const auto& tick : timeAxisOf(view, most).ticks) words.push_back(tick.label.toStdString());
    return words;
  }
  TimeView view;
};

/// The newest sample of a run that has ended is no "now".
TEST(EndedTimeAxis, CountsFromTheEnd) {
  TimeView live;
  live.setBounds(kAxisStart, kAxisStart + 10 * kSecond);
  EXPECT_EQ(timeAxisOf(live, 6).quantity.toStdString(), "Time before now");
  live.setGoesOn(false);
  EXPECT_EQ(timeAxisOf(live, 6).quantity.toStdString(), "Time before the end");
  TimeView other;
  other.follow(live);
  EXPECT_FALSE(other.goesOn());
}

TEST_F(TimeAxisTest, TellsTheTimeOfDay) {
  view.setNotation(Notation::kUtc);
  const auto axis = timeAxisOf(view, 6);
  EXPECT_THAT(axis.quantity.toStdString(), testing::HasSubstr("2026-04-20"));
  EXPECT_THAT(labels(), testing::ElementsAre("11:33:25", "11:33:30"));
  // Ticks stand where their moments are, to the nanosecond that a double leaves.
  EXPECT_NEAR(axis.ticks.front().value, 5 - 0.123456789, 1e-9);
  view.setSpan(10 * kMillisecond);
  for (const auto& label : labels()) EXPECT_THAT(label, testing::HasSubstr("11:33:30.1"));
  EXPECT_GE(labels().size(), 2U);
}

/// Cycles do not come evenly: each label stands at its own cycle.
TEST_F(TimeAxisTest, TellsTheNumberOfTheCycle) {
  view.setNotation(Notation::kCycle);
  EXPECT_TRUE(labels().empty()) << "nobody knows them";
  // 1 kHz, and from 5 s on 2 kHz.
  view.setClocks({[](Nanoseconds time) -> std::optional<std::uint64_t> {
                    const auto since = time - kAxisStart;
                    if (since < 0) return std::nullopt;
                    const auto half = 5 * kSecond;
                    return static_cast<std::uint64_t>(since <= half ? since / kMillisecond
                                                                    : 5000 + (since - half) * 2 / kMillisecond);
                  },
                  {}});
  const auto axis = timeAxisOf(view, 4);
  std::vector<double> places;
  for (const auto& tick : axis.ticks) places.push_back(tick.value);
  EXPECT_THAT(labels(4), testing::ElementsAre("5000", "10000", "15000"));
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0], 5, 1e-6);
  EXPECT_NEAR(places[1], 7.5, 1e-6);
  EXPECT_NEAR(places[2], 10, 1e-6);
}

TEST_F(TimeAxisTest, TellsTheSystemTimeOfTheReferenceClock) {
  view.setNotation(Notation::kDcTime);
  EXPECT_THAT(timeAxisOf(view, 6).quantity.toStdString(), testing::HasSubstr("not known"));
  view.setClocks({{}, [](Nanoseconds time) { return std::optional(time + 1000 * kSecond - 123'456'789); }});
  const auto axis = timeAxisOf(view, 6);
  EXPECT_THAT(axis.quantity.toStdString(), testing::HasSubstr("830001000"));
  ASSERT_GE(axis.ticks.size(), 2U);
  EXPECT_EQ(axis.ticks.front().label, QStringLiteral("2"));
  EXPECT_NEAR(axis.ticks.front().value, 2, 1e-6);
}

/// The unit follows the zoom, and what labels have in common stands in the title.
TEST_F(TimeAxisTest, TheUnitFollowsTheZoom) {
  view.setNotation(Notation::kSinceStart);
  const auto axis_of = [this](Nanoseconds begin, Nanoseconds end) {
    view.setSpan(end - begin);
    view.goTo(kAxisStart + (begin + end) / 2);
    return timeAxisOf(view, 6);
  };
  const auto seconds = axis_of(2 * kSecond, 8 * kSecond);
  EXPECT_EQ(seconds.unit, QStringLiteral("s"));
  EXPECT_EQ(seconds.divisor, 1);
  EXPECT_NEAR(seconds.begin, 2, 1e-9);
  const auto milliseconds = axis_of(5 * kSecond + 250 * kMillisecond, 5 * kSecond + 750 * kMillisecond);
  EXPECT_EQ(milliseconds.unit, QStringLiteral("ms"));
  EXPECT_THAT(milliseconds.quantity.toStdString(), testing::HasSubstr("5 s"));
  EXPECT_NEAR(milliseconds.begin / milliseconds.divisor, 250, 1e-6);
  const auto microseconds = axis_of(5'250'300'000, 5'250'700'000);
  EXPECT_EQ(microseconds.unit, QStringLiteral("\u00B5s"));
  EXPECT_THAT(microseconds.quantity.toStdString(), testing::HasSubstr("5.250 s"));
  EXPECT_NEAR(microseconds.begin / microseconds.divisor, 300, 1e-6);
  EXPECT_NEAR(microseconds.end / microseconds.divisor, 700, 1e-6);
  const auto nanoseconds = axis_of(5'250'300'100, 5'250'310'100);
  EXPECT_EQ(nanoseconds.unit, QStringLiteral("ns"));
  EXPECT_THAT(nanoseconds.quantity.toStdString(), testing::HasSubstr("5.250300 s"));
  EXPECT_NEAR(nanoseconds.begin / nanoseconds.divisor, 100, 1e-6);
}

TEST_F(TimeAxisTest, WhatIsSharedIsToldAlike) {
  TimeView own;
  own.copy(view);
  EXPECT_EQ(own.begin(), view.begin());
  view.setNotation(Notation::kCycle);
  view.setBounds(kAxisStart, kAxisStart + 20 * kSecond);
  own.setSpan(kSecond);
  own.follow(view);
  EXPECT_EQ(own.notation(), Notation::kCycle);
  EXPECT_EQ(own.last(), view.last());
  EXPECT_EQ(own.span(), kSecond);
}

// ---- in the window ----------------------------------------------------------------------------

class PlotAxes : public test::RunningWindow {
 protected:
  LiveStrip& strip() { return window_.liveStrip(); }
  /// The sync window of the demonstration machine, as it runs.
  TracePlot& deviation() { return *strip().panels()[0]->plot(); }
  void settle() {
    for (int round = 0; round < 2; ++round) {
      strip().refresh();
      QApplication::processEvents();
    }
  }
  void mouse(QEvent::Type type, const QPointF& place) {
    QMouseEvent event(type, place, deviation().canvas()->mapToGlobal(place), Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(deviation().canvas(), &event);
  }
};

/// Dragged, the project is another one, as one step; what runs keeps its limit, and both are seen.
TEST_F(PlotAxes, TheLimitOfTheProjectIsDragged) {
  goOnline();
  settle();
  const double limit = deviation().limit();
  ASSERT_GT(limit, 0);
  ASSERT_TRUE(deviation().limitMovable());
  strip().panels()[0]->setLimits(TracePlot::kLeft, AxisLimits{-20 * limit, 20 * limit});
  settle();
  const int steps = workspace_.document().undoStack().count();
  const auto y = [&](double value) { return deviation().transform(QwtPlot::yLeft, value); };
  mouse(QEvent::MouseButtonPress, {50, y(limit)});
  mouse(QEvent::MouseMove, {50, y(7 * limit)});
  EXPECT_GT(deviation().wantedLimit(), 5 * limit) << "it is seen where it goes";
  EXPECT_EQ(workspace_.document().undoStack().count(), steps) << "not before it is let go";
  mouse(QEvent::MouseButtonRelease, {50, y(7 * limit)});
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
  EXPECT_EQ(limitsOf(project()).deviation_ns, 8 * (static_cast<std::uint32_t>(limit) + 1) - 1) << "2^n - 1";
  EXPECT_EQ(deviation().limit(), limit) << "the machine keeps its own";
  EXPECT_EQ(deviation().wantedLimit(), limitsOf(project()).deviation_ns);
  workspace_.document().undoStack().undo();
  settle();
  EXPECT_EQ(deviation().wantedLimit(), 0);
  // Beside a line the plot is dragged as ever.
  mouse(QEvent::MouseButtonPress, {50, y(12 * limit)});
  mouse(QEvent::MouseMove, {80, y(12 * limit)});
  mouse(QEvent::MouseButtonRelease, {80, y(12 * limit)});
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
  EXPECT_FALSE(workspace_.document().undoStack().canRedo() && limitsOf(project()).deviation_ns != limit);
}

TEST_F(PlotAxes, LimitsOfARecordingAreNotTheProjects) {
  goOnline();
  strip().setWantedLimits(std::nullopt);
  EXPECT_FALSE(deviation().limitMovable());
}

TEST_F(PlotAxes, LimitsAreTypedAsOneStepEach) {
  auto& document = workspace_.document();
  load();
  const int steps = document.undoStack().count();
  ASSERT_TRUE(setLimit(document, Signal::kDcmError, 2500));
  EXPECT_EQ(limitsOf(document.project()).dcm_error_ns, 2500);
  ASSERT_TRUE(setLimit(document, Signal::kSlaveDeviation, 500));
  EXPECT_EQ(document.project().master.dc.sync_window.exponent, 9);
  EXPECT_EQ(document.undoStack().count(), steps + 2);
  EXPECT_FALSE(setLimit(document, Signal::kRoundTrip, 500));
}

/// Each plot, not only the user's own.
TEST_F(PlotAxes, EveryPlotHasScaleAndTimeOfItsOwn) {
  goOnline();
  for (auto* panel : strip().panels()) {
    panel->setScale(ValueScale::kSignedLog);
    panel->setOwnTime(true);
    settle();
    EXPECT_EQ(panel->plot()->axis(TracePlot::kLeft).scale(), ValueScale::kSignedLog);
    panel->plot()->timeView()->setSpan(kSecond);
    EXPECT_NE(strip().timeView()->span(), kSecond);
    const auto last = panel->plot()->timeView()->last();
    run(200 * kMillisecond);
    settle();
    EXPECT_GT(panel->plot()->timeView()->last(), last) << "what comes is there, too";
    panel->setOwnTime(false);
    panel->setScale(ValueScale::kLinear);
  }
}

TEST_F(PlotAxes, TheDistanceOfTheCursorsIsTyped) {
  goOnline();
  settle();
  strip().cursors()->set(CursorSet::kA, strip().timeView()->end() - kSecond);
  QTimer::singleShot(0, &strip(), [this] {
    auto* dialog = strip().findChild<QInputDialog*>(QStringLiteral("cursorDistanceDialog"));
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue(QStringLiteral("4 kHz"));
    QTimer::singleShot(0, dialog, [dialog] {
      dialog->setTextValue(QStringLiteral("250 Hz"));
      dialog->accept();
    });
    dialog->accept();
  });
  QKeyEvent press(QEvent::KeyPress, Qt::Key_D, Qt::NoModifier);
  QApplication::sendEvent(&strip(), &press);
  EXPECT_EQ(strip().cursors()->delta(), 4 * kMillisecond) << "what is no time is asked for again";
}

/// Views are the project's: unsaved, no step, and nothing that the machine would do otherwise.
TEST_F(PlotAxes, ViewsAreKeptByTheProjectWhileTheMachineRuns) {
  goOnline();
  strip().showBody(LiveStrip::Body::kFree);
  settle();
  const int steps = workspace_.document().undoStack().count();
  strip().free()->addPlot();
  settle();
  ASSERT_EQ(project().views.size(), 1U);
  EXPECT_EQ(project().views, strip().free()->views());
  EXPECT_TRUE(workspace_.document().isModified());
  EXPECT_EQ(workspace_.document().undoStack().count(), steps);
  EXPECT_FALSE(workspace_.runDifference().differs());
  // Another project brings its own.
  Machine machine;
  machine.networks.push_back(project());
  machine.networks[0].views = {{"Other", {{}}}};
  workspace_.live().shutDown();
  workspace_.document().take(machine, {});
  EXPECT_EQ(strip().free()->views(), machine.networks[0].views);
}

}  // namespace
}  // namespace syncline::ui
