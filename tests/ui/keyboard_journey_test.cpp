// SPDX-License-Identifier: Apache-2.0
// From the scan to the export with nothing but the keyboard: every control on the way is reached as a user reaches it.
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>

#include "support/ui_test_support.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

class KeyboardJourney : public ::testing::Test {
 protected:
  /// More than the window has controls: who is not there by then is in no tab order.
  static constexpr int kMostSteps = 150;

  KeyboardJourney() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~KeyboardJourney() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }

  const Project& project() { return workspace_.document().project(); }
  static QWidget* focus() { return QApplication::focusWidget(); }
  /// To whoever has the focus, as the keyboard does.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(focus() != nullptr ? focus() : &window_, key, modifiers);
  }
  static void type(const QString& text) { QTest::keyClicks(focus(), text); }
  /// The control, or a part of it, has the focus.
  static bool isAt(const QString& name) {
    for (auto* at = focus(); at != nullptr; at = at->parentWidget()) {
      if (at->objectName() == name) return true;
    }
    return false;
  }
  void tabTo(const char* name, Qt::Key by = Qt::Key_Tab) {
    const auto wanted = QString::fromLatin1(name);
    QStringList way;
    for (int i = 0; i < kMostSteps && !isAt(wanted); ++i) {
      key(by, by == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
      way << (focus() != nullptr ? focus()->objectName() : QStringLiteral("nobody"));
    }
    ASSERT_TRUE(isAt(wanted)) << name << " is not reached: " << qPrintable(way.join(QStringLiteral(", ")));
  }
  /// By the tab bar and its arrow keys.
  void openPage(const char* page) {
    auto* tabs = window_.editor().tabs();
    tabTo("deviceTabs");
    key(Qt::Key_Home);
    for (int i = 0; i < tabs->count() && tabs->currentWidget()->objectName() != QLatin1String(page); ++i)
      key(Qt::Key_Right);
    ASSERT_EQ(tabs->currentWidget()->objectName(), QLatin1String(page));
  }

  Workspace workspace_;
  MainWindow window_;
};

TEST_F(KeyboardJourney, LeadsFromTheScanToTheExport) {
  key(Qt::Key_F6);
  auto* chooser = qobject_cast<LinkChooser*>(QApplication::activeModalWidget());
  if (chooser == nullptr) chooser = window_.findChild<LinkChooser*>();
  ASSERT_NE(chooser, nullptr);
  ASSERT_TRUE(test::waitFor([chooser] { return chooser->isActiveWindow(); }));
  key(Qt::Key_Return);
  ASSERT_TRUE(test::waitFor([this] { return !workspace_.scan().isRunning() && !project().slaves.empty(); }));
  // A window manager would give the focus back; nothing else stands in the way.
  ASSERT_TRUE(test::waitFor([] { return QApplication::activeModalWidget() == nullptr; }));
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));

  // The master: master shift and a window of 2^9 - 1 ns.
  tabTo("explorerTree");
  key(Qt::Key_Home);
  ASSERT_NO_FATAL_FAILURE(openPage("masterDcPage"));
  ASSERT_NO_FATAL_FAILURE(tabTo("dcmBusShift"));
  // The arrows go by where the modes stand on the page.
  for (const auto arrow : {Qt::Key_Down, Qt::Key_Right, Qt::Key_Up}) {
    if (project().master.dc.dcm.mode != DcmMode::kMasterShift) key(arrow);
  }
  EXPECT_EQ(project().master.dc.dcm.mode, DcmMode::kMasterShift);
  ASSERT_NO_FATAL_FAILURE(tabTo("syncWindow"));
  if (!project().master.dc.sync_window.enabled) key(Qt::Key_Space);
  ASSERT_NO_FATAL_FAILURE(tabTo("syncWindowExponent"));
  key(Qt::Key_A, Qt::ControlModifier);
  type(QStringLiteral("9"));
  key(Qt::Key_Return);
  EXPECT_TRUE(project().master.dc.sync_window.enabled);
  EXPECT_EQ(project().master.dc.sync_window.exponent, 9);

  // The last slave with SYNC0: 30 us later.
  int drive = -1;
  for (std::size_t i = 0; i < project().slaves.size(); ++i) {
    if (!project().slaves[i].dc.op_mode.empty()) drive = static_cast<int>(i);
  }
  ASSERT_GE(drive, 0);
  ASSERT_NO_FATAL_FAILURE(tabTo("explorerTree", Qt::Key_Backtab));
  key(Qt::Key_Home);
  for (int i = 0; i < kMostSteps && window_.editor().node() != drive; ++i) key(Qt::Key_Down);
  ASSERT_EQ(window_.editor().node(), drive);
  ASSERT_NO_FATAL_FAILURE(openPage("slaveDcPage"));
  ASSERT_NO_FATAL_FAILURE(tabTo("sync0Shift"));
  key(Qt::Key_A, Qt::ControlModifier);
  type(QStringLiteral("30"));
  key(Qt::Key_Return);
  EXPECT_EQ(project().slaves[static_cast<std::size_t>(drive)].dc.sync0.shift, 30 * kMicrosecond);

  // On the bus and off it again.
  key(Qt::Key_F5);
  ASSERT_TRUE(test::waitFor([this] {
    workspace_.live().advance(100 * kMillisecond);
    return workspace_.live().snapshot().state == AlState::kOp;
  }));
  key(Qt::Key_F5, Qt::ShiftModifier);
  ASSERT_TRUE(test::waitFor([this] { return workspace_.live().phase() == LiveSession::Phase::kOffline; }));

  // The ENI.
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("keys.xml"));
  QTimer::singleShot(0, &window_, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    // This dialog is the toolkit's; the field for the name has the focus.
    auto* name = dialog->focusWidget();
    EXPECT_EQ(name->objectName(), QStringLiteral("fileNameEdit"));
    QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(name, path);
    // The list of what the name might become takes the first Return, as it does under the user's hands.
    for (int i = 0; i < 2 && dialog->isVisible(); ++i) {
      auto* popup = QApplication::activePopupWidget();
      QTest::keyClick(popup != nullptr ? popup : name, Qt::Key_Return);
    }
    EXPECT_FALSE(dialog->isVisible()) << "Return takes the name";
    if (dialog->isVisible()) dialog->reject();
  });
  key(Qt::Key_E, Qt::ControlModifier);
  QFile file(path);
  const auto& messages = workspace_.messages();
  ASSERT_TRUE(file.open(QIODevice::ReadOnly))
      << qPrintable(messages.rowCount() > 0 ? messages.message(messages.rowCount() - 1).text : QString());
  const auto eni = file.readAll();
  EXPECT_TRUE(eni.contains("<ShiftTime>30000</ShiftTime>"));
}

}  // namespace
}  // namespace syncline::ui
