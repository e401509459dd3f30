// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cut_short_dialog.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <atomic>
#include <thread>
#include <vector>

#include "support/ui_test_support.h"

namespace syncline {
namespace {

struct Ended {
  int position;
  bool undo;
};

/// Two writes that were cut short; slave 3 cannot be reached.
class CutShort : public ::testing::Test {
 protected:
  CutShort()
      : repair_({[this] { return writes_; },
                 [this](const ui::CutShortWrite& write, bool undo, const std::atomic<bool>& cancel) -> Status {
                   if (wait_for_cancel_) {
                     while (!cancel) std::this_thread::yield();
                     return fail(ErrorCode::kCancelled);
                   }
                   if (write.position == 3) return fail(ErrorCode::kNoResponse, "slave 3");
                   ended_.push_back({write.position, undo});
                   return {};
                 }}),
        dialog_(repair_) {
    QObject::connect(&dialog_, &ui::CutShortDialog::told, &dialog_, [this](const QString& text) { told_ << text; });
  }
  void click(const char* name) {
    test::find<QPushButton>(dialog_, name)->click();
    ASSERT_TRUE(test::waitFor([this] { return !repair_.isRunning(); }));
  }
  QString text(const char* name) { return test::find<QLabel>(dialog_, name)->text(); }

  std::vector<ui::CutShortWrite> writes_{{QStringLiteral("nic:a"), 1, QStringLiteral("2026-03-01 12:00:00")},
                                         {QStringLiteral("nic:a"), 2, QStringLiteral("2026-03-01 12:00:05")}};
  std::vector<Ended> ended_;
  bool wait_for_cancel_ = false;
  QStringList told_;
  ui::EepromRepair repair_;
  ui::CutShortDialog dialog_;
};

TEST_F(CutShort, NothingIsOfferedWhenNothingWasCutShort) {
  writes_.clear();
  dialog_.offer();
  EXPECT_FALSE(dialog_.isVisible());
}

TEST_F(CutShort, OneIsFinishedTheOtherPutBack) {
  dialog_.offer();
  ASSERT_TRUE(dialog_.isVisible());
  EXPECT_TRUE(text("cutShortText").contains(QLatin1String("slave 1 on nic:a")));
  EXPECT_TRUE(text("cutShortText").contains(QLatin1String("2026-03-01 12:00:00")));
  click("cutShortFinish");
  EXPECT_TRUE(text("cutShortText").contains(QLatin1String("slave 2 on nic:a")));
  click("cutShortPutBack");
  EXPECT_FALSE(dialog_.isVisible());
  ASSERT_EQ(ended_.size(), 2U);
  EXPECT_EQ(ended_[0].position, 1);
  EXPECT_FALSE(ended_[0].undo);
  EXPECT_EQ(ended_[1].position, 2);
  EXPECT_TRUE(ended_[1].undo);
  ASSERT_EQ(told_.size(), 2);
  EXPECT_TRUE(told_[0].contains(QLatin1String("written and verified"))) << qPrintable(told_[0]);
  EXPECT_TRUE(told_[1].contains(QLatin1String("old contents again"))) << qPrintable(told_[1]);
}

TEST_F(CutShort, WhatCannotBeReachedIsSaidAndMayBeTriedAgain) {
  writes_ = {{QStringLiteral("nic:a"), 3, QStringLiteral("2026-03-01 12:00:00")}};
  dialog_.offer();
  click("cutShortFinish");
  EXPECT_TRUE(dialog_.isVisible());
  EXPECT_TRUE(text("cutShortProblem").contains(QLatin1String("slave 3"))) << qPrintable(text("cutShortProblem"));
  for (const char* name : {"cutShortText", "cutShortProblem"}) {
    const auto* label = test::find<QLabel>(dialog_, name);
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name << " is cut";
  }
  EXPECT_TRUE(test::find<QPushButton>(dialog_, "cutShortFinish")->isEnabled());
  click("cutShortLater");
  EXPECT_FALSE(dialog_.isVisible());
  ASSERT_EQ(told_.size(), 1);
  EXPECT_TRUE(told_[0].contains(QLatin1String("still half written")));
}

TEST_F(CutShort, ARunningWriteIsEndedInOrderFirst) {
  wait_for_cancel_ = true;
  dialog_.offer();
  test::find<QPushButton>(dialog_, "cutShortFinish")->click();
  EXPECT_TRUE(repair_.isRunning());
  EXPECT_FALSE(test::find<QPushButton>(dialog_, "cutShortPutBack")->isEnabled());
  click("cutShortLater");
  EXPECT_TRUE(dialog_.isVisible()) << "it says what became of it";
  EXPECT_TRUE(told_.isEmpty());
}

}  // namespace
}  // namespace syncline
