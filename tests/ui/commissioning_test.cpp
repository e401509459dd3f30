// SPDX-License-Identifier: Apache-2.0
// Whether a run is accepted, and the page to hand over, out of the window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

#include "support/running_window.h"
#include "ui/dialogs/commissioning_dialog.h"
#include "ui/text/acceptance_text.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

class Commissioning : public test::RunningWindow {
 protected:
  QAction& action() { return *window_.findChild<QAction*>(QStringLiteral("actionCommissioning")); }
  CommissioningDialog& dialog() {
    return *window_.findChild<CommissioningDialog*>(QStringLiteral("commissioningDialog"));
  }
  QTableWidget& criteria() { return field<QTableWidget>("commissioningCriteria"); }
  QString verdict() { return field<Pill>("commissioningVerdict").text(); }
  QString cell(reports::Criterion::Kind kind, int column) {
    return criteria().item(static_cast<int>(kind), column)->text();
  }
  static std::string read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }
};

TEST_F(Commissioning, JudgesTheRunThatIsShownAndWritesThePage) {
  EXPECT_FALSE(action().isEnabled()) << "nothing is shown";
  goOnline();
  run(3 * kSecond);
  ASSERT_TRUE(action().isEnabled());
  action().trigger();
  EXPECT_EQ(verdict(), QStringLiteral("Accepted"));
  EXPECT_EQ(criteria().rowCount(), 10);
  EXPECT_THAT(cell(reports::Criterion::Kind::kSlavesInSync, 3).toStdString(), HasSubstr("In sync for "));
  field<QDoubleSpinBox>("commissioningMinutes").setValue(5);
  EXPECT_EQ(verdict(), QStringLiteral("Not accepted"));
  EXPECT_EQ(cell(reports::Criterion::Kind::kWatchedFor, 0), QStringLiteral("NOT KEPT"));
  EXPECT_EQ(cell(reports::Criterion::Kind::kWatchedFor, 2), QStringLiteral("300.000\u00a0s"));
  field<QDoubleSpinBox>("commissioningMinutes").setValue(0);
  field<QLineEdit>("commissioningMachine").setText(QStringLiteral("Press <7>"));
  QTemporaryDir folder;
  dialog().write(folder.filePath(QStringLiteral("no/page.html")));
  EXPECT_TRUE(dialog().isVisible()) << "it could not be written";
  const auto path = folder.filePath(QStringLiteral("page.html"));
  dialog().write(path);
  const auto page = read(path);
  EXPECT_THAT(page, HasSubstr("Commissioning of Press &lt;7&gt;"));
  EXPECT_THAT(page, HasSubstr("accepted"));
  EXPECT_THAT(page, HasSubstr("configuration.eni.xml"));
  EXPECT_EQ(workspace_.messages().message(0).text, QStringLiteral("Accepted: ") + path);
}

/// The dialog follows the run: what goes wrong while it is open is in its verdict.
TEST_F(Commissioning, FollowsTheRun) {
  goOnline();
  run(2 * kSecond);
  action().trigger();
  EXPECT_EQ(verdict(), QStringLiteral("Accepted"));
  workspace_.live().requestState(AlState::kSafeop);
  run(2 * kSecond);
  ASSERT_TRUE(test::waitFor([&] { return verdict() != QStringLiteral("Accepted"); }));
  EXPECT_EQ(cell(reports::Criterion::Kind::kState, 3), QStringLiteral("SAFEOP"));
}

class Memory : public test::RunningWindow {};

/// The budget is remembered, holds at once, and the dialog says how much time it is.
TEST_F(Memory, IsChosenInMiBAndTellsItsTime) {
  goOnline();
  run(kSecond);
  auto& disk = workspace_.disk();
  EXPECT_EQ(disk.memoryMib(), 256);
  const auto usual = disk.memoryReach();
  auto& action = *window_.findChild<QAction*>(QStringLiteral("actionMemory"));
  action.trigger();
  auto& mib = field<QSpinBox>("memoryMib");
  const auto before = field<QLabel>("memoryReach").text();
  mib.setValue(512);
  EXPECT_NE(field<QLabel>("memoryReach").text(), before);
  EXPECT_EQ(disk.memoryMib(), 256) << "not before OK";
  field<QPushButton>("memoryAccept").click();
  EXPECT_EQ(disk.memoryMib(), 512);
  EXPECT_NEAR(static_cast<double>(disk.memoryReach()), 2 * static_cast<double>(usual), static_cast<double>(usual) / 10);
  EXPECT_EQ(workspace_.runs().memoryMib(), 512);
}

/// The window's words say what those of the page say.
TEST(AcceptanceText, AreTheWordsOfThePage) {
  using Kind = reports::Criterion::Kind;
  for (int i = 0; i <= static_cast<int>(Kind::kFindings); ++i) {
    const auto kind = static_cast<Kind>(i);
    EXPECT_EQ(criterionText(kind).toStdString(), reports::criterion_text(kind));
  }
  const std::vector<reports::Criterion> criteria{
      {.kind = Kind::kWatchedFor},
      {.kind = Kind::kState, .required = 8, .found = 0},
      {.kind = Kind::kMissedEvents},
      {.kind = Kind::kLostFrames, .verdict = reports::Verdict::kKept, .required = 7, .found = 3},
      {.kind = Kind::kFaults},
      {.kind = Kind::kFindings, .verdict = reports::Verdict::kKept, .found = 0}};
  for (const auto& criterion : criteria) {
    EXPECT_EQ(foundText(criterion).toStdString(), reports::found_text(criterion));
    EXPECT_EQ(requiredText(criterion).toStdString(), reports::required_text(criterion));
  }
  EXPECT_EQ(foundText({.kind = Kind::kSlavesInSync}), QStringLiteral("Not monitored"));
  reports::Criterion sync{
      .kind = Kind::kMasterInSync, .verdict = reports::Verdict::kNotKept, .required = 127, .found = 90};
  sync.state = SyncState::kInSync;
  sync.margin = -0.2;
  EXPECT_THAT(foundText(sync).toStdString(), HasSubstr("; largest that lasted 90 ns, over the limit"));
}

}  // namespace
}  // namespace syncline::ui
