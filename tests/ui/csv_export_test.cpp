// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/csv_export.h"

#include <gtest/gtest.h>

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QWidget>
#include <optional>

#include "support/ui_test_support.h"
#include "support/whole_file.h"
#include "trace/min_max_series.h"

namespace syncline::ui {
namespace {

using test::waitFor;

constexpr Nanoseconds kFirstRow = 830'000'000 * kSecond;

class CsvExportTest : public testing::Test {
 protected:
  CsvExportTest() {
    for (int i = 0; i < 300'000; ++i) {
      series_.append(kFirstRow + i * kMillisecond, static_cast<float>(i % 1000));
      if (i % 3 == 0) slower_.append(kFirstRow + i * kMillisecond, static_cast<float>(i % 7) - 3.5F);
    }
    QObject::connect(&exported_, &CsvExport::finished, &window_, [this] { finished_ = true; });
    QObject::connect(&exported_, &CsvExport::failed, &window_, [this](const Error& error) { failed_ = error.code; });
  }
  CsvTable table() const {
    return {{{"a_ns", &series_}, {"b_ns", &slower_}}, {}, kFirstRow, kFirstRow, kFirstRow + 400 * kSecond};
  }
  std::string path(const char* name) const { return folder_.filePath(QLatin1String(name)).toStdString(); }

  MinMaxSeries series_{1U << 19}, slower_{1U << 18};
  QTemporaryDir folder_;
  QWidget window_;
  CsvExport exported_{&window_};
  bool finished_ = false;
  std::optional<ErrorCode> failed_;
};

/// The window's thread is never away for long, and yet the file is what it would be at once.
TEST_F(CsvExportTest, WritesInPortionsWhatItWouldAtOnce) {
  int turns = 0, told = 0;
  QObject::connect(&exported_, &CsvExport::progress, &window_, [&told](int) { ++told; });
  exported_.start(QString::fromStdString(path("a.csv")), table());
  EXPECT_TRUE(exported_.isBusy());
  EXPECT_FALSE(read_whole_file(path("a.csv"))) << "nothing has the name before it is whole";
  ASSERT_TRUE(waitFor([&] {
    ++turns;
    return finished_;
  }));
  EXPECT_GT(told, 3);
  EXPECT_FALSE(exported_.isBusy());
  const auto written = read_whole_file(path("a.csv"));
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, series_csv(table()));
}

TEST_F(CsvExportTest, WhatIsCancelledLeavesNoFile) {
  exported_.start(QString::fromStdString(path("b.csv")), table());
  auto* dialog = window_.findChild<QDialog*>(QStringLiteral("csvProgress"));
  ASSERT_NE(dialog, nullptr);
  dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
  EXPECT_EQ(failed_, ErrorCode::kCancelled);
  EXPECT_FALSE(read_whole_file(path("b.csv")));
  // The next one is not disturbed by what was on its way.
  exported_.start(QString::fromStdString(path("c.csv")), table());
  ASSERT_TRUE(waitFor([this] { return finished_; }));
  EXPECT_EQ(read_whole_file(path("c.csv")).value_or(""), series_csv(table()));
}

TEST_F(CsvExportTest, AFileThatCannotBeWrittenIsTold) {
  exported_.start(folder_.filePath(QStringLiteral("none/d.csv")), table());
  ASSERT_TRUE(waitFor([this] { return failed_.has_value(); }));
  EXPECT_EQ(*failed_, ErrorCode::kFileNotWritable);
}

}  // namespace
}  // namespace syncline::ui
