// SPDX-License-Identifier: Apache-2.0
// Start-up messages and register commands in the window: added, edited, moved and removed, one undo step each, and in
// the ENI.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QTableView>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "support/editable_project.h"
#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/text_edit.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

class OwnCommandsPage : public test::ProjectWindow {
 protected:
  OwnCommandsPage() : ProjectWindow(machine()) { workspace_.setExpert(true); }

  /// One message of AoE as the ESI has it, and none of FoE.
  static Project machine() {
    auto project = test::editableProject();
    auto& drive = project.slaves[1];
    drive.device.mailbox->aoe_options.init_commands = {{{Transition::kPS}, 0, {1, 0, 0, 0}, {}}};
    drive.foe_startup.clear();
    drive.register_commands.clear();
    project.master.register_commands.clear();
    return project;
  }
  void press(const char* button) { QTest::mouseClick(&field(button), Qt::LeftButton); }
  QString cell(const char* table, int row, const QString& title) {
    const auto* model = field<QTableView>(table).model();
    for (int column = 0; column < model->columnCount(); ++column) {
      if (model->headerData(column, Qt::Horizontal).toString() == title)
        return model->index(row, column).data().toString();
    }
    return QStringLiteral("no such column");
  }
  std::string eni() { return eni::write_eni(compile(project()).value().config); }
};

TEST_F(OwnCommandsPage, AMessageComesIsEditedMovedAndGoesAgain) {
  show(1, "slaveStartupPage");
  const auto before = project();
  auto& steps = workspace_.document().undoStack();
  const int base = steps.index();
  EXPECT_EQ(cell("aoeMessageTable", 0, QStringLiteral("Origin")), QStringLiteral("ESI"));
  press("aoeMessageAdd");
  ASSERT_EQ(project().slaves[1].aoe_startup.size(), 2U);
  EXPECT_FALSE(project().slaves[1].aoe_startup[1].enabled) << "nothing is sent before the user says what";
  EXPECT_EQ(cell("aoeMessageTable", 1, QStringLiteral("Origin")), QStringLiteral("own"));
  test::type(field("aoeMessageData"), QStringLiteral("aa bb cc"));
  test::type(field("aoeMessageComment"), QStringLiteral("set up"));
  field<QCheckBox>("aoeMessageEnabled").click();
  const auto& own = project().slaves[1].aoe_startup[1];
  EXPECT_EQ(own.data, (std::vector<std::uint8_t>{0xAA, 0xBB, 0xCC}));
  EXPECT_TRUE(own.enabled);
  press("aoeMessageUp");
  EXPECT_EQ(project().slaves[1].aoe_startup[0].comment, "set up");
  press("aoeMessageRemove");
  EXPECT_EQ(project(), before);
  EXPECT_EQ(steps.index(), base + 6) << "one step each";
  while (steps.index() > base) steps.undo();
  EXPECT_EQ(project(), before);
}

TEST_F(OwnCommandsPage, WhatIsNoMessageIsRefusedAndStays) {
  show(1, "slaveStartupPage");
  test::type(field("aoeMessageData"), QStringLiteral("abc"));
  EXPECT_FALSE(field("aoeMessageData").accessibleDescription().isEmpty());
  EXPECT_EQ(project(), machine());
}

/// A list that most devices leave empty takes one line.
TEST_F(OwnCommandsPage, AnEmptyListIsFolded) {
  show(1, "slaveStartupPage");
  EXPECT_FALSE(field("foeMessageTable").isVisible());
  EXPECT_TRUE(field("foeMessageAdd").isVisible());
  press("foeMessageAdd");
  EXPECT_TRUE(field("foeMessageTable").isVisible());
  EXPECT_TRUE(field("foeMessageData").isVisible());
}

TEST_F(OwnCommandsPage, ARegisterCommandIsWrittenReadAndJudged) {
  show(1, "initCommandsPage");
  press("registerAdd");
  test::type(field("registerAddress"), QStringLiteral("0x09A8"));
  test::type(field("registerData"), QStringLiteral("01 01"));
  test::type(field("registerComment"), QStringLiteral("both latches once"));
  field<QCheckBox>("registerEnabled").click();
  ASSERT_EQ(project().slaves[1].register_commands.size(), 1U);
  EXPECT_NE(eni().find("both latches once"), std::string::npos);
  test::type(field("registerExpected"), QStringLiteral("0101"));
  EXPECT_FALSE(field("registerExpected").accessibleDescription().isEmpty()) << "a write expects nothing";
  auto& direction = field<ChoiceEdit>("registerDirection");
  direction.setFocus();
  QTest::keyClick(&direction, Qt::Key_End);
  test::type(field("registerExpected"), QStringLiteral("0102"));
  const auto& command = project().slaves[1].register_commands[0];
  EXPECT_TRUE(command.read);
  EXPECT_EQ(command.expected, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(command.data, (std::vector<std::uint8_t>{0, 0})) << "as long as it was";
  EXPECT_TRUE(project().master.register_commands.empty());
}

TEST_F(OwnCommandsPage, TheMastersOwnGoToAllSlaves) {
  show(-1, "initCommandsPage");
  EXPECT_FALSE(field("registerAdd").isVisible());
  press("masterRegisterAdd");
  test::type(field("masterRegisterComment"), QStringLiteral("to all"));
  field<QCheckBox>("masterRegisterEnabled").click();
  field<QCheckBox>("masterRegisterAfter").click();
  ASSERT_EQ(project().master.register_commands.size(), 1U);
  EXPECT_TRUE(project().master.register_commands[0].after_slaves);
  EXPECT_NE(eni().find("to all"), std::string::npos);
  workspace_.document().undoStack().undo();
  EXPECT_FALSE(project().master.register_commands[0].after_slaves);
}

}  // namespace
}  // namespace syncline::ui
