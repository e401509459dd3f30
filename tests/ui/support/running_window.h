// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>
#include <QUndoStack>

#include "ui/dialogs/bus_commands.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"
#include "ui_test_support.h"

namespace syncline::test {

/// The window on the demonstration machine, which runs as far as the test lets it.
class RunningWindow : public ::testing::Test {
 protected:
  static constexpr int kCoupler = 0, kServo = 3, kOtherServo = 4;

  RunningWindow() : workspace_(virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~RunningWindow() override {
    workspace_.runs().shutDown();
    workspace_.document().undoStack().setClean();
  }

  const Project& project() { return workspace_.document().project(); }
  /// The machine in the window, offline.
  void load() {
    goOnline();
    workspace_.live().shutDown();
  }
  void goOnline() {
    window_.bus().startDemo();
    ASSERT_TRUE(waitFor([this] { return workspace_.live().phase() != ui::LiveSession::Phase::kOffline; }));
    for (int i = 0; i < 100 && workspace_.live().snapshot().state != AlState::kOp; ++i) run(200 * kMillisecond);
    workspace_.document().undoStack().setClean();
    ASSERT_EQ(workspace_.live().snapshot().state, AlState::kOp);
    run(100 * kMillisecond);
  }
  /// Machine time, a tick of the window at a time.
  void run(Nanoseconds duration) {
    for (Nanoseconds done = 0; done < duration; done += 20 * kMillisecond) workspace_.live().advance(20 * kMillisecond);
    QApplication::processEvents();
  }
  template <class Widget = QWidget>
  Widget& field(const char* name) {
    return *find<Widget>(window_, name);
  }
  void show(int node, const char* page) {
    window_.selectNode(node);
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->widget(i)->objectName() == QLatin1String(page)) tabs->setCurrentIndex(i);
    }
    ASSERT_EQ(tabs->currentWidget()->objectName(), QLatin1String(page));
  }
  /// The next question is answered as soon as it is there.
  void answerQuestion(const char* name, bool yes) {
    QTimer::singleShot(0, &window_, [this, name, yes] {
      for (auto* widget : QApplication::topLevelWidgets()) {
        auto* box = qobject_cast<QMessageBox*>(widget);
        if (box == nullptr || !box->isVisible()) continue;
        EXPECT_EQ(box->objectName(), QLatin1String(name));
        asked_ = box->text() + u' ' + box->informativeText();
        auto* go = box->findChild<QPushButton*>(QStringLiteral("questionGo"));
        (yes ? go : box->button(QMessageBox::Cancel))->click();
      }
    });
  }

  QString asked_;
  ui::Workspace workspace_;
  ui::MainWindow window_;
};

}  // namespace syncline::test
