// SPDX-License-Identifier: Apache-2.0
// The window in each of its languages.
#include <gtest/gtest.h>

#include <QAction>
#include <QDialogButtonBox>
#include <QFile>
#include <QKeySequence>
#include <QLibraryInfo>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoGroup>
#include <QUndoStack>
#include <map>
#include <memory>

#include "support/result.h"
#include "support/speak.h"
#include "support/ui_test_support.h"
#include "ui/actions.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/language_menu.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/status_panel.h"
#include "ui/session/window_memory.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/menu_key.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

TEST(Languages, ReachTheClasses) {
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    EXPECT_NE(StatusPanel::tr("No link chosen"), QStringLiteral("No link chosen")) << qPrintable(code);
    EXPECT_NE(errorText(Error{ErrorCode::kCancelled}), QStringLiteral("Cancelled.")) << qPrintable(code);
    EXPECT_TRUE(bitsText(8).startsWith(u'1')) << qPrintable(code);
    EXPECT_FALSE(bitsText(16).contains(QStringLiteral("(s)"))) << qPrintable(code);
  }
}

TEST(Languages, ChineseIsFoundUnderItsShortName) {
  for (const char* code : {"zh", "zh_CN", "zh-Hans"}) {
    const test::Speak speak(QString::fromLatin1(code));
    EXPECT_EQ(StatusPanel::tr("No link chosen"), QStringLiteral("未选择链路")) << code;
  }
}

TEST(Languages, ButtonsAndListsShowNoMenuKeys) {
  EXPECT_EQ(withoutMenuKey(QStringLiteral("&Scan…")), QStringLiteral("Scan…"));
  EXPECT_EQ(withoutMenuKey(QStringLiteral("扫描(&S)…")), QStringLiteral("扫描…"));
  QUndoGroup stack;
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    const Actions actions(stack, nullptr);
    EXPECT_FALSE(actions.scan->iconText().contains(u'(')) << qPrintable(code);
    EXPECT_FALSE(actions.scan->iconText().contains(u'&')) << qPrintable(code);
  }
}

TEST(Languages, ReachTheButtonsOfQt) {
  const QDir qt(QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  for (const auto& code : test::translatedLanguages()) {
    if (!QFile::exists(qt.filePath(QStringLiteral("qtbase_%1.qm").arg(code))))
      GTEST_SKIP() << "Qt's own translations are not installed";
    const test::Speak speak(code);
    const QDialogButtonBox box(QDialogButtonBox::Cancel);
    EXPECT_NE(box.button(QDialogButtonBox::Cancel)->text().remove(u'&'), QStringLiteral("Cancel")) << qPrintable(code);
  }
}

/// A key that two lines of a menu share opens neither.
void expectOneEach(const QList<QAction*>& actions, const QString& where) {
  std::map<QString, QString> used;
  for (const auto* action : actions) {
    if (const auto* menu = action->menu()) expectOneEach(menu->actions(), where + u'/' + action->text());
    const auto key = QKeySequence::mnemonic(action->text()).toString();
    if (key.isEmpty() || action->isSeparator()) continue;
    EXPECT_FALSE(used.contains(key)) << qPrintable(where) << ": " << qPrintable(action->text()) << " and "
                                     << qPrintable(used[key]);
    used[key] = action->text();
  }
}

TEST(Languages, GiveEachLineOfAMenuAKeyOfItsOwn) {
  for (const auto& language : languages()) {
    const test::Speak speak(language.code);
    Workspace workspace(test::virtualEnvironment());
    const MainWindow window(workspace);
    expectOneEach(window.menuBar()->actions(), language.code);
  }
}

TEST(LanguageMenu, RemembersWhatWasChosen) {
  QTemporaryDir folder;
  const auto file = folder.filePath(QStringLiteral("settings.ini"));
  {
    WindowMemory memory(file);
    bool typing = true;
    LanguageMenu menu(memory, [&typing] { return !typing; });
    EXPECT_TRUE(menu.findChild<QAction*>(QStringLiteral("actionLanguage_"))->isChecked()) << "the desktop's";
    QSignalSpy chosen(&menu, &LanguageMenu::chosen);
    menu.findChild<QAction*>(QStringLiteral("actionLanguage_zh_CN"))->trigger();
    EXPECT_EQ(chosen.count(), 0) << "a field holds what cannot be a value";
    EXPECT_FALSE(memory.value(kLanguageSetting).isValid());
    EXPECT_TRUE(menu.findChild<QAction*>(QStringLiteral("actionLanguage_"))->isChecked()) << "as it was";
    typing = false;
    menu.findChild<QAction*>(QStringLiteral("actionLanguage_zh_CN"))->trigger();
    EXPECT_EQ(chosen.count(), 1);
    menu.findChild<QAction*>(QStringLiteral("actionLanguage_zh_CN"))->trigger();
    EXPECT_EQ(chosen.count(), 1) << "it is spoken already";
  }
  WindowMemory memory(file);
  EXPECT_EQ(memory.value(kLanguageSetting).toString(), QStringLiteral("zh_CN"));
  LanguageMenu menu(memory, [] { return true; });
  EXPECT_TRUE(menu.findChild<QAction*>(QStringLiteral("actionLanguage_zh_CN"))->isChecked());
}

/// As the program does it when another language is chosen: the run goes on, and is looked at as before.
TEST(Languages, AnotherWindowTakesUpWhatRuns) {
  Workspace workspace(test::virtualEnvironment());
  workspace.live().setAutoAdvance(false);
  auto window = std::make_unique<MainWindow>(workspace);
  window->show();
  window->bus().startDemo();
  ASSERT_TRUE(test::waitFor([&] { return workspace.live().phase() != LiveSession::Phase::kOffline; }));
  const auto run = [&] {
    for (int i = 0; i < 50; ++i) workspace.live().advance(20 * kMillisecond);
    QApplication::processEvents();
  };
  for (int i = 0; i < 20 && workspace.live().snapshot().state != AlState::kOp; ++i) run();
  ASSERT_EQ(workspace.live().snapshot().state, AlState::kOp);
  window->selectNode(3);
  window->editor().showPage("slaveRegistersPage");
  const auto place = window->place();
  ASSERT_EQ(place.page, QStringLiteral("slaveRegistersPage"));
  QSignalSpy chosen(window.get(), &MainWindow::languageChosen);
  test::find<QAction>(*window, "actionLanguage_de")->trigger();
  ASSERT_EQ(chosen.count(), 1);
  const test::Speak speak(QStringLiteral("de"));
  auto another = std::make_unique<MainWindow>(workspace);
  another->show();
  window.reset();
  another->goToPlace(place);
  EXPECT_EQ(another->explorer().selected(), 3);
  EXPECT_EQ(another->place().page, place.page);
  EXPECT_FALSE(another->place().overview);
  EXPECT_EQ(test::find<QAction>(*another, "actionOffline")->text().remove(u'&'), QStringLiteral("Offline gehen"));
  ASSERT_NE(another->liveStrip().store(), nullptr) << "the plots of the run";
  const auto before = another->liveStrip().store()->series(Signal::kDeviation).size();
  run();
  another->liveStrip().refresh();
  EXPECT_GT(another->liveStrip().store()->series(Signal::kDeviation).size(), before) << "it goes on";
  EXPECT_TRUE(another->liveStrip().timeView()->goesOn());
  workspace.runs().shutDown();
  workspace.document().undoStack().setClean();
}

}  // namespace
}  // namespace syncline::ui
