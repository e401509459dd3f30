// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTranslator>
#include <set>
#include <string>

#include "channels/event.h"
#include "channels/event_finding.h"
#include "findings/event_words.h"
#include "findings/project_words.h"
#include "findings/run_codes.h"
#include "findings/scan_words.h"
#include "findings/sentence.h"
#include "support/ui_test_support.h"
#include "ui/models/finding_model.h"
#include "ui/panels/findings_panel.h"
#include "ui/text/finding_text.h"
#include "ui/text/translations.h"

namespace syncline::ui {
namespace {

Finding finding(std::string_view code, int slave, Severity level = Severity::kWarning) {
  Finding finding;
  finding.code = code;
  finding.place.slave = slave;
  finding.severity = level;
  finding.figures = {{"slave", Figure::Unit::kSlave, slave, slave}, {"count", Figure::Unit::kCount, 3}};
  return finding;
}

/// Placeholders of a sentence, sorted; those that choose words by their count, too.
std::vector<std::string> placeholders(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("\\{(\\w+)(?::[^}]*)?\\}"));
  std::set<std::string> names;
  for (auto it = pattern.globalMatch(text); it.hasNext();) names.insert(it.next().captured(1).toStdString());
  return {names.begin(), names.end()};
}

/// What is the same in both languages: names of ETG, and sentences of nothing but figures.
bool isTheSameInAll(std::string_view text) {
  constexpr std::string_view kSame[] = {"{error}",
                                        ": {reason}",
                                        "{code} ({meaning})",
                                        "{place}: {reason}",
                                        "{sentence} {next}",
                                        "{sentence}.",
                                        "{reason}",
                                        "{reason}.",
                                        "{text}",
                                        "{subject}: {from} -> {to}",
                                        "{slave} ({identity}): {match} ({file}).",
                                        "Alias",
                                        "EtherType",
                                        "Ethernet over EtherCAT",
                                        "Mailbox",
                                        "Revision",
                                        "SM{sm}",
                                        "SM{sm} PDOs",
                                        "PDO {pdo}",
                                        "{command}",
                                        "{setting}",
                                        "<{element}> in <{parent}>",
                                        "in <{element}>",
                                        "FMMUs (0x0600)",
                                        "slave.{position}.{key}: {reason}",
                                        "{attribute}=\"{text}\" {reason}",
                                        "{reason} (<{element}>)",
                                        "Text"};
  return std::ranges::find(kSame, text) != std::end(kSame);
}

TEST(FindingText, ANumberThatNamesSomethingIsWrittenAsItIs) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::English));
  const auto address = make_finding<words::kProject>("station-address-twice", 1, fig::number<"address">(1009),
                                                     fig::text<"name">("Drive"));
  EXPECT_EQ(findingText(address), QStringLiteral("Station address 1009 is that of Drive too."));
  const auto alias = make_finding<words::kScan>("scan-alias-not-taken", 1, fig::slave<"slave">(1),
                                                fig::number<"written">(1001), fig::number<"taken">(65535));
  EXPECT_EQ(findingText(alias),
            QStringLiteral("The EEPROM of slave 1 has the alias 1001, its ESC has 65535 until the next power-on."));
  QLocale::setDefault(before);
}

TEST(FindingText, ACountIsGroupedAndABalanceHasItsSign) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::English));
  const auto lost = make_finding<words::kEvents>("event-frames-lost", {}, fig::count<"count">(1009));
  EXPECT_TRUE(findingText(lost).startsWith(QStringLiteral("1,009 "))) << qPrintable(findingText(lost));
  events::DcmError error;
  error.drift_ppm = -1200;
  const auto drift = findingText(event_finding({.what = error}).value());
  EXPECT_TRUE(drift.contains(QStringLiteral("-1,200 ppm"))) << qPrintable(drift);
  QLocale::setDefault(before);
}

TEST(FindingText, EverySentenceIsGermanToo) {
  ASSERT_TRUE(installTranslation(QStringLiteral("de")));
  std::string missing;
  for (const auto text : translatableFindings()) {
    const auto source = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    const auto german = QCoreApplication::translate("Finding", source.toUtf8().constData());
    EXPECT_EQ(placeholders(german), placeholders(source)) << text;
    if (german == source && !isTheSameInAll(text)) missing += std::string(text) + "\n";
  }
  EXPECT_EQ(missing, "") << "these belong into translations/words/words_de.ts";
  auto silent = finding(code::kMailboxSilent, 3);
  EXPECT_EQ(findingText(silent), QStringLiteral("Slave 3 ließ 3 Mailbox-Anfragen hintereinander ohne Antwort."));
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  QLocale::setDefault(QLocale::c());
}

TEST(FindingModel, KeepsRowsThatStay) {
  FindingModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setFindings({finding(code::kFramesLost, -1), finding(code::kMailboxSilent, 2)});
  const QPersistentModelIndex silent = model.index(1, FindingModel::kFinding);
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  auto louder = finding(code::kMailboxSilent, 2);
  louder.figures[1].value = 9;
  model.setFindings({finding(code::kSlaveFell, 1, Severity::kError), louder});
  ASSERT_EQ(model.rowCount(), 2);
  ASSERT_TRUE(silent.isValid());
  EXPECT_EQ(silent.row(), 1);
  EXPECT_TRUE(silent.data().toString().contains(QStringLiteral("9")));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(reset.count(), 0);
  EXPECT_EQ(model.count(Severity::kError), 1);
  EXPECT_EQ(model.index(0, 0).data(FindingModel::kSlaveRole).toInt(), 1);
  model.setFindings({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(FindingModel, MovesRowsIntoAnyOrder) {
  FindingModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const std::vector<Finding> all{finding(code::kFramesLost, -1), finding(code::kMailboxSilent, 2),
                                 finding(code::kLinkLost, 1), finding(code::kSlaveFell, 3)};
  model.setFindings(all);
  const std::vector<Finding> turned(all.rbegin(), all.rend());
  model.setFindings(turned);
  for (int row = 0; row < 4; ++row) {
    EXPECT_EQ(model.index(row, 0).data(FindingModel::kSlaveRole).toInt(),
              turned[static_cast<std::size_t>(row)].place.slave);
  }
}

TEST(FindingsPanel, SaysThatThereIsNothing) {
  FindingModel model;
  FindingsPanel panel(model);
  panel.show();
  EXPECT_TRUE(test::find<QLabel>(panel, "noFindings")->isVisible());
  model.setFindings({finding(code::kMailboxSilent, 2)});
  auto* table = test::find<QTableView>(panel, "findingsTable");
  EXPECT_TRUE(table->isVisible());
  EXPECT_FALSE(test::find<QLabel>(panel, "noFindings")->isVisible());
  QSignalSpy activated(&panel, &FindingsPanel::findingActivated);
  Q_EMIT table->activated(model.index(0, 2));
  ASSERT_EQ(activated.count(), 1);
  EXPECT_EQ(activated[0][0].value<Finding>().place.slave, 2);
}

}  // namespace
}  // namespace syncline::ui
