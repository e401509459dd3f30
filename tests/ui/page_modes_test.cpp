// SPDX-License-Identifier: Apache-2.0
// All pages of a node, those that configure, or those that diagnose.
#include <gtest/gtest.h>

#include <QAction>
#include <QTabWidget>
#include <QTemporaryDir>

#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/pages/device_editor.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

using PagesMode = DeviceEditor::Mode;

class PageModes : public test::ProjectWindow {
 protected:
  PageModes() : ProjectWindow(machine()) {}
  /// A coupler, and a drive that has objects.
  static Project machine() {
    auto project = test::smallProject();
    project.slaves[1].device.mailbox.emplace().coe.emplace();
    return project;
  }
  void choose(const char* mode) { window_.findChild<QAction*>(QLatin1String(mode))->trigger(); }
  int pages() { return window_.editor().tabs()->count(); }
};

TEST_F(PageModes, ShowThePagesOfTheirPurpose) {
  EXPECT_EQ(window_.editor().mode(), PagesMode::kAll);
  window_.selectNode(1);
  const int all = pages();
  choose("pagesConfiguration");
  const int configuring = pages();
  EXPECT_TRUE(has(1, "slaveDcPage"));
  EXPECT_TRUE(has(1, "processDataPage"));
  EXPECT_FALSE(has(1, "slaveObjectsPage"));
  choose("pagesDiagnosis");
  const int diagnosing = pages();
  EXPECT_TRUE(has(1, "slaveObjectsPage"));
  EXPECT_FALSE(has(0, "slaveObjectsPage")) << "it does not speak CoE";
  EXPECT_FALSE(has(0, "slaveHistoryPage")) << "it does not speak CoE";
  EXPECT_TRUE(has(1, "slaveCountersPage"));
  EXPECT_TRUE(has(1, "slaveDcPage")) << "shows both";
  EXPECT_FALSE(has(1, "processDataPage"));
  EXPECT_TRUE(has(-1, "masterDcPage"));
  EXPECT_FALSE(has(-1, "eniPage"));
  EXPECT_LT(configuring, all);
  EXPECT_LT(diagnosing, all);
  EXPECT_GE(configuring + diagnosing, all);
}

/// Counts the pages that are shown, each of which is laid out for it.
class ShownPages : public QObject {
 public:
  int count = 0;
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show) ++count;
    return QObject::eventFilter(watched, event);
  }
};

TEST_F(PageModes, AnotherNodeShowsNoPageButTheOneInFront) {
  window_.selectNode(-1);
  ShownPages shown;
  for (auto* page : window_.editor().findChildren<Page*>()) page->installEventFilter(&shown);
  window_.selectNode(1);
  EXPECT_EQ(shown.count, 1);
  EXPECT_TRUE(window_.editor().tabs()->currentWidget()->isVisible());
}

TEST(RememberedPageModes, StayWithinWhatThereIs) {
  const QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("settings.ini"));
  Workspace workspace(environment);
  DeviceEditor(workspace).setMode(PagesMode::kDiagnosis);
  EXPECT_EQ(DeviceEditor(workspace).mode(), PagesMode::kDiagnosis);
  workspace.memory().setValue(QStringLiteral("pages/shown"), 99);
  EXPECT_EQ(DeviceEditor(workspace).mode(), PagesMode::kDiagnosis) << "a file may hold anything";
  workspace.memory().setValue(QStringLiteral("pages/shown"), QStringLiteral("-1"));
  EXPECT_EQ(DeviceEditor(workspace).mode(), PagesMode::kAll);
}

TEST_F(PageModes, GiveWayToAFieldThatIsWanted) {
  choose("pagesDiagnosis");
  EXPECT_TRUE(window_.editor().showKey(QStringLiteral("slave.1.watchdog.divider")));
  EXPECT_EQ(window_.editor().mode(), PagesMode::kAll);
}

TEST_F(PageModes, WaitForAFieldThatHoldsNoValue) {
  show(1, "slaveGeneralPage");
  test::type(field("slaveAddress"), QStringLiteral("99999999"), false);
  choose("pagesConfiguration");
  EXPECT_EQ(window_.editor().mode(), PagesMode::kAll);
  EXPECT_TRUE(window_.findChild<QAction*>(QStringLiteral("pagesAll"))->isChecked());
}

}  // namespace
}  // namespace syncline::ui
