// SPDX-License-Identifier: Apache-2.0
// File > Export Tables and Code: the same files as the command line writes.
#include "ui/dialogs/export_menu.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QFileInfo>
#include <QMessageBox>
#include <QTemporaryDir>
#include <set>

#include "exports/formats.h"
#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "support/whole_file.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

class ExportsOfTheWindow : public test::ProjectWindow {
 protected:
  ExportsOfTheWindow() : ProjectWindow(test::smallProject()) {}
  ExportMenu& menu() { return *window_.findChild<ExportMenu*>(QStringLiteral("menuExport")); }
};

TEST_F(ExportsOfTheWindow, OfferEveryFormatWithAKeyOfItsOwn) {
  ASSERT_EQ(menu().actions().size(), static_cast<qsizetype>(exports::formats().size()));
  std::set<QChar> keys;
  for (const auto* action : menu().actions()) {
    const auto at = action->text().indexOf(u'&');
    ASSERT_GE(at, 0) << qPrintable(action->text()) << " has no title of the window's";
    EXPECT_TRUE(keys.insert(action->text()[at + 1].toLower()).second) << qPrintable(action->text());
  }
}

TEST_F(ExportsOfTheWindow, AreWhatTheCommandLineWrites) {
  const QTemporaryDir folder;
  for (const auto& format : exports::formats()) {
    const auto path = folder.filePath(QStringLiteral("machine") + QString::fromStdString(std::string(format.suffix)));
    ASSERT_TRUE(menu().write(format, path)) << format.name;
    const auto& compiled = workspace_.configuration().current();
    ASSERT_TRUE(compiled);
    const auto stem = QFileInfo(path).completeBaseName().toStdString();
    EXPECT_EQ(read_whole_file(path.toStdString()), format.text(compiled->config, stem)) << format.name;
  }
}

TEST_F(ExportsOfTheWindow, AreToldWhereTheyCannotBeWritten) {
  EXPECT_FALSE(menu().write(exports::formats().front(), QStringLiteral("/nowhere/at/all.h")));
  auto* box = window_.findChild<QMessageBox*>(QStringLiteral("errorDialog"));
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(box->informativeText().contains(QStringLiteral("/nowhere/at/all.h")));
  box->close();
}

TEST_F(ExportsOfTheWindow, AreOffWithoutSlaves) {
  EXPECT_TRUE(menu().menuAction()->isEnabled());
  workspace_.document().reset();
  EXPECT_FALSE(menu().menuAction()->isEnabled());
}

}  // namespace
}  // namespace syncline::ui
