// SPDX-License-Identifier: Apache-2.0
// Small ways through the window: back to the pages, help of a field, room for the pages, names of widgets.
#include <gtest/gtest.h>

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QLabel>
#include <QListWidget>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeView>
#include <QUndoStack>
#include <QWhatsThis>

#include "settings/settings_table.h"
#include "support/running_window.h"
#include "support/speak.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/editors/page.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/plots/time_view.h"
#include "ui/plots/trace_panel.h"

namespace syncline::ui {
namespace {

using WaysOfTheWindow = test::RunningWindow;

TEST_F(WaysOfTheWindow, AClickOnTheSelectedNodeShowsItsPages) {
  goOnline();
  auto* overview = window_.findChild<OverviewPanel*>();
  ASSERT_TRUE(overview->isVisible());
  auto& tree = field<QTreeView>("explorerTree");
  const auto selected = tree.currentIndex();
  ASSERT_TRUE(selected.isValid());
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(selected).center());
  EXPECT_FALSE(overview->isVisible());
  EXPECT_TRUE(window_.editor().isVisible());
}

TEST_F(WaysOfTheWindow, TheKeyOfHelpTellsOfTheFieldThatHasTheFocus) {
  load();
  show(kServo, "slaveGeneralPage");
  auto& alias = field("slaveAlias");
  alias.setFocus();
  const auto told = [] {
    for (const auto* widget : QApplication::topLevelWidgets()) {
      if (widget->isVisible() && widget->inherits("QWhatsThat")) return true;
    }
    return false;
  };
  ASSERT_FALSE(told());
  QTest::keyClick(&alias, Qt::Key_F1, Qt::ShiftModifier);
  EXPECT_FALSE(QWhatsThis::inWhatsThisMode()) << "nobody has to point at it once more";
  EXPECT_TRUE(told());
  QWhatsThis::hideText();
  ASSERT_TRUE(test::waitFor([&] { return !told(); }));
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  field("explorerTree").setFocus();
  int asked = 0;
  QObject::connect(window_.findChild<QAction*>(QStringLiteral("actionFieldHelp")), &QAction::triggered, &window_,
                   [&asked] { ++asked; });
  QTest::keyClick(&field("explorerTree"), Qt::Key_F1, Qt::ShiftModifier);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(QWhatsThis::inWhatsThisMode()) << "what has no help is pointed at";
  QWhatsThis::leaveWhatsThisMode();
}

TEST_F(WaysOfTheWindow, ThePagesHaveTheRoomWhileThereIsNothingToPlot) {
  window_.resize(1280, 800);
  goOnline();
  window_.selectNode(kServo);
  QApplication::processEvents();
  const int usual = window_.liveStrip().height();
  workspace_.live().shutDown();
  workspace_.document().replace(QStringLiteral("another machine"), test::smallProject());
  QApplication::processEvents();
  EXPECT_LT(window_.liveStrip().height(), usual);
  EXPECT_EQ(window_.liveStrip().height(), window_.liveStrip().minimumHeight());
  EXPECT_LE(window_.liveStrip().height(), 2 * window_.fontMetrics().height()) << "a line that says why";
  EXPECT_GT(window_.editor().height(), 2 * window_.liveStrip().height());
  goOnline();
  window_.selectNode(kServo);
  QApplication::processEvents();
  EXPECT_EQ(window_.liveStrip().height(), usual) << "as it was";
}

TEST_F(WaysOfTheWindow, ThePageOfASlaveIsThatOfTheNextOneAlsoByWayOfTheMaster) {
  load();
  show(kServo, "slaveRegistersPage");
  window_.selectNode(-1);
  EXPECT_NE(window_.place().page, QStringLiteral("slaveRegistersPage"));
  window_.selectNode(kOtherServo);
  EXPECT_EQ(window_.place().page, QStringLiteral("slaveRegistersPage"));
}

/// Values that the ESI gives for 1 ms are written for the cycle that is set.
TEST_F(WaysOfTheWindow, TheStartUpPageSaysWhatIsSentOtherwise) {
  load();
  show(kServo, "slaveStartupPage");
  auto& sent = field<QLabel>("startupSent");
  EXPECT_FALSE(sent.isVisible()) << qPrintable(sent.text());
  const auto& cycle = settings::row("master.cycle_time_us");
  ASSERT_TRUE(workspace_.document().set(QStringLiteral("cycle"), {{&cycle, {}, std::int64_t{500 * kMicrosecond}}}));
  static_cast<void>(workspace_.configuration().current());
  QApplication::processEvents();
  ASSERT_TRUE(sent.isVisible());
  EXPECT_TRUE(sent.text().contains(QStringLiteral("0x60C2:01 = 0x05"))) << qPrintable(sent.text());
  EXPECT_TRUE(sent.text().contains(QStringLiteral("0x60C2:02 = 0xFC"))) << qPrintable(sent.text());
  EXPECT_TRUE(sent.text().contains(QStringLiteral("500")));
}

/// No two commands of the window hear the same key where both are there.
TEST_F(WaysOfTheWindow, EachKeyHasOneCommand) {
  QHash<QKeySequence, QString> used;
  for (const auto* action : window_.findChildren<QAction*>()) {
    const bool of_a_part =
        action->shortcutContext() == Qt::WidgetWithChildrenShortcut || action->shortcutContext() == Qt::WidgetShortcut;
    if (of_a_part) continue;
    for (const auto& key : action->shortcuts()) {
      EXPECT_FALSE(used.contains(key)) << qPrintable(key.toString()) << ": " << qPrintable(action->objectName())
                                       << " and " << qPrintable(used[key]);
      used[key] = action->objectName();
    }
  }
  for (const auto* action : window_.findChildren<QAction*>()) {
    if (action->shortcutContext() != Qt::WidgetWithChildrenShortcut || !action->objectName().startsWith(u"action"))
      continue;
    for (const auto& key : action->shortcuts())
      EXPECT_FALSE(used.contains(key)) << "in its part of the window neither is done: " << qPrintable(key.toString())
                                       << " " << qPrintable(action->objectName()) << " and " << qPrintable(used[key]);
  }
}

/// The figures of the plots stay; the plots come back by a click, or because something is to be shown in them.
TEST_F(WaysOfTheWindow, ALowWindowLeavesThePagesTheRoomOfThePlots) {
  window_.resize(1280, 800);
  goOnline();
  window_.selectNode(kServo);
  QApplication::processEvents();
  auto& strip = window_.liveStrip();
  EXPECT_FALSE(strip.isFolded());
  window_.resize(1024, 640);
  QApplication::processEvents();
  QApplication::processEvents();
  ASSERT_TRUE(strip.isFolded());
  EXPECT_LT(strip.height(), 4 * window_.fontMetrics().height());
  EXPECT_GE(window_.editor().tabs()->currentWidget()->height(), 190);
  EXPECT_TRUE(strip.panels().front()->legend()->isVisible());
  EXPECT_FALSE(strip.panels().front()->plot()->isVisible());
  field("unfoldButton");
  static_cast<QToolButton&>(field("unfoldButton")).click();
  QApplication::processEvents();
  EXPECT_FALSE(strip.isFolded());
  EXPECT_TRUE(strip.panels().front()->plot()->isVisible());
  static_cast<QToolButton&>(field("foldButton")).click();
  QApplication::processEvents();
  EXPECT_TRUE(strip.isFolded());
  window_.resize(1280, 800);
  QApplication::processEvents();
  EXPECT_TRUE(strip.isFolded()) << "as it was chosen";
  strip.goTo(strip.timeView()->begin());
  QApplication::processEvents();
  EXPECT_FALSE(strip.isFolded()) << "there is something to see";
  test::find<QAction>(window_, "actionOverview")->trigger();
  QApplication::processEvents();
  EXPECT_TRUE(strip.panels().front()->plot()->isVisible()) << "beside the overview always";
}

/// A test or a picture that asks for a name means one widget.
TEST_F(WaysOfTheWindow, NoTwoFieldsHaveOneName) {
  QHash<QString, int> names;
  for (const auto* page : window_.editor().pages()) {
    for (const auto* widget : page->findChildren<QWidget*>()) {
      const auto name = widget->objectName();
      if (!name.isEmpty() && !name.startsWith(QStringLiteral("qt_"))) ++names[name];
    }
  }
  EXPECT_GT(names.size(), 200);
  for (auto at = names.begin(); at != names.end(); ++at) EXPECT_EQ(at.value(), 1) << qPrintable(at.key());
}

TEST(LinkChooserWords, AreInTheUsersLanguage) {
  auto environment = test::virtualEnvironment();
  environment.list_adapters = [] {
    return Result<std::vector<NetworkAdapter>>(
        std::vector<NetworkAdapter>{{QStringLiteral("eth7"), QStringLiteral("igb"), true}});
  };
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    LinkChooser chooser(environment, {}, QStringLiteral("go"), nullptr);
    const auto* list = chooser.findChild<QListWidget*>();
    QString card;
    for (int row = 0; row < list->count(); ++row) {
      if (list->item(row)->text().startsWith(QStringLiteral("eth7"))) card = list->item(row)->text();
    }
    EXPECT_TRUE(card.contains(QStringLiteral("igb"))) << qPrintable(code);
    for (const char* english : {"Ethernet", "driver", "Network card"})
      EXPECT_FALSE(card.contains(QLatin1String(english))) << qPrintable(code) << ": " << qPrintable(card);
  }
}

}  // namespace
}  // namespace syncline::ui
