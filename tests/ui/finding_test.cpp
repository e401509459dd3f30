// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QSignalSpy>
#include <QTableView>
#include <QTranslator>
#include <set>
#include <string>

#include "support/ui_test_support.h"
#include "ui/models/finding_model.h"
#include "ui/panels/findings_panel.h"
#include "ui/text/finding_text.h"
#include "ui/text/translations.h"

namespace syncline::ui {
namespace {

using Code = FindingCode;

RunFinding finding(Code code, int slave, FindingLevel level = FindingLevel::kWarning) {
  RunFinding finding;
  finding.code = code;
  finding.slave = slave;
  finding.level = level;
  finding.figures = {{"slave", Figure::Unit::kSlave, slave, slave}, {"count", Figure::Unit::kCount, 3}};
  return finding;
}

TEST(FindingText, EverySentenceIsKnownToTheTranslations) {
  std::set<std::string> known;
  for (const char* text : translatableFindings()) known.insert(text);
  for (std::size_t code = 0; code < kFindingCodes; ++code) {
    const auto words = finding_words(static_cast<Code>(code));
    EXPECT_TRUE(known.contains(std::string(words.why))) << words.why;
    EXPECT_TRUE(words.mend.empty() || known.contains(std::string(words.mend))) << words.mend;
  }
}

TEST(FindingText, SpeaksGerman) {
  ASSERT_TRUE(installTranslation(QStringLiteral("de")));
  for (const char* text : translatableFindings()) {
    EXPECT_NE(QCoreApplication::translate("Finding", text), QString::fromUtf8(text)) << text;
  }
  auto silent = finding(Code::kMailboxSilent, 3);
  EXPECT_EQ(findingText(silent), QStringLiteral("Slave 3 ließ 3 Mailbox-Anfragen hintereinander ohne Antwort."));
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  QLocale::setDefault(QLocale::c());
}

TEST(FindingModel, KeepsRowsThatStay) {
  FindingModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setFindings({finding(Code::kFramesLost, -1), finding(Code::kMailboxSilent, 2)});
  const QPersistentModelIndex silent = model.index(1, FindingModel::kFinding);
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  auto louder = finding(Code::kMailboxSilent, 2);
  louder.figures[1].value = 9;
  model.setFindings({finding(Code::kSlaveFell, 1, FindingLevel::kError), louder});
  ASSERT_EQ(model.rowCount(), 2);
  ASSERT_TRUE(silent.isValid());
  EXPECT_EQ(silent.row(), 1);
  EXPECT_TRUE(silent.data().toString().contains(QStringLiteral("9")));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(reset.count(), 0);
  EXPECT_EQ(model.count(FindingLevel::kError), 1);
  EXPECT_EQ(model.index(0, 0).data(FindingModel::kSlaveRole).toInt(), 1);
  model.setFindings({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(FindingModel, MovesRowsIntoAnyOrder) {
  FindingModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const std::vector<RunFinding> all{finding(Code::kFramesLost, -1), finding(Code::kMailboxSilent, 2),
                                    finding(Code::kLinkLost, 1), finding(Code::kSlaveFell, 3)};
  model.setFindings(all);
  const std::vector<RunFinding> turned(all.rbegin(), all.rend());
  model.setFindings(turned);
  for (int row = 0; row < 4; ++row) {
    EXPECT_EQ(model.index(row, 0).data(FindingModel::kSlaveRole).toInt(), turned[static_cast<std::size_t>(row)].slave);
  }
}

TEST(FindingsPanel, SaysThatThereIsNothing) {
  FindingModel model;
  FindingsPanel panel(model);
  panel.show();
  EXPECT_TRUE(test::find<QLabel>(panel, "noFindings")->isVisible());
  model.setFindings({finding(Code::kMailboxSilent, 2)});
  auto* table = test::find<QTableView>(panel, "findingsTable");
  EXPECT_TRUE(table->isVisible());
  EXPECT_FALSE(test::find<QLabel>(panel, "noFindings")->isVisible());
  QSignalSpy activated(&panel, &FindingsPanel::placeActivated);
  Q_EMIT table->activated(model.index(0, 2));
  ASSERT_EQ(activated.count(), 1);
  EXPECT_EQ(activated[0][0].toInt(), 2);
}

}  // namespace
}  // namespace syncline::ui
