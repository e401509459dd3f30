// SPDX-License-Identifier: Apache-2.0
// The preview of the ENI: which lines each change of the project touches, search, jumps, findings, and what cannot be
// compiled.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <map>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "settings/settings_table.h"
#include "support/project_window.h"
#include "tests/support/sample_devices.h"
#include "ui/dialogs/file_commands.h"
#include "ui/models/eni_finding_model.h"
#include "ui/models/eni_model.h"
#include "ui/pages/eni_page.h"
#include "ui/pages/eni_text_view.h"
#include "ui/session/eni_preview.h"
#include "ui/session/exporter.h"
#include "ui/text/xml_spans.h"

namespace syncline::ui {
namespace {

std::string eniOf(const Project& project, EniDialect dialect = EniDialect::kEcEngineer) {
  const auto compiled = compile(project, {dialect});
  return compiled ? eni::write_eni(compiled->config, eni::style_of(dialect)) : std::string();
}

/// Lines that come and go in the shortest difference, by the table of all common parts.
std::size_t shortest(std::vector<std::string_view> left, std::vector<std::string_view> right) {
  while (!left.empty() && !right.empty() && left.back() == right.back()) left.pop_back(), right.pop_back();
  const auto most = std::min(left.size(), right.size());
  std::size_t front = 0;
  while (front < most && left[front] == right[front]) ++front;
  std::vector<std::size_t> above(right.size() - front + 1), row(above.size());
  for (std::size_t i = front; i < left.size(); ++i) {
    for (std::size_t j = front; j < right.size(); ++j) {
      const auto at = j - front + 1;
      row[at] = left[i] == right[j] ? above[at - 1] + 1 : std::max(above[at], row[at - 1]);
    }
    std::swap(above, row);
  }
  return left.size() + right.size() - 2 * (front + above.back());
}

class EniPageTest : public test::ProjectWindow {
 protected:
  EniPageTest() : EniPageTest(sample::small_machine()) {}
  explicit EniPageTest(const Project& machine) : ProjectWindow(machine) { window_.resize(1280, 800); }

  EniPreview& preview() { return workspace_.eni(); }
  EniModel& model() { return window_.findChild<EniPage*>()->model(); }
  EniTextView& text() { return *window_.findChild<EniTextView*>(); }
  void settle() {
    ASSERT_TRUE(test::waitFor([this] { return !preview().isComputing(); }));
  }
  void open(int node = -1) {
    show(node, "eniPage");
    ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent() && preview().check() != nullptr; }));
  }
  void choose(const char* box, int index) {
    auto& combo = field<QComboBox>(box);
    combo.setCurrentIndex(index);
    Q_EMIT combo.activated(index);
  }
  void set(const std::string& key, const std::string& value) {
    const auto ref = settings::find(project(), key, true);
    ASSERT_TRUE(ref) << key;
    const auto status = workspace_.document().edit(QStringLiteral("set"), [&](Project& target) {
      return settings::set_text(*ref->setting, target, ref->place, value);
    });
    ASSERT_TRUE(status) << key;
  }
  /// The rows of the page as two texts and the number of marked ones.
  struct Shown {
    std::string before, after;
    std::size_t marked = 0;
  };
  Shown shown() {
    Shown all;
    auto& lines = model();  // found among all widgets of the window: once is enough
    for (int row = 0; row < lines.rowCount(); ++row) {
      const auto kind = static_cast<EniRowKind>(lines.index(row, 0).data(EniModel::kKindRole).toInt());
      const auto line = lines.index(row, EniModel::kText).data().toString().toStdString() + '\n';
      const bool ghost = kind == EniRowKind::kBefore || kind == EniRowKind::kRemoved;
      if (!ghost) all.after += line;
      if (ghost || kind == EniRowKind::kSame) all.before += line;
      if (kind != EniRowKind::kSame) ++all.marked;
    }
    return all;
  }
  QString currentLine() { return text().currentIndex().siblingAtColumn(EniModel::kText).data().toString(); }
};

TEST_F(EniPageTest, ShowsWhatIsExportedInBothDialects) {
  open();
  EXPECT_EQ(shown().after, eniOf(project()));
  EXPECT_EQ(shown().marked, 0U);
  choose("eniDialect", 1);
  ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent(); }));
  EXPECT_EQ(shown().after, eniOf(project(), EniDialect::kTwinCat));
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("m.xml"));
  ASSERT_TRUE(window_.files().exportTo(path));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().toStdString(), shown().after) << "what is shown is what is exported";
  choose("eniDialect", 0);
}

TEST_F(EniPageTest, WritesAReportBesideTheEniWhereItIsWanted) {
  open();
  const QTemporaryDir folder;
  const auto eni = folder.filePath(QStringLiteral("m.eni.xml")),
             report = folder.filePath(QStringLiteral("m.report.html"));
  ASSERT_TRUE(window_.files().exportTo(eni));
  EXPECT_FALSE(QFile::exists(report));
  auto& box = field<QCheckBox>("eniReport");
  auto* action = window_.findChild<QAction*>(QStringLiteral("actionExportReport"));
  ASSERT_NE(action, nullptr);
  box.setChecked(true);
  EXPECT_TRUE(action->isChecked()) << "one choice in two places";
  set("slave.1.name", "<Press & Co>");
  ASSERT_TRUE(window_.files().exportTo(eni));
  QFile file(report);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const auto html = file.readAll();
  EXPECT_TRUE(html.contains("&lt;Press &amp; Co&gt;"));
  EXPECT_TRUE(html.contains("Syncline test"));
  EXPECT_TRUE(html.contains("m.eni.xml, " + QByteArray::number(QFileInfo(eni).size()) + " bytes"));
  action->setChecked(false);
  EXPECT_FALSE(box.isChecked());
  EXPECT_EQ(reportFile(QStringLiteral("a/m.xml")), QStringLiteral("a/m.report.html"));
}

TEST_F(EniPageTest, TellsWhatIsWrongInWhatWasExported) {
  open();
  const QTemporaryDir folder;
  const auto eni = folder.filePath(QStringLiteral("m.eni.xml"));
  const auto texts = [this] {
    QStringList out;
    const auto& model = workspace_.messages();
    for (int row = 0; row < model.rowCount(); ++row) out << model.index(row, MessageModel::kText).data().toString();
    return out.join(u'\n');
  };
  ASSERT_TRUE(window_.files().exportTo(eni));
  EXPECT_FALSE(texts().contains(QStringLiteral("0x1c12")));
  set("slave.3.startup.0", "PS 0x1C12:00=00");
  ASSERT_TRUE(window_.files().exportTo(eni)) << "it is written";
  EXPECT_TRUE(texts().contains(QStringLiteral("0x1c12"))) << qPrintable(texts());
}

TEST_F(EniPageTest, WritesNeitherEniNorReportWhereOneCannotBe) {
  open();
  field<QCheckBox>("eniReport").setChecked(true);
  const QTemporaryDir folder;
  ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("m.report.html")));  // a folder is in the way
  const auto eni = folder.filePath(QStringLiteral("m.eni.xml"));
  EXPECT_FALSE(exportEni(workspace_, eni));
  EXPECT_FALSE(QFile::exists(eni));
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 0);
  field<QCheckBox>("eniReport").setChecked(false);
}

/// What depends on settings of all kinds: the lines that another value makes different, and no others.
TEST_F(EniPageTest, ShowsWhatDependsOnASetting) {
  open();
  const char* const kKeys[] = {
      "master.dc.mode", "slave.3.dc.sync0.shift_us", "master.dc.sync_window", "master.cycle_time_us", "slave.1.name",
      "slave.2.alias",  "master.destination_mac",    "slave.3.pdo.rx"};
  const auto eni = eniOf(project());
  for (const char* key : kKeys) {
    window_.editor().showInEni(QString::fromLatin1(key));
    settle();
    const auto& view = *preview().view();
    ASSERT_TRUE(view.trial) << key;
    EXPECT_EQ(view.trial->key, key);
    ASSERT_FALSE(view.changes.empty()) << key;
    const auto page = shown();
    EXPECT_EQ(page.after, eni) << key << ": the ENI as it is";
    EXPECT_NE(page.before, eni) << key;
    EXPECT_EQ(page.marked, shortest(eni::lines_of(page.before), eni::lines_of(eni))) << key;
    EXPECT_EQ(text().currentIndex().row(), static_cast<int>(view.changes.front())) << key << ": at the first";
    EXPECT_TRUE(field<QLabel>("eniTrial").isVisible());
    EXPECT_TRUE(field<QLabel>("eniTrial").text().contains(QStringLiteral("Marked"))) << key;
  }
  EXPECT_EQ(eniOf(project()), eni) << "nothing was changed";
  EXPECT_TRUE(workspace_.document().undoStack().isClean());
}

/// The second key is asked for before the first one is answered: its answer is what is shown.
TEST_F(EniPageTest, OfTwoSettingsTheLastOneIsAnswered) {
  open();
  const std::string shift = "slave.3.dc.sync0.shift_us", name = "slave.1.name", window = "master.dc.sync_window";
  const auto marks = [&](const std::string& key) {
    window_.editor().showInEni(QString::fromStdString(key));
    settle();
    return shown().before;
  };
  const std::map<std::string, std::string> alone{{shift, marks(shift)}, {name, marks(name)}, {window, marks(window)}};
  EXPECT_NE(alone.at(shift), alone.at(name));
  for (const auto& [first, one] : alone) {
    for (const auto& [second, other] : alone) {
      if (first == second) continue;
      window_.editor().showInEni(QString::fromStdString(first));
      window_.editor().showInEni(QString::fromStdString(second));
      EXPECT_FALSE(preview().isCurrent()) << "nobody's answer yet";
      EXPECT_TRUE(field<QLabel>("eniTrial").text().contains(QStringLiteral("Looking")));
      settle();
      EXPECT_EQ(preview().view()->trial->key, second) << "after " << first;
      EXPECT_EQ(shown().before, other) << second << " after " << first;
      // Back to what was answered last but one.
      window_.editor().showInEni(QString::fromStdString(first));
      window_.editor().showInEni(QString::fromStdString(second));
      settle();
      EXPECT_EQ(shown().before, other) << second << " again";
    }
  }
}

TEST_F(EniPageTest, SaysThatASettingDoesNotChangeTheEni) {
  open();
  for (const char* key : {"master.dc.sync_window_settle_ms", "master.recovery.automatic", "master.dc.burst_total"}) {
    window_.editor().showInEni(QString::fromLatin1(key));
    settle();
    EXPECT_EQ(shown().marked, 0U) << key;
    EXPECT_TRUE(field<QLabel>("eniTrial").text().contains(QStringLiteral("does not change the ENI"))) << key;
  }
  set("slave.1.name", "Other");
  QTest::mouseClick(&field<QPushButton>("eniTrialEnd"), Qt::LeftButton);
  settle();
  EXPECT_FALSE(field<QLabel>("eniTrial").isVisible());
  EXPECT_FALSE(preview().view()->trial);
  EXPECT_GT(shown().marked, 0U) << "changes again";
}

/// From the field: by its menu, and by its key.
TEST_F(EniPageTest, IsAskedFromTheFieldItself) {
  const auto answered = [this](const char* key) {
    ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent(); }));
    EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("eniPage")) << key;
    ASSERT_TRUE(preview().view()->trial) << key;
    EXPECT_EQ(preview().view()->trial->key, key);
  };
  show(3, "slaveGeneralPage");
  auto& alias = field<QWidget>("slaveAlias");
  alias.setFocus();
  QTest::keyClick(&alias, Qt::Key_I, Qt::ControlModifier);
  answered("slave.3.alias");
  show(3, "slaveGeneralPage");
  auto& name = field<QLineEdit>("slaveName");
  QContextMenuEvent wanted(QContextMenuEvent::Mouse, QPoint(3, 3), name.mapToGlobal(QPoint(3, 3)));
  QApplication::sendEvent(&name, &wanted);
  auto* menu = name.findChild<QMenu*>(QStringLiteral("fieldMenu"));
  ASSERT_NE(menu, nullptr);
  EXPECT_GT(menu->actions().size(), 4) << "copy and paste are there, too";
  auto* entry = menu->findChild<QAction*>(QStringLiteral("fieldShowInEni"));
  ASSERT_NE(entry, nullptr);
  entry->trigger();
  menu->close();
  answered("slave.3.name");
  show(-1, "masterDcPage");
  EXPECT_TRUE(preview().dependentsOf().empty()) << "who leaves the page and comes back sees changes";
}

/// Each edit marks exactly the lines in which both exports differ.
TEST_F(EniPageTest, EachChangeMarksTheLinesThatItTouches) {
  const std::pair<const char*, const char*> kEdits[] = {{"master.name", "Press"},
                                                        {"master.cycle_time_us", "2000"},
                                                        {"master.destination_mac", "01:01:05:01:00:00"},
                                                        {"master.source_mac", "02:00:00:00:00:01"},
                                                        {"master.overlap_process_data", "off"},
                                                        {"master.dc.show_64bit_system_time", "on"},
                                                        {"master.dc.sync_window", "on"},
                                                        {"master.image.alignment", "4"},
                                                        {"master.image.bit_packing", "off"},
                                                        {"master.task.0", "Slow x4"},
                                                        {"slave.1.name", "Input 1"},
                                                        {"slave.1.station_address", "1100"},
                                                        {"slave.2.alias", "7"},
                                                        {"slave.3.check.revision", "on"},
                                                        {"slave.3.check.vendor", "off"},
                                                        {"slave.3.dc.sync0.shift_us", "50"},
                                                        {"slave.3.dc.sync0.factor", "2"},
                                                        {"slave.3.dc.potential_reference_clock", "on"},
                                                        {"slave.3.watchdog.divider", "1000"},
                                                        {"slave.3.watchdog.process_data", "500"},
                                                        {"slave.3.timeout.preop_ms", "4000"},
                                                        {"slave.3.mailbox.poll_time_ms", "50"},
                                                        {"slave.3.dc.op_mode", "off"},
                                                        {"master.dc.enabled", "off"}};
  open();
  choose("eniSince", static_cast<int>(EniPreview::Since::kLastEdit));
  int with_lines = 0;
  for (const auto& [key, value] : kEdits) {
    const auto before = eniOf(project());
    set(key, value);
    EXPECT_TRUE(preview().isComputing()) << "never stale without saying so";
    EXPECT_FALSE(field<QLabel>("eniChecked").text().isEmpty());
    settle();
    const auto after = eniOf(project());
    const auto page = shown();
    EXPECT_EQ(page.before, before) << key;
    EXPECT_EQ(page.after, after) << key;
    EXPECT_EQ(page.marked, shortest(eni::lines_of(before), eni::lines_of(after))) << key;
    const auto& view = *preview().view();
    EXPECT_EQ(page.marked, view.added + view.removed + 2 * view.altered) << key;
    with_lines += page.marked > 0 ? 1 : 0;
  }
  EXPECT_GE(with_lines, 20);
}

TEST_F(EniPageTest, OpensAtWhatChanged) {
  open();
  show(1, "slaveGeneralPage");
  set("slave.3.dc.sync0.shift_us", "50");
  set("slave.1.alias", "7");
  settle();
  open(3);
  const auto kind = [&] { return model().index(text().currentIndex().row(), EniModel::kChange).data().toString(); };
  EXPECT_FALSE(kind().isEmpty()) << "the slave's own lines";
  const auto of_slave = text().currentIndex().row();
  show(2, "slaveGeneralPage");
  open(1);
  EXPECT_FALSE(kind().isEmpty());
  EXPECT_LT(text().currentIndex().row(), of_slave);
  show(1, "slaveGeneralPage");
  open(2);
  EXPECT_TRUE(kind().isEmpty()) << "nothing of it was changed: where it begins";
  show(1, "slaveGeneralPage");
  open(-1);
  EXPECT_FALSE(kind().isEmpty()) << "the first of all";
}

TEST_F(EniPageTest, ANewLayoutLeavesItsLinesWhole) {
  open();
  const int width = text().columnWidth(EniModel::kText);
  ASSERT_GT(width, 300);
  field<QAction>("actionResetLayout").trigger();
  EXPECT_EQ(text().columnWidth(EniModel::kText), width);
}

TEST_F(EniPageTest, ComparesWithTheTimeThatIsChosen) {
  const QTemporaryDir folder;
  open();
  const auto opened = eniOf(project());
  choose("eniSince", static_cast<int>(EniPreview::Since::kSaved));
  settle();
  EXPECT_EQ(preview().view()->before, nullptr) << "not saved yet";
  choose("eniSince", static_cast<int>(EniPreview::Since::kExported));
  settle();
  EXPECT_EQ(preview().view()->before, nullptr) << "not exported yet";
  set("slave.1.name", "First");
  ASSERT_TRUE(window_.files().exportTo(folder.filePath(QStringLiteral("m.xml"))));
  const auto exported = eniOf(project());
  set("slave.1.name", "Second");
  ASSERT_TRUE(workspace_.document().save(folder.filePath(QStringLiteral("m.syncline"))));
  const auto saved = eniOf(project());
  set("slave.1.name", "Third");
  set("slave.2.name", "Fourth");
  const std::pair<EniPreview::Since, std::size_t> kExpected[] = {{EniPreview::Since::kExported, 2},
                                                                 {EniPreview::Since::kSaved, 2},
                                                                 {EniPreview::Since::kOpened, 2},
                                                                 {EniPreview::Since::kLastEdit, 1}};
  settle();
  const auto now = eni::lines_of(preview().view()->text->text).size();
  for (const auto& [since, slaves] : kExpected) {
    choose("eniSince", static_cast<int>(since));
    settle();
    ASSERT_NE(preview().view()->before, nullptr);
    EXPECT_GE(preview().view()->altered, slaves) << static_cast<int>(since);
    EXPECT_EQ(eni::lines_of(preview().view()->text->text).size(), now);
  }
  choose("eniSince", static_cast<int>(EniPreview::Since::kExported));
  settle();
  EXPECT_EQ(shown().before, exported);
  choose("eniSince", static_cast<int>(EniPreview::Since::kSaved));
  settle();
  EXPECT_EQ(shown().before, saved);
  choose("eniSince", static_cast<int>(EniPreview::Since::kOpened));
  settle();
  EXPECT_EQ(shown().before, opened);
  workspace_.document().reset();  // lets the file go while its folder is there
}

TEST_F(EniPageTest, IsFoundThroughAndCopiedWithTheKeyboard) {
  open();
  set("slave.3.name", "Winder");
  choose("eniSince", static_cast<int>(EniPreview::Since::kLastEdit));
  settle();
  text().setFocus();
  QTest::keyClick(&text(), Qt::Key_F, Qt::ControlModifier);
  auto& words = field<QLineEdit>("eniWords");
  ASSERT_TRUE(words.hasFocus());
  QTest::keyClicks(&words, QStringLiteral("<NAME>winder"));
  QTest::keyClick(&words, Qt::Key_Return);
  EXPECT_EQ(currentLine().trimmed(), QStringLiteral("<Name>Winder</Name>"));
  const int first = text().currentIndex().row();
  words.setText(QStringLiteral("<Slave>"));
  QTest::keyClick(&words, Qt::Key_F3);
  const int next = text().currentIndex().row();
  EXPECT_EQ(currentLine().trimmed(), QStringLiteral("<Slave>"));
  EXPECT_LT(next, first) << "around the end";
  QTest::keyClick(&words, Qt::Key_F3, Qt::ShiftModifier);
  EXPECT_GT(text().currentIndex().row(), next);
  words.setText(QStringLiteral("nothing of the kind"));
  QTest::keyClick(&words, Qt::Key_F3);
  EXPECT_TRUE(field<QLabel>("eniSummary").text().contains(QStringLiteral("nothing of the kind")));
  text().goToRow(0);
  QTest::keyClick(&words, Qt::Key_Down, Qt::AltModifier);
  const int change = text().currentIndex().row();
  EXPECT_EQ(change, static_cast<int>(preview().view()->changes.front()));
  QTest::keyClick(&words, Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(text().currentIndex().row(), static_cast<int>(preview().view()->changes.back()));
  text().selectRow(1);
  text().setFocus();
  QTest::keyClick(&text(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("<EtherCATConfig")));
}

TEST_F(EniPageTest, FollowsTheExplorer) {
  open(2);
  EXPECT_EQ(currentLine().trimmed(), QStringLiteral("<Slave>"));
  const auto at_two = model().lineAt(text().currentIndex().row());
  window_.selectNode(3);
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("eniPage")) << "the page stays";
  EXPECT_EQ(currentLine().trimmed(), QStringLiteral("<Slave>"));
  EXPECT_GT(model().lineAt(text().currentIndex().row()), at_two);
  choose("eniSection", 1);
  EXPECT_LT(model().lineAt(text().currentIndex().row()), at_two) << "slave 0";
}

TEST_F(EniPageTest, ShowsOnlyWhatIsAroundChanges) {
  open();
  set("slave.1.name", "Other");
  settle();
  const int all = model().rowCount();
  field<QCheckBox>("eniOnlyChanges").setChecked(true);
  EXPECT_LT(model().rowCount(), all / 4);
  int gaps = 0, marked = 0;
  for (int row = 0; row < model().rowCount(); ++row) {
    gaps += model().index(row, 0).data(EniModel::kGapRole).toBool() ? 1 : 0;
    marked += model().index(row, 0).data(EniModel::kKindRole).toInt() != 0 ? 1 : 0;
  }
  EXPECT_GE(gaps, 2);
  EXPECT_EQ(marked,
            static_cast<int>(preview().view()->added + preview().view()->removed + 2 * preview().view()->altered));
  field<QCheckBox>("eniOnlyChanges").setChecked(false);
  EXPECT_EQ(model().rowCount(), all);
}

TEST_F(EniPageTest, GoesToTheLineOfAFinding) {
  open();
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("twice"), [](Project& target) -> Status {
    target.slaves[2].station_address = target.slaves[1].station_address;
    return {};
  }));
  ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent() && preview().check() != nullptr; }));
  auto& table = field<QTableView>("eniFindings");
  ASSERT_GT(table.model()->rowCount(), 0);
  ASSERT_TRUE(table.isVisible());
  const auto index = table.model()->index(0, EniFindingModel::kFinding);
  Q_EMIT table.activated(index);
  EXPECT_EQ(static_cast<int>(model().lineAt(text().currentIndex().row())) + 1,
            index.data(EniFindingModel::kLineRole).toInt());
}

/// Nobody looks at the ENI: what the checker would say of it stands among the messages all the same.
TEST_F(EniPageTest, TellsOfFindingsWithoutBeingLookedAt) {
  const auto told = [this](const QString& key) {
    const auto& model = workspace_.messages();
    int count = 0;
    for (int row = 0; row < model.rowCount(); ++row) count += model.message(row).key == key ? 1 : 0;
    return count;
  };
  ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent() && preview().check() != nullptr; }));
  const auto before = workspace_.messages().count(Severity::kError);
  const auto key = QStringLiteral("slave.2.station_address");
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("twice"), [](Project& target) -> Status {
    target.slaves[2].station_address = target.slaves[1].station_address;
    return {};
  }));
  EXPECT_FALSE(preview().isCurrent()) << "never stale without saying so";
  ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent() && preview().check() != nullptr; }));
  EXPECT_EQ(told(key), 1) << "the compiler's and the checker's are one";
  EXPECT_GT(workspace_.messages().count(Severity::kError), before);
  workspace_.document().undoStack().undo();
  static_cast<void>(workspace_.configuration().current());
  EXPECT_EQ(told(key), 0);
  ASSERT_TRUE(test::waitFor([this] { return preview().isCurrent() && preview().check() != nullptr; }));
  EXPECT_EQ(workspace_.messages().count(Severity::kError), before);
}

TEST_F(EniPageTest, SaysWhatStandsAgainstIt) {
  open();
  const auto before = shown().after;
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("break"), [](Project& target) -> Status {
    target.master.cycle_time = 0;
    return {};
  }));
  settle();
  EXPECT_TRUE(preview().failure());
  auto& trouble = field<QLabel>("eniTrouble");
  EXPECT_TRUE(trouble.isVisible());
  EXPECT_FALSE(trouble.text().isEmpty());
  EXPECT_EQ(shown().after, before) << "the last good one";
  EXPECT_TRUE(text().isOutdated()) << "marked as old";
  workspace_.document().undoStack().undo();
  settle();
  EXPECT_FALSE(trouble.isVisible());
  EXPECT_FALSE(text().isOutdated());
}

TEST_F(EniPageTest, ModelsKeepTheirPromises) {
  using Tester = QAbstractItemModelTester;
  EniModel lines;
  EniFindingModel findings;
  const Tester first(&lines, Tester::FailureReportingMode::Fatal),
      second(&findings, Tester::FailureReportingMode::Fatal);
  auto other = project();
  other.slaves[1].name = "Other";
  const auto now = EniLines::of(eniOf(project()));
  lines.setView(EniView::of(now, nullptr));
  lines.setView(EniView::of(now, EniLines::of(eniOf(other))));
  lines.setOnlyChanges(true);
  EXPECT_GT(lines.rowCount(), 0);
  EXPECT_GE(lines.changeFrom(-1, true), 0);
  lines.setView(nullptr);
  EXPECT_EQ(lines.rowCount(), 0);
  EXPECT_EQ(lines.find(QStringLiteral("a"), 0, true), -1);
  const auto check = eni::check_eni_text("<EtherCATConfig><Config/></EtherCATConfig>", "x");
  ASSERT_TRUE(check);
  findings.setFindings(check->findings);
  EXPECT_GT(findings.rowCount(), 0);
  findings.setFindings({});
}

TEST(EniView, FindsRowsOfLines) {
  const auto view = EniView::of(EniLines::of("a\nc\nd\ne\n"), EniLines::of("a\nb\nx\nd\n"));
  for (std::size_t line = 0; line < 4; ++line) {
    const auto row = view->row_of(line);
    EXPECT_FALSE(view->rows[row].ghost());
    EXPECT_EQ(view->rows[row].line, line);
    EXPECT_EQ(view->line_at(row), line);
  }
}

TEST(XmlSpans, TellPiecesOfALine) {
  const auto pieces = [](const QString& line) {
    QString all;
    for (const auto& span : xmlSpans(line))
      all += QStringLiteral("PEAVTC")[static_cast<int>(span.piece)] + line.sliced(span.start, span.length) + u'|';
    return all;
  };
  EXPECT_EQ(pieces(QStringLiteral("  <Name>Slave 1</Name>")), QStringLiteral("P<|EName|P>|TSlave 1|P</|EName|P>|"));
  EXPECT_EQ(pieces(QStringLiteral("<a b=\"c>d\"/>")), QStringLiteral("P<|Ea|Ab|P=|V\"c>d\"|P/|P>|"));
  EXPECT_EQ(pieces(QStringLiteral("<!-- <x> -->y")), QStringLiteral("C<!-- <x> -->|Ty|"));
  EXPECT_EQ(pieces(QStringLiteral("<")), QStringLiteral("P<|"));
  EXPECT_EQ(pieces(QStringLiteral("<a b='")), QStringLiteral("P<|Ea|Ab|P=|V'|"));
  EXPECT_EQ(pieces(QString()), QString());
}

}  // namespace
}  // namespace syncline::ui
