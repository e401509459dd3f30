// SPDX-License-Identifier: Apache-2.0
// What is seen of a recording before its samples are read.
#include "ui/dialogs/opening_picture.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPointer>
#include <QProgressDialog>
#include <QTemporaryDir>
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/recording_schema.h"
#include "record/recording_writer.h"
#include "sqlite/sqlite_database.h"
#include "support/item_picture.h"
#include "support/ui_test_support.h"
#include "tests/core/record/made_samples.h"
#include "ui/dialogs/file_commands.h"
#include "ui/main_window.h"
#include "ui/plots/trace_plot.h"
#include "ui/session/first_pictures.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

using test::waitFor;

constexpr int kPictureWidth = 500, kPictureHeight = 120;

class OpeningPictureTest : public testing::Test {
 protected:
  void SetUp() override {
    config_.slaves.resize(3);
    auto about = about_run(config_);
    about.limits.deviation_ns = 127;
    about.limits.dcm_error_ns = 1000;
    auto writer = RecordingWriter::create(path_.toStdString(), about);
    ASSERT_TRUE(writer);
    syncline::test::MadeSamples made(4);
    for (int i = 0; i < 30; ++i) {
      RecordingBatch batch;
      batch.samples = made.next(1000);
      ASSERT_TRUE(writer->write(batch));
    }
    ASSERT_TRUE(writer->finish("end", {}));
  }
  /// All of it, as it is shown afterwards.
  ReplayedRun whole() const {
    auto reader = RecordingReader::open(path_.toStdString());
    return std::move(*replay_run(*reader, config_));
  }
  OpenedRecording::Outline outline() const {
    auto reader = RecordingReader::open(path_.toStdString());
    const auto info = reader->info();
    return {info->begin, info->end, info->cycles, info->about.limits};
  }

  QTemporaryDir folder_;
  QString path_ = folder_.filePath(QStringLiteral("run.slrec"));
  NetworkConfig config_;
};

QImage pictureOf(SeriesItem& item, const ColumnGrid& grid) {
  return test::itemPicture(item, grid, {kPictureWidth, kPictureHeight}, 1000);
}

/// Those of one range are made together: each has what it would have alone, whichever signals it shares with another.
TEST_F(OpeningPictureTest, PicturesOfOneRangeAreThoseThatEachWouldHaveAlone) {
  auto reader = RecordingReader::open(path_.toStdString());
  ASSERT_TRUE(reader);
  const auto info = reader->info();
  const auto begin = info->begin;
  const auto end = info->end + 1;
  const auto wide = (end - begin) / 300;
  const std::vector<FirstPicture> wanted{
      {{Signal::kDeviation, Signal::kDcmError}, begin, end, wide},
      {{Signal::kDcmError}, begin, end, 2 * wide},
      {{Signal::kDcmError, Signal::kRoundTrip, Signal::kDeviation}, begin, end, wide}};
  FirstPictures together;
  together.ask(wanted);
  const auto made = together.answer(path_.toStdString());
  ASSERT_TRUE(made);
  ASSERT_EQ(made->size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    FirstPictures alone;
    alone.ask({wanted[i]});
    const auto one = alone.answer(path_.toStdString());
    ASSERT_TRUE(one);
    EXPECT_EQ((*made)[i].signals, wanted[i].signals) << i;
    ASSERT_EQ((*made)[i].columns.size(), wanted[i].signals.size()) << i;
    for (std::size_t k = 0; k < wanted[i].signals.size(); ++k) {
      const auto& columns = (*made)[i].columns[k];
      const auto& expected = one->front().columns[k];
      ASSERT_EQ(columns.size(), expected.size());
      EXPECT_TRUE(std::ranges::any_of(columns, &SeriesColumn::valid)) << i << ' ' << k;
      for (std::size_t c = 0; c < columns.size(); ++c) {
        ASSERT_EQ(columns[c].valid, expected[c].valid);
        if (!columns[c].valid) continue;
        ASSERT_EQ(columns[c].min, expected[c].min) << i << ' ' << k << ' ' << c;
        ASSERT_EQ(columns[c].max, expected[c].max) << i << ' ' << k << ' ' << c;
      }
    }
  }
}

TEST_F(OpeningPictureTest, HasThePixelsOfAllSamples) {
  const auto run = whole();
  const auto& store = run.record->samples();
  const auto grid = ColumnGrid::of(store.first_time(), store.last_time(), kPictureWidth);
  FirstPictures pictures;
  pictures.ask({{{Signal::kDcmError, Signal::kDeviation}, grid.origin, grid.end(), grid.width}});
  const auto answer = pictures.answer(path_.toStdString());
  ASSERT_TRUE(answer);
  ASSERT_EQ(answer->size(), 1U);
  for (const auto shape : {SeriesItem::Shape::kEnvelope, SeriesItem::Shape::kLine}) {
    for (std::size_t i = 0; i < 2; ++i) {
      SeriesItem all(QStringLiteral("all"));
      SeriesItem first(QStringLiteral("first"));
      all.setSeries(&store.series(answer->front().signals[i]));
      first.setColumns(answer->front().columns[i], grid.width);
      for (auto* item : {&all, &first}) {
        item->setShape(shape);
        item->setMaxGap(store.longest_gap(Signal::kDeviation));
      }
      EXPECT_EQ(pictureOf(first, grid), pictureOf(all, grid));
      ASSERT_TRUE(first.extent() && all.extent());
      EXPECT_EQ(first.extent()->min, all.extent()->min);
      EXPECT_EQ(first.extent()->max, all.extent()->max);
    }
  }
}

TEST_F(OpeningPictureTest, ShowsNoSeamsWhileItHasOtherColumnsThanPixels) {
  const auto [first, last, cycles, limits] = outline();
  for (const int columns : {kPictureWidth - 13, kPictureWidth + 7, kPictureWidth / 3, 3 * kPictureWidth}) {
    const auto asked = ColumnGrid::of(first, last, columns);
    std::vector<SeriesColumn> flat(static_cast<std::size_t>(asked.columns));
    for (std::size_t i = 0; i < flat.size(); ++i)
      flat[i] = {asked.origin + static_cast<Nanoseconds>(i) * asked.width, -1000, 1000, 0, true};
    SeriesItem item(QStringLiteral("first"));
    item.setColumns(flat, asked.width);
    const auto image = pictureOf(item, ColumnGrid::of(first, last, kPictureWidth));
    int white = 0;
    for (int x = 2; x < kPictureWidth - 2; ++x) white += image.pixel(x, kPictureHeight / 2) == qRgb(255, 255, 255);
    EXPECT_EQ(white, 0) << columns;
  }
}

TEST_F(OpeningPictureTest, AnswersOnceWhatWasAskedLast) {
  FirstPictures pictures;
  EXPECT_FALSE(pictures.answer(path_.toStdString()));
  const auto [first, last, cycles, limits] = outline();
  pictures.ask({{{Signal::kDcmError}, first, last, 1000}});
  pictures.ask({{{Signal::kDeviation}, first, last, (last - first) / 7}});
  const auto answer = pictures.answer(path_.toStdString());
  ASSERT_TRUE(answer);
  ASSERT_EQ(answer->size(), 1U);
  EXPECT_EQ(answer->front().signals, std::vector{Signal::kDeviation});
  EXPECT_FALSE(pictures.answer(path_.toStdString()));
  pictures.ask({{{Signal::kDeviation}, first, last, 1000}});
  pictures.forget();
  EXPECT_FALSE(pictures.answer(path_.toStdString()));
  // Who reads it whole says why it cannot be read.
  pictures.ask({{{Signal::kDeviation}, first, last, 1000}});
  EXPECT_FALSE(pictures.answer("nowhere.slrec"));
}

TEST_F(OpeningPictureTest, DrawsTheWholeOfItAndAsksAnewForWhatIsZoomed) {
  OpeningPicture picture(outline());
  std::optional<std::vector<FirstPicture>> wanted;
  FirstPictures pictures;
  QObject::connect(&picture, &OpeningPicture::wanted, &picture,
                   [&](const std::vector<FirstPicture>& what) { wanted = what; });
  picture.resize(900, 300);
  picture.show();
  picture.refresh();
  ASSERT_TRUE(wanted);
  const auto run = whole();
  const auto& store = run.record->samples();
  const auto expect_same = [&] {
    // Longer numbers beside an axis leave fewer columns: it is asked once more.
    for (int round = 0; wanted; ++round) {
      ASSERT_LT(round, 4);
      ASSERT_EQ(wanted->size(), 2U);
      pictures.ask(*std::exchange(wanted, std::nullopt));
      const auto answer = pictures.answer(path_.toStdString());
      ASSERT_TRUE(answer);
      picture.take(*answer);
      QApplication::processEvents();
      picture.refresh();
    }
    for (const char* name : {"openingDeviationPlot", "openingDcmPlot"}) {
      const auto* plot = picture.findChild<TracePlot*>(QLatin1String(name));
      ASSERT_NE(plot, nullptr);
      EXPECT_GT(plot->limit(), 0);
      const auto signal = name == std::string("openingDcmPlot") ? Signal::kDcmError : Signal::kDeviation;
      std::vector<SeriesColumn> all;
      store.series(signal).columns(plot->grid().origin, plot->grid().end(), plot->grid().width, all);
      const auto& columns = plot->items().front()->columns();
      ASSERT_EQ(columns.size(), all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(columns[i].start, all[i].start);
        EXPECT_EQ(columns[i].valid, all[i].valid);
        EXPECT_EQ(columns[i].min, all[i].min);
        EXPECT_EQ(columns[i].max, all[i].max);
      }
    }
  };
  expect_same();
  picture.timeView()->zoom(0.5, store.first_time());
  picture.refresh();
  ASSERT_TRUE(wanted);
  expect_same();
}

TEST_F(OpeningPictureTest, ComesBeforeTheRecordingIsWhole) {
  OpenedRecording recording;
  std::vector<std::string> order;
  OpenedRecording::Outline told;
  QObject::connect(&recording, &OpenedRecording::outlined, &recording, [&](const OpenedRecording::Outline& outline) {
    told = outline;
    order.emplace_back("outline");
  });
  QObject::connect(&recording, &OpenedRecording::pictured, &recording, [&](const std::vector<FirstPicture>& pictures) {
    order.emplace_back(pictures.front().columns.front().empty() ? "nothing" : "picture");
  });
  QObject::connect(&recording, &OpenedRecording::finished, &recording, [&] { order.emplace_back("whole"); });
  const auto expected = outline();
  recording.picture({{{Signal::kDeviation}, expected.first, expected.last, (expected.last - expected.first) / 100}});
  recording.read(path_);
  ASSERT_TRUE(waitFor([&] { return !recording.isReading(); }));
  EXPECT_EQ(order, (std::vector<std::string>{"outline", "picture", "whole"}));
  EXPECT_EQ(told.first, expected.first);
  EXPECT_EQ(told.last, expected.last);
  EXPECT_EQ(told.cycles, 30'000U);
  EXPECT_EQ(told.limits, expected.limits);
}

/// Its sums are drawn until its samples are read, and found damaged.
TEST_F(OpeningPictureTest, WhatIsFoundDamagedLeavesIt) {
  const auto expected = outline();
  constexpr std::size_t kHarmed = 10;
  {
    auto database = SqlDatabase::open(path_.toStdString());
    ASSERT_TRUE(database);
    const auto row = kHarmed * kSeriesPerBlock + series_number(Signal::kRoundTrip);
    const auto harm = "UPDATE data SET cells = zeroblob(length(cells)) WHERE id = " + std::to_string(row);
    ASSERT_TRUE(database->execute(harm.c_str()));
  }
  const auto block = (*RecordingReader::open(path_.toStdString())->blocks())[kHarmed];
  OpenedRecording recording;
  std::vector<int> drawn;  // of each picture, columns within that block
  QObject::connect(&recording, &OpenedRecording::pictured, &recording, [&](const std::vector<FirstPicture>& pictures) {
    const auto& picture = pictures.front();
    drawn.push_back(static_cast<int>(std::ranges::count_if(picture.columns.front(), [&](const SeriesColumn& column) {
      return column.valid && column.start > block.begin && column.start + picture.width < block.end;
    })));
  });
  const auto width = (block.end - block.begin) / 8;
  recording.picture({{{Signal::kDeviation}, expected.first, expected.last, width}});
  recording.read(path_);
  ASSERT_TRUE(waitFor([&] { return !recording.isReading(); }));
  ASSERT_EQ(drawn.size(), 2U) << "as it was asked for, and once more";
  EXPECT_GT(drawn.front(), 3);
  EXPECT_EQ(drawn.back(), 0);
}

TEST_F(OpeningPictureTest, StandsInTheWindowWhileALongOneIsRead) {
  Workspace workspace(test::virtualEnvironment());
  MainWindow window(workspace);
  window.show();
  window.files().openAny(path_);
  // It goes when all is read, sooner or later.
  const QPointer dialog(window.findChild<QProgressDialog*>(QStringLiteral("recordingProgress")));
  ASSERT_FALSE(dialog.isNull());
  auto few = outline();
  Q_EMIT workspace.recording().outlined(few);
  EXPECT_EQ(dialog->findChild<OpeningPicture*>(), nullptr) << "it is read in an instant";
  auto many = outline();
  many.cycles = 10'000'000;
  Q_EMIT workspace.recording().outlined(many);
  auto* picture = dialog->findChild<OpeningPicture*>();
  ASSERT_NE(picture, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_TRUE(picture->isVisible());
  picture->refresh();
  EXPECT_GT(picture->findChild<TracePlot*>()->grid().columns, 50);
  ASSERT_TRUE(waitFor([&] { return workspace.recording().isOpen(); }));
  EXPECT_TRUE(dialog.isNull() || !dialog->isVisible());
}

}  // namespace
}  // namespace syncline::ui
