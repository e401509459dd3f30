// SPDX-License-Identifier: Apache-2.0
// Settings that few machines need: hidden until they are asked for or differ from their default.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAction>
#include <QLabel>
#include <QTabWidget>
#include <QTranslator>

#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/editors/text_edit.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"
#include "ui/text/translations.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

class ExpertSettings : public test::ProjectWindow {
 protected:
  ExpertSettings() : ProjectWindow(test::smallProject()) {}

  QAction& action() { return *window_.findChild<QAction*>(QStringLiteral("actionExpert")); }
  void set(const char* key, const settings::Value& value) {
    ASSERT_TRUE(workspace_.document().set(QStringLiteral("set"), {{&settings::row(key), {.slave = 1}, value}}));
  }
};

TEST_F(ExpertSettings, AreShownWithTheSwitchOnly) {
  EXPECT_FALSE(action().isChecked());
  EXPECT_FALSE(has(-1, "masterDcExpertPage"));
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  EXPECT_FALSE(field("masterRealTimeCpu").isVisible());
  EXPECT_FALSE(has(1, "slaveTimingPage"));
  action().trigger();
  EXPECT_TRUE(workspace_.expert());
  EXPECT_TRUE(has(-1, "masterDcExpertPage"));
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  EXPECT_TRUE(field("masterRealTimeCpu").isVisible());
  EXPECT_TRUE(has(1, "slaveTimingPage"));
  action().trigger();
  EXPECT_FALSE(has(1, "slaveTimingPage"));
  EXPECT_FALSE(has(-1, "masterDcExpertPage"));
}

TEST_F(ExpertSettings, CarryAMark) {
  action().trigger();
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  auto* card = qobject_cast<Card*>(field("masterRealTimeCpu").parentWidget());
  ASSERT_NE(card, nullptr);
  EXPECT_TRUE(card->title().contains(QStringLiteral("(Expert)"))) << qPrintable(card->title());
  ASSERT_TRUE(has(1, "slaveGeneralPage"));
  auto& rule = field("slaveCheckRevisionRule");
  auto* caption = qobject_cast<QLabel*>(qobject_cast<Card*>(rule.parentWidget())->form()->labelForField(&rule));
  ASSERT_NE(caption, nullptr);
  EXPECT_TRUE(caption->text().endsWith(QChar(0x25C6))) << qPrintable(caption->text());
  EXPECT_EQ(rule.accessibleName(), QStringLiteral("Revision rule"));
}

TEST_F(ExpertSettings, StayWhenTheyDifferFromTheDefault) {
  set("slave.N.watchdog.divider", std::int64_t{1000});
  set("master.real_time.cpu", std::int64_t{2});
  ASSERT_TRUE(has(1, "slaveTimingPage"));
  EXPECT_TRUE(field("slaveWatchdogDivider").isVisible());
  EXPECT_FALSE(field("slaveWatchdogPdi").isVisible());
  EXPECT_FALSE(has(2, "slaveTimingPage")) << "another slave";
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  EXPECT_TRUE(field("masterRealTimeCpu").isVisible());
  EXPECT_FALSE(field("masterRealTimeSpinUs").isVisible());
  workspace_.document().undoStack().undo();
  EXPECT_FALSE(field("masterRealTimeCpu").isVisible());
}

TEST_F(ExpertSettings, AFieldStaysUnderTheCursorThatPassesItsDefault) {
  set("slave.N.watchdog.divider", std::int64_t{1000});
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  ASSERT_TRUE(has(1, "slaveTimingPage"));
  auto& divider = field<NumberEdit>("slaveWatchdogDivider");
  divider.setFocus();
  QTest::keyClick(&divider, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&divider, Qt::Key_Delete);
  QTest::keyClick(&divider, Qt::Key_Return);
  EXPECT_EQ(project().slaves[1].watchdog.divider, std::nullopt);
  EXPECT_TRUE(divider.isVisible());
}

/// Tab goes down one column and then the next, also to fields that were made later.
TEST_F(ExpertSettings, TabFollowsTheColumns) {
  action().trigger();
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  const auto after = [&](const char* name) {
    auto* next = field(name).nextInFocusChain();
    while (!(next->focusPolicy() & Qt::TabFocus) || !next->isVisible() ||
           qobject_cast<QAbstractSpinBox*>(next->parentWidget()) != nullptr) {
      next = next->nextInFocusChain();
    }
    return next->objectName();
  };
  EXPECT_EQ(after("networkName"), QStringLiteral("masterOverlap"));
  EXPECT_EQ(after("masterImageLogicalStart"), QStringLiteral("masterImageAlignment"));
  EXPECT_EQ(after("masterImageBitPacking"), QStringLiteral("masterRealTimeSpinUs"));
}

/// A machine whose pages show each of their cards.
Project wordyProject() {
  auto project = test::smallProject();
  auto& device = project.slaves[1].device;
  device.mailbox.emplace().coe.emplace();
  device.mailbox->eoe = device.mailbox->aoe = true;
  device.dc->op_modes.front().description = "words that wrap in a column of the page";
  project.master.sync_units = {{"Infeed", {}}};
  return project;
}

/// Nothing on the page is wider than the page, lower than it wants to be, or narrower than its words.
void expectNothingClipped(Page& page) {
  constexpr int kWrapped = 4;  // pixels that a label beside it may take that is wrapped
  const auto where = page.objectName().toStdString() + " at " + std::to_string(page.window()->width());
  EXPECT_LE(page.widget()->width(), page.viewport()->width()) << where;
  for (const auto& bound : page.fields().bound()) {
    const auto& widget = *bound.widget;
    if (!widget.isVisible() || bound.row == nullptr) continue;
    EXPECT_GE(widget.height(), widget.sizeHint().height() - kWrapped) << bound.setting->key << ' ' << where;
    EXPECT_GE(widget.width(), widget.minimumSizeHint().width()) << bound.setting->key << ' ' << where;
    auto* caption = qobject_cast<QLabel*>(bound.card->form()->labelForField(bound.row));
    if (caption == nullptr) continue;
    EXPECT_GE(caption->width(), caption->sizeHint().width()) << bound.setting->key << ' ' << where;
  }
}

/// Pages that are too narrow for their columns put them below each other instead of hiding some.
void lookAtEveryPage(Workspace& workspace, MainWindow& window) {
  workspace.document().replace(QStringLiteral("load"), wordyProject());
  window.show();
  for (const QSize size : {QSize(1280, 800), QSize(1024, 640)}) {
    window.resize(size);
    workspace.setExpert(false);
    QApplication::processEvents();
    workspace.setExpert(true);
    for (const int node : {-1, 2, 0, 1}) {  // rows come while their page is not shown
      window.selectNode(node);
      for (auto* page : window.editor().pages()) {
        if (!page->appliesTo(node)) continue;
        window.editor().tabs()->setCurrentWidget(page);
        for (int round = 0; round < 3; ++round) QApplication::processEvents();  // layouts ask for another one
        expectNothingClipped(*page);
      }
    }
  }
  workspace.document().undoStack().setClean();
}

TEST_F(ExpertSettings, NothingIsClipped) { lookAtEveryPage(workspace_, window_); }

TEST(GermanPages, NothingIsClipped) {
  ASSERT_TRUE(installTranslation(QStringLiteral("de")));
  {
    Workspace workspace(test::virtualEnvironment());
    MainWindow window(workspace);
    lookAtEveryPage(workspace, window);
  }
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  QLocale::setDefault(QLocale::c());
}

/// An unset number says so, and typing what stands for it is a decision.
TEST_F(ExpertSettings, WhatAutoStandsForCanBeSet) {
  action().trigger();
  ASSERT_TRUE(has(-1, "masterDcExpertPage"));
  auto& delay = field<NumberEdit>("masterDcDelayDifferenceNs");
  auto* line = delay.findChild<QLineEdit*>();
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->text(), QString());
  EXPECT_EQ(line->placeholderText(), QStringLiteral("auto: 40 ns"));
  EXPECT_EQ(delay.accessibleDescription(), QStringLiteral("auto: 40 ns"));
  EXPECT_EQ(field("masterDcLoopSpeedCounterStart").findChild<QLineEdit*>()->placeholderText(), QStringLiteral("auto"));
  test::type(delay, QStringLiteral("40"));
  EXPECT_EQ(project().master.dc.delay_difference, 40U);
  EXPECT_EQ(line->text(), QStringLiteral("40 ns"));
  test::type(delay, QStringLiteral("auto"));
  EXPECT_EQ(project().master.dc.delay_difference, std::nullopt);
}

TEST_F(ExpertSettings, AnAddressThatIsNoneStaysMarked) {
  action().trigger();
  ASSERT_TRUE(has(-1, "masterGeneralPage"));
  auto& address = field<TextEdit>("masterDestinationMac");
  EXPECT_EQ(address.text(), QStringLiteral("ff:ff:ff:ff:ff:ff"));
  test::type(address, QStringLiteral("01:02"));
  EXPECT_EQ(address.text(), QStringLiteral("01:02"));
  EXPECT_FALSE(address.accessibleDescription().isEmpty());
  QTest::keyClick(&address, Qt::Key_Escape);
  EXPECT_EQ(address.text(), QStringLiteral("ff:ff:ff:ff:ff:ff"));
}

}  // namespace
}  // namespace syncline::ui
