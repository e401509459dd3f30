// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QStackedLayout>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "channels/cycle_sample.h"
#include "ui/plots/limit_band_item.h"

namespace syncline::ui {
namespace {

using Mode = TimeView::Mode;
constexpr Nanoseconds kStart = 830'000'000 * kSecond;

/// One sample a millisecond: a one-sample spike at 2.5 s, lost frames from 3 s to 3.2 s, a missed SM2
/// event of slave 2 at 4 s.
std::vector<CycleSample> samples(std::uint64_t from, std::uint64_t to) {
  std::vector<CycleSample> result;
  for (auto i = from; i < to; ++i) {
    CycleSample s;
    s.cycle = i;
    s.send_time = kStart + static_cast<Nanoseconds>(i) * kMillisecond;
    s.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
              CycleSample::kReferenceValid;
    s.deviation_ns = i == 2500 ? 900 : 30;
    s.slave_position = static_cast<std::int16_t>(i % 3);
    s.slave_deviation_ns = static_cast<std::int32_t>(i % 3) * 10 - 10;
    s.dcm_error_ns = i % 2 == 0 ? 200 : -200;
    s.dcm_error_filtered_ns = 5;
    s.drift_ppm = 12.5F;
    if (i >= 3000 && i < 3200) {
      s.flags = CycleSample::kFrameLost | CycleSample::kDcmActive;
      s.slave_position = -1;
    }
    if (i % 250 == 0 && (i < 3000 || i >= 3200)) {
      s.sm2_position = 2;
      s.slave_sm2_missed = i < 4000 ? 7 : 8;
    }
    result.push_back(s);
  }
  return result;
}

/// What runs: the names, the cycle, and a sync window of 2^exponent - 1 ns.
NetworkConfig runningNetwork(const std::vector<std::string>& names, Nanoseconds cycle_time, std::uint8_t exponent = 9) {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = cycle_time;
  for (const auto& name : names) config.slaves.emplace_back().name = name;
  config.dc.enabled = true;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = exponent;
  return config;
}

class LiveStripTest : public testing::Test {
 protected:
  void SetUp() override {
    strip.resize(1280, 230);
    run(runningNetwork({"1 Coupler", "2 Input", "3 Servo"}, kMillisecond));
  }
  /// Another run begins.
  void run(NetworkConfig config) {
    const auto before = std::exchange(record, std::make_unique<RunRecord>(std::move(config)));
    strip.setRecord(record.get());
  }
  void show() {
    strip.show();
    settle();
  }
  /// Lays out and paints; no time passes.
  void settle() {
    strip.refresh();
    QApplication::processEvents();
    strip.refresh();
    QApplication::processEvents();
  }
  void key(int code) {
    QKeyEvent press(QEvent::KeyPress, code, Qt::NoModifier);
    QApplication::sendEvent(plot(0), &press);
  }
  TracePlot* plot(std::size_t i) { return strip.panels()[i]->plot(); }
  std::uint64_t paints() { return plot(0)->paintCount() + plot(1)->paintCount() + plot(2)->paintCount(); }
  QString text(const char* name) { return strip.findChild<QLabel*>(QLatin1String(name))->text(); }

  std::unique_ptr<RunRecord> record;
  LiveStrip strip;
};

TEST_F(LiveStripTest, SaysWhatToDoWithoutData) {
  show();
  auto* label = strip.findChild<QLabel*>(QStringLiteral("liveEmptyLabel"));
  EXPECT_TRUE(label->isVisible());
  EXPECT_THAT(label->text().toStdString(), testing::HasSubstr("go online"));
  record->add(samples(0, 100));
  settle();
  EXPECT_FALSE(label->isVisible());
  EXPECT_TRUE(plot(0)->isVisible());
  strip.setRecord(nullptr);
  settle();
  EXPECT_TRUE(label->isVisible());
}

TEST_F(LiveStripTest, FillsAllThreePlots) {
  show();
  record->add(samples(0, 6000));
  settle();
  EXPECT_FALSE(plot(0)->items().front()->columns().empty());
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::HasSubstr("largest 30"));
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::HasSubstr("3 Servo +10"));
  EXPECT_THAT(strip.panels()[0]->readout().toStdString(), testing::HasSubstr("900"));
  EXPECT_THAT(strip.panels()[1]->legend()->text().toStdString(), testing::HasSubstr("#2 3 Servo 8"));
  EXPECT_THAT(strip.panels()[1]->readout().toStdString(), testing::HasSubstr("/s"));
  EXPECT_THAT(strip.panels()[2]->readout().toStdString(), testing::HasSubstr("12.50"));
  EXPECT_GE(plot(0)->axis(TracePlot::kLeft).high(), 900) << "the spike is inside the axis";
}

/// One clock is read a cycle, in turn; the frame of each cycle tells the largest.
TEST_F(LiveStripTest, LegendsSayHowFarToBelieveTheirSignals) {
  show();
  auto all = samples(0, 6000);
  for (auto& sample : all) {
    sample.stamped_by = StampSource::kKernel;
    sample.stamp_doubt_ns = (sample.flags & CycleSample::kFrameLost) != 0 ? -1 : 1'200;
  }
  record->add(all);
  settle();
  auto about = strip.panels()[0]->legend()->about().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(about, testing::HasSubstr("largest 30 ns\n\u20031000 readings a second; the newest is 0 ns old; "
                                        "by the clocks of the slaves \u00B110 ns; moment stamped by the kernel, "
                                        "within 1.200 \u00B5s"));
  EXPECT_THAT(about, testing::HasSubstr("3 Servo +10 ns\n\u2003333 readings a second"));
  about = strip.panels()[2]->legend()->about().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(about, testing::HasSubstr("by the reference clock and the host's clock \u00B11.210 \u00B5s"));
}

TEST_F(LiveStripTest, AsManySlavesAreDrawnAsAreWanted) {
  run(runningNetwork({"0", "1", "2", "3", "4", "5", "6", "7"}, kMillisecond));
  auto all = samples(0, 2000);
  for (auto& sample : all) {
    sample.slave_position = static_cast<std::int16_t>(sample.cycle % 8);
    sample.slave_deviation_ns = 10 * (sample.slave_position + 1);
  }
  show();
  record->add(all);
  settle();
  auto* panel = strip.panels()[0];
  const auto drawn = [&] { return panel->legend()->entries().size() - 1; };
  EXPECT_EQ(panel->slavesShown(), 3);
  EXPECT_EQ(drawn(), 3U);
  panel->setSlavesShown(6);
  settle();
  EXPECT_EQ(drawn(), 6U);
  EXPECT_EQ(panel->legend()->entries().back().short_name, QStringLiteral("#7"));
  panel->setSlavesShown(1);
  settle();
  ASSERT_EQ(drawn(), 1U);
  EXPECT_EQ(panel->legend()->entries().back().short_name, QStringLiteral("#7")) << "the worst one";
  EXPECT_EQ(std::ranges::count_if(panel->plot()->items(), &SeriesItem::isVisible), 2);
}

TEST_F(LiveStripTest, HiddenPlotsAreNotPainted) {
  record->add(samples(0, 1000));
  for (int i = 0; i < 100; ++i) strip.refresh();
  QApplication::processEvents();
  EXPECT_EQ(paints(), 0U);
  show();
  EXPECT_GT(paints(), 0U);
  strip.hide();
  const auto before = paints();
  record->add(samples(1000, 2000));
  for (int i = 0; i < 100; ++i) strip.refresh();
  QApplication::processEvents();
  EXPECT_EQ(paints(), before);
}

TEST_F(LiveStripTest, OnePaintAPlotAndTick) {
  show();
  record->add(samples(0, 1000));
  settle();
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto before = paints();
    record->add(samples(1000 + i * 10, 1005 + i * 10));
    record->add(samples(1005 + i * 10, 1010 + i * 10));
    strip.refresh();
    QApplication::processEvents();
    EXPECT_LE(paints() - before, 3U);
    EXPECT_GE(paints() - before, 3U);
  }
  const auto before = paints();
  strip.refresh();
  QApplication::processEvents();
  EXPECT_EQ(paints(), before) << "nothing new, nothing drawn";
}

TEST_F(LiveStripTest, FrozenPictureIsNotPaintedAndSamplesGoOnBeingKept) {
  show();
  record->add(samples(0, 1000));
  settle();
  key(Qt::Key_Space);
  EXPECT_EQ(strip.timeView()->mode(), Mode::kFrozen);
  settle();
  const auto before = paints();
  record->add(samples(1000, 4000));
  for (int i = 0; i < 30; ++i) strip.refresh();
  QApplication::processEvents();
  EXPECT_EQ(paints(), before);
  EXPECT_EQ(strip.store()->last_time(), kStart + 3999 * kMillisecond);
  EXPECT_THAT(text("liveStateLabel").toStdString(), testing::HasSubstr("3.000"));
  key(Qt::Key_Space);
  settle();
  EXPECT_EQ(strip.timeView()->mode(), Mode::kLive);
  EXPECT_EQ(strip.timeView()->end(), strip.store()->last_time());
}

TEST_F(LiveStripTest, WheelZoomsAllPlotsWhileDataStream) {
  show();
  record->add(samples(0, 5000));
  settle();
  auto* canvas = plot(1)->canvas();
  const QPointF at(canvas->width() / 2.0, 20);
  const auto anchor = plot(1)->timeAt(at.x());
  QWheelEvent wheel(at, canvas->mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(canvas, &wheel);
  record->add(samples(5000, 6000));
  settle();
  EXPECT_EQ(strip.timeView()->mode(), Mode::kHistory);
  EXPECT_LT(strip.timeView()->span(), 7 * kSecond);
  EXPECT_NEAR(static_cast<double>(plot(1)->timeAt(at.x()) - anchor), 0, static_cast<double>(2 * plot(1)->grid().width));
  EXPECT_EQ(plot(0)->grid().width, plot(2)->grid().width) << "linked";
  const auto span = strip.timeView()->span();
  key(Qt::Key_End);
  settle();
  EXPECT_EQ(strip.timeView()->span(), span);
  EXPECT_TRUE(strip.findChild<QToolButton*>(QStringLiteral("liveButton"))->isChecked());
}

TEST_F(LiveStripTest, LostFramesAreAGapInThePicture) {
  show();
  record->add(samples(0, 6000));
  settle();
  strip.timeView()->zoom(0.1, kStart + 3100 * kMillisecond);  // 1 s about the gap
  settle();
  const auto image = plot(2)->canvas()->grab().toImage();
  const auto painted = [&](Nanoseconds time) {
    const int x = static_cast<int>(plot(2)->grid().column_of(time));
    const auto raw = plot(2)->items().front()->color();
    for (int y = 0; y < image.height(); ++y) {
      if (QColor(image.pixel(x, y)) == raw) return true;
    }
    return false;
  };
  EXPECT_TRUE(painted(kStart + 2950 * kMillisecond));
  EXPECT_FALSE(painted(kStart + 3100 * kMillisecond));
  EXPECT_TRUE(painted(kStart + 3250 * kMillisecond));
}

/// Frozen within an outage, neither the plots nor the legends show what was read before it.
TEST_F(LiveStripTest, NothingIsDrawnOrSaidThroughAnOutage) {
  show();
  record->add(samples(0, 3190));  // lost frames from 3 s on
  settle();
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::HasSubstr("largest \u2013"));
  EXPECT_THAT(strip.panels()[1]->legend()->text().toStdString(), testing::HasSubstr("#2 3 Servo \u2013"));
  EXPECT_THAT(strip.panels()[2]->legend()->text().toStdString(),
              testing::AllOf(testing::HasSubstr("raw \u2013"), testing::HasSubstr("filtered \u2013")));
  EXPECT_THAT(strip.panels()[2]->readout().toStdString(), testing::HasSubstr("\u2013"));
  strip.timeView()->zoom(0.1, kStart + 3100 * kMillisecond);
  settle();
  const auto outage = plot(1)->grid().column_of(kStart + 3 * kSecond);
  for (const auto* item : {plot(1)->items().front(), plot(2)->items().back()}) {
    for (const auto& point : item->points()) {
      EXPECT_TRUE(std::isnan(point.y()) || point.x() <= outage + 1) << point.x();
    }
  }
}

TEST_F(LiveStripTest, LimitIsThatOfTheConfigurationThatRuns) {
  run(runningNetwork({"1 Drive"}, kMillisecond, 10));
  record->add(samples(0, 100));
  show();
  settle();
  double limit = 0;
  for (auto* item : plot(0)->itemList()) {
    if (const auto* found = dynamic_cast<LimitBandItem*>(item)) limit = found->limit();
  }
  EXPECT_EQ(limit, 1023);
}

/// Of the master synchronisation the filtered error has one, and a running master may be given another.
TEST_F(LiveStripTest, TheErrorOfTheMasterHasItsLimitToo) {
  run(runningNetwork({"1 Drive"}, kMillisecond, 10));
  record->add(samples(0, 100));
  show();
  settle();
  ASSERT_GT(record->limits().dcm_error_ns, 0);
  EXPECT_EQ(plot(2)->limit(), static_cast<double>(record->limits().dcm_error_ns));
  Snapshot now;
  now.online = true;
  now.dcm.in_sync_limit = 900;
  now.dcm.times_configured = 1;
  record->add(now);
  record->add(samples(100, 200));
  settle();
  EXPECT_EQ(plot(2)->limit(), 900);
  // Its words can be read whatever is drawn there.
  double words = 0, curves = 0;
  for (auto* item : plot(2)->itemList()) {
    if (dynamic_cast<LimitWordsItem*>(item) != nullptr) words = item->z();
    if (dynamic_cast<SeriesItem*>(item) != nullptr) curves = std::max(curves, item->z());
  }
  EXPECT_GT(words, curves);
}

TEST_F(LiveStripTest, CursorsMeasure) {
  show();
  record->add(samples(0, 6000));
  settle();
  strip.cursors()->set(CursorSet::kA, kStart + 2400 * kMillisecond);
  strip.cursors()->set(CursorSet::kB, kStart + 2600 * kMillisecond);
  settle();
  EXPECT_THAT(text("cursorDeltaLabel").toStdString(),
              testing::AllOf(testing::HasSubstr("+200.000"), testing::HasSubstr("5 Hz")));
  EXPECT_THAT(strip.panels()[0]->readout().toStdString(), testing::HasSubstr("max +900"));
  EXPECT_THAT(strip.panels()[2]->readout().toStdString(),
              testing::AllOf(testing::HasSubstr("min \u2212200"), testing::HasSubstr("max +200")));
  key(Qt::Key_Escape);
  settle();
  EXPECT_TRUE(text("cursorDeltaLabel").isEmpty());
}

TEST_F(LiveStripTest, LegendReadsTheValueUnderThePointer) {
  show();
  record->add(samples(0, 6000));
  settle();
  key(Qt::Key_Space);
  strip.cursors()->setPointer(kStart + 2500 * kMillisecond + 10);
  settle();
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::HasSubstr("900"));
}

TEST_F(LiveStripTest, CsvHoldsTheShownRange) {
  show();
  record->add(samples(0, 6000));
  strip.timeView()->setSpan(kSecond);
  settle();
  const auto table = strip.csv();
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 1001);
  EXPECT_THAT(table, testing::AllOf(testing::StartsWith("time_ns,time_utc,cycle,lateness_ns,"),
                                    testing::HasSubstr(",dcm_error_ns,")));
  EXPECT_THAT(table, testing::HasSubstr("deviation_ns 3 Servo"));
  EXPECT_THAT(table, testing::ContainsRegex("\n5999000000,[-0-9T:.]*Z,5999,"));
}

/// Where the store has forgotten the beginning, times are still counted from there, as the overview counts them.
TEST_F(LiveStripTest, TimesAreCountedFromTheBeginningOfTheRun) {
  const auto before = std::exchange(
      record, std::make_unique<RunRecord>(runningNetwork({"1 Coupler", "2 Input", "3 Servo"}, kMillisecond), 1000));
  strip.setRecord(record.get());
  show();
  for (std::uint64_t i = 0; i < 120; ++i) record->add(samples(i * 100, i * 100 + 100));
  strip.timeView()->setSpan(100 * kMillisecond);
  settle();
  ASSERT_GT(record->samples().first_time(), kStart);
  EXPECT_EQ(strip.timeView()->origin(), kStart);
  EXPECT_THAT(strip.csv(), testing::HasSubstr("\n11999000000,"));
  strip.setRecord(nullptr);
  EXPECT_EQ(strip.timeView()->origin(), 0);
}

/// A click puts the cursor there; the next one finds the event all the same.
TEST_F(LiveStripTest, AClickFindsTheEventUnderTheCursor) {
  show();
  record->add(samples(0, 6000));
  const auto fault = kStart + 5 * kSecond;
  record->add(Event{fault, 1, events::SlaveLost{}});
  settle();
  key(Qt::Key_Space);
  settle();
  int clicks = 0;
  QObject::connect(&strip, &LiveStrip::eventClicked, &strip, [&](qint64 moment) {
    EXPECT_EQ(moment, fault);
    strip.cursors()->set(CursorSet::kA, moment);
    ++clicks;
  });
  auto* canvas = plot(0)->canvas();
  const auto* view = strip.timeView();
  const double part = static_cast<double>(fault - view->begin()) / static_cast<double>(view->span());
  const QPoint place(static_cast<int>(part * canvas->width()), canvas->height() / 2);
  for (int i = 1; i <= 2; ++i) {
    QTest::mousePress(canvas, Qt::LeftButton, {}, place);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, place);
    EXPECT_EQ(clicks, i);
  }
}

TEST_F(LiveStripTest, EveryControlHasNames) {
  show();
  record->add(samples(0, 100));
  settle();
  for (const auto* button : strip.findChildren<QToolButton*>()) {
    EXPECT_FALSE(button->objectName().isEmpty());
    EXPECT_FALSE(button->accessibleName().isEmpty()) << button->objectName().toStdString();
  }
  for (const auto* panel : strip.panels()) {
    EXPECT_FALSE(panel->plot()->accessibleName().isEmpty());
    EXPECT_FALSE(panel->plot()->accessibleDescription().isEmpty());
  }
}

TEST_F(LiveStripTest, NewNetworkStartsEmpty) {
  show();
  record->add(samples(0, 1000));
  settle();
  run(runningNetwork({"1 Other"}, 250 * kMicrosecond));
  settle();
  EXPECT_TRUE(strip.store()->empty());
  record->add(samples(0, 50));
  settle();
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::HasSubstr("1 Other"));
  EXPECT_THAT(strip.panels()[0]->legend()->text().toStdString(), testing::Not(testing::HasSubstr("Servo")));
}

TEST_F(LiveStripTest, PictureIsLightWhateverTheThemeIs) {
  show();
  record->add(samples(0, 1000));
  settle();
  const auto image = QImage::fromData(pictureFile(strip.picture(), PictureForm::kPng));
  EXPECT_GT(image.width(), 2400);
  EXPECT_EQ(image.pixel(1, 1), qRgb(255, 255, 255));
}

/// How many pixels are no paper.
int inked(const QImage& image, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) count += qGray(image.pixel(x, y)) < 200 ? 1 : 0;
  }
  return count;
}

TEST_F(LiveStripTest, DrawingsHaveLinesAndLettersWherePixelsAre) {
  show();
  record->add(samples(0, 6000));
  settle();
  strip.timeView()->showAll();
  settle();
  const auto picture = strip.picture();
  // Smoothly: half of the lines that are left out might be a line of the plot.
  const auto pixels = QImage::fromData(pictureFile(picture, PictureForm::kPng))
                          .scaled(picture.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  const auto svg = pictureFile(picture, PictureForm::kSvg);
  EXPECT_TRUE(svg.contains("<text"));
  EXPECT_FALSE(svg.contains("<image")) << "pixels in it";
  EXPECT_TRUE(svg.contains(picture.title.toUtf8()));
  QSvgRenderer drawing(svg);
  ASSERT_TRUE(drawing.isValid());
  EXPECT_EQ(drawing.viewBox().size(), picture.size);
  QImage drawn(picture.size, QImage::Format_RGB32);
  drawn.fill(Qt::white);
  QPainter painter(&drawn);
  drawing.render(&painter, QRectF({}, QSizeF(picture.size)));
  painter.end();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* canvas = plot(i)->canvas();
    const QRect where(canvas->mapTo(strip.panels()[i]->parentWidget(), QPoint()) + QPoint(10, 10), canvas->size());
    const int there = inked(pixels, where);
    EXPECT_GT(there, 100) << i;
    EXPECT_NEAR(inked(drawn, where), there, there / 2) << i << ": as much as in pixels";
  }
  const auto pdf = pictureFile(picture, PictureForm::kPdf);
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_FALSE(pdf.contains("/Subtype /Image")) << "pixels in it";
  EXPECT_TRUE(pdf.contains("/MediaBox"));
  EXPECT_GT(pdf.size(), 20'000);
}

/// An SVG is not clipped: a line to the reading before the stretch must end at the canvas, not on the scale.
TEST_F(LiveStripTest, DrawingsStayInsideTheirPlots) {
  show();
  record->add(samples(0, 1000));
  settle();
  strip.timeView()->freeze();
  strip.timeView()->setSpan(2 * kMillisecond);
  strip.timeView()->goTo(kStart + 501'300 * kMicrosecond);
  settle();
  const auto picture = strip.picture();
  QSvgRenderer drawing(pictureFile(picture, PictureForm::kSvg));
  QImage drawn(picture.size, QImage::Format_RGB32);
  drawn.fill(Qt::white);
  QPainter painter(&drawn);
  drawing.render(&painter, QRectF({}, QSizeF(picture.size)));
  painter.end();
  const auto* canvas = plot(0)->canvas();
  const QRect at(canvas->mapTo(strip.panels()[0]->parentWidget(), QPoint()) + QPoint(10, 10), canvas->size());
  int inside = 0, outside = 0;
  for (int y = at.top(); y <= at.bottom(); ++y) {
    for (int x = 0; x <= at.right() + 20; ++x) {
      if (drawn.pixelColor(x, y).hsvSaturation() < 60) continue;
      ++(at.adjusted(-2, 0, 2, 0).contains(x, y) ? inside : outside);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_EQ(outside, 0) << "lines of slaves on the scale";
}

TEST_F(LiveStripTest, PictureIsWrittenAsItsNameSays) {
  show();
  record->add(samples(0, 1000));
  settle();
  const QTemporaryDir folder;
  const auto save = [&](const QString& name, int filter) {
    Q_EMIT plot(0)->menuRequested(QPoint(10, 10), 0);
    auto* menu = strip.findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    QTimer::singleShot(0, &strip, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      dialog->setDirectory(folder.path());
      dialog->findChild<QWidget*>(QStringLiteral("listView"))->setFocus();
      dialog->selectFile(name.isEmpty() ? QStringLiteral("syncline.png") : name);
      if (filter >= 0) {
        dialog->selectNameFilter(dialog->nameFilters()[filter]);
        Q_EMIT dialog->filterSelected(dialog->nameFilters()[filter]);
      }
      dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
    });
    for (auto* action : menu->actions()) {
      if (action->objectName() == QLatin1String("actionExportPicture")) action->trigger();
    }
    delete menu;
  };
  const auto begin = [&](const char* name) {
    QFile file(folder.filePath(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.read(5) : QByteArray();
  };
  save({}, -1);
  EXPECT_EQ(begin("syncline.png"), "\x89PNG\r");
  save({}, 2);
  EXPECT_EQ(begin("syncline.pdf"), "%PDF-") << "the name follows the list of forms";
  save(QStringLiteral("plots"), 1);
  EXPECT_EQ(begin("plots.svg"), "<?xml") << QDir(folder.path()).entryList().join(u' ').toStdString();
  save(QStringLiteral("other.PDF"), -1);
  EXPECT_EQ(begin("other.PDF"), "%PDF-");
  // The dialog for the name is in front first, for however long.
  QString said;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &strip, [&said] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    said = box->text();
    box->accept();
  });
  look.start(10);
  save(QStringLiteral("other.bmp"), -1);
  EXPECT_TRUE(said.contains(QStringLiteral("other.bmp"))) << said.toStdString();
  EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("other.bmp"))));
}

}  // namespace
}  // namespace syncline::ui
