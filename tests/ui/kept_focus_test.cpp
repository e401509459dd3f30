// SPDX-License-Identifier: Apache-2.0
// Who is disabled while having the focus does not hand it to a neighbour, which would take what is typed next.
#include "ui/widgets/kept_focus.h"

#include <gtest/gtest.h>

#include <QDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <set>

#include "support/editable_project.h"
#include "support/project_window.h"
#include "support/running_window.h"
#include "ui/editors/page.h"

namespace syncline::ui {
namespace {

/// A row of a button and a number, and a button in another row.
class AFieldBesideAButton : public ::testing::Test {
 protected:
  AFieldBesideAButton() : filter_(nullptr) {
    auto* layout = new QHBoxLayout(&window_);
    row_ = new QWidget;
    auto* row = new QHBoxLayout(row_);
    row->addWidget(button_ = new QPushButton(QStringLiteral("Read")));
    row->addWidget(number_ = new QSpinBox);
    layout->addWidget(row_);
    layout->addWidget(other_ = new QPushButton(QStringLiteral("Other")));
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
    button_->setFocus();
  }
  void typeDigit() {
    number_->selectAll();
    QTest::keyClick(window_.focusWidget(), Qt::Key_7);
  }

  KeptFocus filter_;
  QWidget window_;
  QWidget* row_;
  QPushButton *button_, *other_;
  QSpinBox* number_;
};

TEST_F(AFieldBesideAButton, GetsNothingThatIsTypedWhileTheButtonIsBusy) {
  button_->setEnabled(false);
  EXPECT_EQ(window_.focusWidget(), row_);
  typeDigit();
  EXPECT_EQ(number_->value(), 0);
  button_->setEnabled(true);
  EXPECT_EQ(window_.focusWidget(), button_);
}

TEST_F(AFieldBesideAButton, GetsNothingWhereTheButtonGoes) {
  button_->hide();
  EXPECT_EQ(window_.focusWidget(), row_);
  typeDigit();
  EXPECT_EQ(number_->value(), 0);
}

TEST_F(AFieldBesideAButton, KeepsTheFocusThatItWasGivenMeanwhile) {
  button_->setEnabled(false);
  number_->setFocus();
  button_->setEnabled(true);
  EXPECT_EQ(window_.focusWidget(), number_);
  typeDigit();
  EXPECT_EQ(number_->value(), 7);
}

TEST_F(AFieldBesideAButton, IsTheNextOneByTab) {
  button_->setEnabled(false);
  QTest::keyClick(window_.focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(window_.focusWidget(), number_);
}

/// What a question is about begins before the window is the active one again.
TEST_F(AFieldBesideAButton, GetsNothingWhereTheButtonIsBusyBehindADialog) {
  QDialog question(&window_);
  question.show();
  question.activateWindow();
  ASSERT_TRUE(test::waitFor([&question] { return QApplication::activeWindow() == &question; }));
  button_->setEnabled(false);
  EXPECT_EQ(window_.focusWidget(), row_);
  question.hide();
  window_.activateWindow();
  static_cast<void>(QTest::qWaitForWindowActive(&window_));
  typeDigit();
  EXPECT_EQ(number_->value(), 0);
  button_->setEnabled(true);
  EXPECT_EQ(window_.focusWidget(), button_);
}

TEST_F(AFieldBesideAButton, IsLeftAloneByARowThatIsDisabledWhole) {
  row_->setEnabled(false);
  EXPECT_NE(window_.focusWidget(), other_);
  row_->setEnabled(true);
  EXPECT_EQ(window_.focusWidget(), button_);
}

class FocusOfThePages : public test::ProjectWindow {
 protected:
  FocusOfThePages() : ProjectWindow(test::projectOfFamilies()) { workspace_.setExpert(true); }

  /// Those that take keys, one after the other, disabled and enabled again.
  void lookAt(Page& page) {
    for (auto* widget : page.findChildren<QWidget*>()) {
      if (!widget->isVisible() || !widget->isEnabled() || !(widget->focusPolicy() & Qt::TabFocus)) continue;
      widget->setFocus();
      if (window_.focusWidget() != widget) continue;  // it hands the focus to a part of itself
      const auto name = page.objectName() + u' ' + widget->objectName();
      widget->setEnabled(false);
      auto* now = window_.focusWidget();
      EXPECT_TRUE(now != nullptr && now->isAncestorOf(widget))
          << qPrintable(name) << " gives it to " << (now == nullptr ? "nobody" : qPrintable(now->objectName()));
      widget->setEnabled(true);
      EXPECT_EQ(window_.focusWidget(), widget) << qPrintable(name);
      ++seen_;
    }
  }

  int seen_ = 0;
};

TEST_F(FocusOfThePages, StaysWhereAFieldIsDisabled) {
  std::set<QString> pages;
  for (const int node : {-1, 0, 1, 2, 3, 4}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      pages.insert(page->objectName());
      lookAt(*page);
    }
  }
  EXPECT_GE(pages.size(), 20U);
  EXPECT_GE(seen_, 200);
}

/// As undoing what brought the slave does.
TEST_F(FocusOfThePages, GoesToNoFieldOfThePageThatComes) {
  show(1, "slaveDcPage");
  field("operationMode").setFocus();
  ASSERT_TRUE(field("operationMode").hasFocus());
  window_.selectNode(-1);
  EXPECT_EQ(window_.focusWidget(), window_.editor().tabs()->tabBar());
}

class FocusOfARunningMachine : public test::RunningWindow {};

TEST_F(FocusOfARunningMachine, StaysWithTheButtonThatReadsTheEeprom) {
  goOnline();
  window_.activateWindow();  // again, after the progress of the scan
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  show(kServo, "slaveEepromPage");
  run(100 * kMillisecond);
  auto& read = field<QPushButton>("eepromRead");
  auto& alias = field<QSpinBox>("eepromAlias");
  const int before = alias.value();
  read.setFocus();
  QTest::keyClick(&read, Qt::Key_Space);
  ASSERT_FALSE(read.isEnabled());
  QTest::keyClick(window_.focusWidget(), Qt::Key_7);
  EXPECT_EQ(alias.value(), before);
  for (int i = 0; i < 200 && !read.isEnabled(); ++i) run(100 * kMillisecond);
  ASSERT_TRUE(read.isEnabled());
  EXPECT_EQ(window_.focusWidget(), &read);
}

}  // namespace
}  // namespace syncline::ui
