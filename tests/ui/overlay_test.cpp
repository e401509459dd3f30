// SPDX-License-Identifier: Apache-2.0
// Another recording over the one that is shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>

#include "record/overlay_anchor.h"
#include "sqlite/sqlite_database.h"
#include "support/running_window.h"
#include "ui/dialogs/file_commands.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overlay_figures.h"
#include "ui/panels/recording_picture.h"
#include "ui/plots/histogram_plot.h"
#include "ui/session/recording_overlay.h"
#include "ui/text/units.h"
#include "ui/window_overlay.h"

namespace syncline::ui {
namespace {

using test::waitFor;

class OverlayTest : public test::RunningWindow {
 protected:
  RecordingOverlay& overlay() { return workspace_.overlay(); }
  LiveStrip& strip() { return window_.liveStrip(); }
  const RunRecord& below() { return *workspace_.recording().run().record; }
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  /// The machine, recorded from `from` after its begin on.
  void record(const char* name, Nanoseconds from, Nanoseconds length) {
    window_.bus().startDemo();
    ASSERT_TRUE(waitFor([this] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    run(from);
    bool ended = false;
    const auto told = QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_, [&ended] { ended = true; });
    ASSERT_TRUE(workspace_.disk().start(path(name)));
    run(length);
    workspace_.document().undoStack().setClean();
    workspace_.runs().shutDown();
    ASSERT_TRUE(waitFor([&ended] { return ended; }));
    QObject::disconnect(told);
  }
  void openBoth() {
    record("before.slrec", 0, 8 * kSecond);
    record("after.slrec", kSecond, 6 * kSecond);
    window_.files().openAny(path("before.slrec"));
    ASSERT_TRUE(waitFor([this] { return workspace_.recording().isOpen(); }));
    lay("after.slrec");
  }
  void lay(const char* name) {
    window_.overlay().open(path(name));
    ASSERT_TRUE(waitFor([this] { return !overlay().isReading(); }));
    ASSERT_EQ(overlay().path(), path(name));
    QApplication::processEvents();
  }
  const SeriesItem& item(std::size_t panel, const MinMaxSeries& series) {
    for (const auto* one : strip().panels()[panel]->plot()->items()) {
      if (one->series() == &series) return *one;
    }
    ADD_FAILURE() << "it is not drawn";
    return *strip().panels()[panel]->plot()->items().front();
  }
  QTemporaryDir folder_;
};

TEST_F(OverlayTest, ItsCurvesLieWhereTheirTimesSay) {
  openBoth();
  EXPECT_TRUE(field("overlayBar").isVisible());
  const auto& other = *overlay().run().record;
  // Begin on begin: the first sample of the one is drawn at the first of the other.
  const auto begin = below().overview().begin, other_begin = other.overview().begin;
  ASSERT_NE(begin, other_begin);
  EXPECT_EQ(overlay().shift(), begin - other_begin);
  const auto& error = item(2, other.samples().series(Signal::kDcmError));
  EXPECT_TRUE(error.isVisible());
  EXPECT_TRUE(item(0, other.samples().series(Signal::kDeviation)).isVisible());
  for (const Nanoseconds since : {3 * kSecond, 4 * kSecond + 17 * kMillisecond, 5 * kSecond}) {
    const auto drawn = error.valueAt(begin + since);
    const auto was = other.samples().series(Signal::kDcmError).at(other_begin + since);
    ASSERT_TRUE(drawn && was);
    EXPECT_EQ(drawn->value, was->value);
    EXPECT_EQ(drawn->time - begin, was->time - other_begin) << "to the nanosecond";
  }
  // Moved, it is what was so much earlier.
  overlay().setOffset(250 * kMillisecond + 3);
  EXPECT_EQ(overlay().place(), RecordingOverlay::Place::kByHand);
  EXPECT_EQ(field<QComboBox>("overlayPlace").currentIndex(), 3);
  EXPECT_EQ(error.shift(), begin - other_begin + 250 * kMillisecond + 3);
  EXPECT_EQ(error.valueAt(begin + 4 * kSecond)->value,
            other.samples().series(Signal::kDcmError).at(other_begin + 4 * kSecond - 250 * kMillisecond - 3)->value);
  // The legend tells whose is whose.
  strip().refresh();
  EXPECT_THAT(strip().panels()[2]->legend()->text().toStdString(),
              testing::AllOf(testing::HasSubstr("raw (before)"), testing::HasSubstr("raw (after)")));
  EXPECT_THAT(strip().panels()[0]->legend()->text().toStdString(), testing::HasSubstr("largest (after)"));
}

/// Columns of what is moved by less than one lie between those of the plot, and nothing is lost.
TEST_F(OverlayTest, AtEveryZoomTheLargestOfItIsDrawn) {
  openBoth();
  const auto& series = overlay().run().record->samples().series(Signal::kDcmError);
  overlay().setOffset(123'457);
  auto& drawn = const_cast<SeriesItem&>(item(2, series));
  const auto shift = overlay().shift();
  const auto begin = below().overview().begin;
  for (const Nanoseconds span : {40 * kMillisecond, kSecond, 5 * kSecond}) {
    const auto grid = ColumnGrid::of(begin + 2 * kSecond, begin + 2 * kSecond + span, 311);
    drawn.prepare(grid);
    ASSERT_TRUE(drawn.extent());
    const auto all = series.extent(grid.origin - shift, grid.end() - shift);
    // The columns at both edges reach beyond them by less than their width.
    const auto wider = series.extent(grid.origin - shift - grid.width, grid.end() - shift + grid.width);
    EXPECT_GE(drawn.extent()->max, all->max);
    EXPECT_LE(drawn.extent()->min, all->min);
    EXPECT_LE(drawn.extent()->max, wider->max);
    EXPECT_GE(drawn.extent()->min, wider->min);
    if (drawn.columns().empty()) continue;
    float largest = -1e9F;
    for (const auto& column : drawn.columns()) {
      if (column.valid) largest = std::max(largest, column.max);
    }
    EXPECT_GE(largest, all->max);
  }
}

TEST_F(OverlayTest, ItIsAlignedByWhatIsAskedFor) {
  openBoth();
  const auto& other = *overlay().run().record;
  auto& place = field<QComboBox>("overlayPlace");
  const auto choose = [&place](int index) {
    place.setCurrentIndex(index);
    Q_EMIT place.activated(index);
  };
  choose(1);
  ASSERT_TRUE(below().overview().armed && other.overview().armed);
  EXPECT_EQ(*other.overview().armed + overlay().shift(), *below().overview().armed);
  EXPECT_EQ(static_cast<Nanoseconds>(std::llround(field<QDoubleSpinBox>("overlayOffset").value() * 1e9)),
            overlay().offset());
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.magnitude = true;
  trigger.level = 200;
  workspace_.trigger().setTrigger(trigger);
  choose(2);
  EXPECT_EQ(overlay().place(), RecordingOverlay::Place::kTrigger);
  const auto first = overlay_anchor(below(), OverlayAlignment::kTrigger, trigger);
  const auto second = overlay_anchor(other, OverlayAlignment::kTrigger, trigger);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(*second + overlay().shift(), *first);
  // Where it does not occur, all stays, and the status bar says why.
  trigger.level = 1e9;
  workspace_.trigger().setTrigger(trigger);
  const auto before = overlay().shift();
  choose(0);
  choose(2);
  EXPECT_EQ(overlay().place(), RecordingOverlay::Place::kBegin);
  EXPECT_EQ(place.currentIndex(), 0);
  EXPECT_NE(overlay().shift(), before);
  choose(0);
  EXPECT_EQ(overlay().offset(), 0);
}

TEST_F(OverlayTest, ItIsMovedByNumberKeysPointerAndCursor) {
  openBoth();
  auto& number = field<QDoubleSpinBox>("overlayOffset");
  number.setFocus();
  number.selectAll();
  QTest::keyClicks(&number, QStringLiteral("1.234567891"));
  QTest::keyClick(&number, Qt::Key_Return);
  EXPECT_EQ(overlay().offset(), 1'234'567'891);
  QTest::keyClick(&number, Qt::Key_Up);
  EXPECT_EQ(overlay().offset(), 1'234'567'891 + below().limits().cycle_time);
  strip().timeView()->setSpan(2 * kSecond);
  const auto view = strip().timeView()->end();
  const auto before = overlay().offset();
  QTest::keyClick(&strip(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(overlay().offset(), before + 10 * kMillisecond);
  QTest::keyClick(&strip(), Qt::Key_Left, Qt::ControlModifier);
  EXPECT_EQ(overlay().offset(), before);
  auto* canvas = strip().panels()[2]->plot()->canvas();
  QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, QPoint(20, 20));
  QTest::mouseMove(canvas, QPoint(50, 20));
  QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, QPoint(50, 20));
  EXPECT_GT(overlay().offset(), before);
  EXPECT_EQ(strip().timeView()->end(), view) << "the picture stands";
  // A moment of it onto cursor A.
  const auto cursor = strip().timeView()->begin() + 500 * kMillisecond;
  strip().cursors()->set(CursorSet::kA, cursor);
  const auto pointed = cursor + 300 * kMillisecond;
  const auto shift = overlay().shift();
  Q_EMIT strip().panels()[2]->plot()->menuRequested(QPoint(), pointed);
  auto* lay = strip().findChild<QAction*>(QStringLiteral("actionOverlayOnCursor"));
  ASSERT_NE(lay, nullptr);
  lay->trigger();
  EXPECT_EQ(overlay().shift(), shift - 300 * kMillisecond);
}

TEST_F(OverlayTest, FiguresOfBothStandSideBySide) {
  openBoth();
  auto& figures = *strip().overlayFigures();
  while (!figures.complete()) figures.refresh();
  figures.refresh();
  EXPECT_TRUE(figures.isVisible());
  const auto all = figures.accessibleDescription().toStdString();
  EXPECT_THAT(all,
              testing::AllOf(testing::HasSubstr("before"), testing::HasSubstr("after"), testing::HasSubstr("p99.99")));
  // Of the range shown: those of the samples in it, of each in its own time.
  strip().timeView()->setSpan(500 * kMillisecond);
  const auto from = below().overview().begin + 4 * kSecond;
  strip().timeView()->goTo(from + 250 * kMillisecond);
  do {
    figures.refresh();
  } while (!figures.complete());
  figures.refresh();
  const auto& series = overlay().run().record->samples().series(Signal::kDcmError);
  double largest = 0;
  series.for_each(strip().timeView()->begin() - overlay().shift(), strip().timeView()->end() + 1 - overlay().shift(),
                  [&largest](Nanoseconds, float value) {
                    if (!std::isnan(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
                  });
  ASSERT_GT(largest, 0);
  const auto lines = figures.accessibleDescription();
  const auto wanted = timeText(std::llround(largest)).replace(QChar::Nbsp, u' ');
  EXPECT_TRUE(lines.section(QLatin1String("after"), 1).contains(wanted)) << qPrintable(lines) << largest;
  EXPECT_NE(lines.toStdString(), all);
}

/// Copied figures: each row has a name, and those of the other are of its samples at the times where it is drawn.
TEST_F(OverlayTest, CopiedFiguresOfTheOtherHaveItsNameAndItsSamples) {
  openBoth();
  // What is drawn there now has other times of its own.
  overlay().setOffset(3 * kSecond);
  strip().timeView()->setSpan(500 * kMillisecond);
  strip().timeView()->goTo(below().overview().begin + 5 * kSecond);
  strip().refresh();
  const auto begin = strip().timeView()->begin() - overlay().shift(),
             end = strip().timeView()->end() - overlay().shift();
  const auto& series = overlay().run().record->samples().series(Signal::kDcmError);
  int wanted = 0;
  series.for_each(begin, end + 1, [&wanted](Nanoseconds, float value) { wanted += std::isnan(value) ? 0 : 1; });
  ASSERT_GT(wanted, 300);
  const auto lines = strip().panels()[2]->figures();
  const auto other = std::find_if(lines.begin(), lines.end(), [](const QString& line) {
    return line.section(u'\t', 0, 0).contains(QLatin1String("after"));
  });
  ASSERT_NE(other, lines.end()) << lines.join(u'\n').toStdString();
  EXPECT_EQ(other->section(u'\t', 9, 9).toInt(), wanted) << qPrintable(*other);
  for (const auto& line : lines) EXPECT_FALSE(line.section(u'\t', 0, 0).isEmpty()) << qPrintable(line);
}

TEST_F(OverlayTest, TheDistributionCountsBoth) {
  openBoth();
  strip().showBody(LiveStrip::Body::kDistribution);
  strip().distribution()->setSources({{Signal::kDcmError, 0}, {Signal::kDeviation, 0}});
  strip().timeView()->setSpan(kSecond);
  strip().timeView()->goTo(below().overview().begin + 4 * kSecond);
  do {
    strip().refresh();
  } while (!strip().distribution()->complete());
  strip().refresh();
  const auto* table = strip().findChild<QTableWidget*>(QStringLiteral("distributionFigures"));
  ASSERT_EQ(table->columnCount(), 4);
  EXPECT_TRUE(table->horizontalHeaderItem(0)->text().endsWith(QLatin1String("(before)")));
  EXPECT_TRUE(table->horizontalHeaderItem(1)->text().endsWith(QLatin1String("(after)")));
  const auto& series = overlay().run().record->samples().series(Signal::kDcmError);
  std::size_t count = 0;
  series.for_each(strip().timeView()->begin() - overlay().shift(), strip().timeView()->end() + 1 - overlay().shift(),
                  [&count](Nanoseconds, float value) { count += std::isnan(value) ? 0 : 1; });
  ASSERT_GT(count, 500U);
  EXPECT_EQ(table->item(5, 1)->text(), countText(count));
  EXPECT_EQ(strip().csv().substr(0, strip().csv().find('\n')),
            "from,to,dcm_error_ns,deviation_ns,dcm_error_ns (after),deviation_ns (after)");
  overlay().close();
  strip().refresh();
  EXPECT_EQ(table->columnCount(), 2);
}

TEST_F(OverlayTest, ItGoesAloneOrWithTheOneBelow) {
  openBoth();
  field<QToolButton>("overlayClose").click();
  EXPECT_FALSE(overlay().isOpen());
  EXPECT_FALSE(field("overlayBar").isVisible());
  EXPECT_FALSE(strip().overlayFigures()->isVisible());
  EXPECT_EQ(strip().panels()[2]->overlay().record, nullptr);
  for (const auto* drawn : strip().panels()[2]->plot()->items()) EXPECT_EQ(drawn->shift(), 0);
  EXPECT_THAT(strip().panels()[2]->legend()->text().toStdString(), testing::Not(testing::HasSubstr("before")));
  lay("after.slrec");
  EXPECT_TRUE(overlay().isOpen());
  workspace_.recording().close();
  EXPECT_FALSE(overlay().isOpen());
  EXPECT_FALSE(window_.findChild<QAction*>(QStringLiteral("actionOverlay"))->isEnabled());
  strip().refresh();
}

TEST_F(OverlayTest, WhatIsNoRecordingIsRefusedAndAllStays) {
  openBoth();
  QFile none(path("none.slrec"));
  ASSERT_TRUE(none.open(QIODevice::WriteOnly));
  none.write("no recording");
  none.close();
  bool told = false;
  QTimer::singleShot(0, &window_, [&told] {
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (auto* box = qobject_cast<QMessageBox*>(widget); box != nullptr && box->isVisible()) {
        told = true;
        box->close();
      }
    }
  });
  window_.overlay().open(path("none.slrec"));
  ASSERT_TRUE(waitFor([this] { return !overlay().isReading(); }));
  ASSERT_TRUE(waitFor([&] {
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (auto* box = qobject_cast<QMessageBox*>(widget); box != nullptr && box->isVisible()) {
        told = true;
        box->close();
      }
    }
    return told;
  }));
  EXPECT_EQ(overlay().path(), path("after.slrec"));
}

/// What is damaged in the file that lies over it is a gap there, and is told.
TEST_F(OverlayTest, WhatIsDamagedInTheOtherIsAFinding) {
  record("before.slrec", 0, 4 * kSecond);
  record("after.slrec", kSecond, 4 * kSecond);
  ASSERT_TRUE(SqlDatabase::open(path("after.slrec").toStdString())
                  ->execute("UPDATE data SET cells = zeroblob(length(cells)) WHERE id = 1048576 + 3"));
  window_.files().openAny(path("before.slrec"));
  ASSERT_TRUE(waitFor([this] { return workspace_.recording().isOpen(); }));
  const auto told = [this] {
    QStringList where;
    const auto& findings = workspace_.findings();
    for (int row = 0; row < findings.rowCount({}); ++row) {
      if (findings.index(row, 0).data(FindingModel::kCodeRole) == QLatin1String("recording-damaged"))
        where << findings.index(row, FindingModel::kWhere).data().toString();
    }
    return where;
  };
  EXPECT_TRUE(told().isEmpty());
  lay("after.slrec");
  EXPECT_EQ(told(), QStringList{QStringLiteral("after")});
  overlay().close();
  EXPECT_TRUE(told().isEmpty());
}

/// In a replay the other lies where it lay.
TEST_F(OverlayTest, WhileTheOneBelowIsPlayedItStays) {
  openBoth();
  const auto shift = overlay().shift();
  workspace_.replay().seek(below().overview().begin + 5 * kSecond);
  EXPECT_EQ(overlay().shift(), shift);
  EXPECT_EQ(strip().panels()[2]->overlay().record, overlay().run().record.get());
  strip().refresh();
}

TEST_F(OverlayTest, APictureHasBoth) {
  openBoth();
  RecordingPicture wanted;
  ASSERT_TRUE(writeRecordingPicture(workspace_.recording().run(), wanted, path("one.svg")));
  wanted.overlay = {overlay().run().record.get(), overlay().shift(), overlay().ownName(), overlay().name()};
  ASSERT_TRUE(writeRecordingPicture(workspace_.recording().run(), wanted, path("both.svg")));
  const auto content = [this](const char* name) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  EXPECT_TRUE(content("both.svg").contains("raw (after)"));
  EXPECT_TRUE(content("both.svg").contains("p99.99"));
  EXPECT_FALSE(content("one.svg").contains("(after)"));
}

}  // namespace
}  // namespace syncline::ui
