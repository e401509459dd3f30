// SPDX-License-Identifier: Apache-2.0
// The way to anything by a few letters.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeView>

#include "support/project_window.h"
#include "ui/dialogs/go_to_search.h"
#include "ui/editors/page.h"

namespace syncline::ui {
namespace {

ObjectEntry entry(std::uint8_t sub, const char* name, const char* type, std::uint16_t bits) {
  ObjectEntry made;
  made.sub_index = sub;
  made.name = name;
  made.data_type = type;
  made.bit_length = bits;
  return made;
}

/// Drives that have objects, and a coupler that has none.
Project machineWithObjects(std::size_t drives = 2) {
  auto project = test::smallProject();
  auto& drive = project.slaves[1];
  drive.device.mailbox.emplace().coe.emplace();
  ObjectDescription control{0x6040, "Controlword", {}};
  control.entries = {entry(0, "Controlword", "UINT", 16)};
  ObjectDescription limits{0x607D, "Software position limit", {}, ObjectCode::kArray};
  limits.entries = {entry(0, "Entries", "USINT", 8), entry(1, "Minimum", "DINT", 32), entry(2, "Maximum", "DINT", 32)};
  drive.device.dictionary = {control, limits};
  const auto one = drive;
  project.slaves.resize(1);
  for (std::size_t i = 0; i < drives; ++i) {
    auto& slave = project.slaves.emplace_back(one);
    slave.station_address = static_cast<std::uint16_t>(1002 + i);
    slave.name = "Axis_" + std::to_string(i + 1);
    slave.previous = PreviousPort{static_cast<std::uint16_t>(i), 1};
  }
  return project;
}

class GoTo : public test::ProjectWindow {
 protected:
  GoTo() : ProjectWindow(machineWithObjects()) {}

  QStringList found(const QString& words) {
    window_.findChild<QAction*>(QStringLiteral("actionGoTo"))->trigger();
    auto& search = field<QLineEdit>("goToSearch");
    QTest::keyClicks(&search, words);
    QStringList rows;
    auto& list = field<QListWidget>("goToList");
    for (int row = 0; row < list.count(); ++row) rows << list.item(row)->text();
    return rows;
  }
  void go() {
    QTest::keyClick(&field<QLineEdit>("goToSearch"), Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
};

TEST_F(GoTo, FindsSettingsOfSlavesThatAreNotSelected) {
  window_.selectNode(-1);
  const auto rows = found(QStringLiteral("slave.2.alias"));
  ASSERT_EQ(rows.size(), 1) << qPrintable(rows.join(u'\n'));
  EXPECT_TRUE(rows.front().contains(QStringLiteral("Axis_2"))) << qPrintable(rows.front());
  go();
  EXPECT_TRUE(field("slaveAlias").hasFocus());
  EXPECT_EQ(static_cast<Page*>(window_.editor().tabs()->currentWidget())->node(), 2);
}

TEST_F(GoTo, FindsSettingsByLabelAndSlave) {
  const auto rows = found(QStringLiteral("alias axis_1"));
  ASSERT_FALSE(rows.isEmpty());
  EXPECT_TRUE(rows.front().contains(QStringLiteral("slave.1.alias"))) << qPrintable(rows.front());
}

TEST_F(GoTo, LeadsToObjectsByIndexAndByName) {
  for (const auto& [words, object, slave] : {std::tuple{"6040", "0x6040:00", 1},
                                             {"0x6040:00", "0x6040:00", 1},
                                             {"0x607d:02", "0x607D:02", 1},
                                             {"controlw axis_2", "0x6040:00", 2},
                                             {"position limit max", "0x607D:02", 1}}) {
    window_.selectNode(-1);
    const auto rows = found(QLatin1String(words));
    ASSERT_FALSE(rows.isEmpty()) << words;
    EXPECT_TRUE(rows.front().contains(QLatin1String(object))) << words << ": " << qPrintable(rows.front());
    go();
    const auto* page = static_cast<Page*>(window_.editor().tabs()->currentWidget());
    ASSERT_EQ(page->objectName(), QStringLiteral("slaveObjectsPage")) << words;
    EXPECT_EQ(page->node(), slave) << words;
    const auto current = field<QTreeView>("objectTree").currentIndex().siblingAtColumn(0).data().toString();
    EXPECT_TRUE(QLatin1String(object).contains(current.right(2))) << words << ": " << qPrintable(current);
  }
}

TEST_F(GoTo, SaysThatNothingFits) {
  const auto rows = found(QStringLiteral("no such thing"));
  ASSERT_EQ(rows.size(), 1);
  EXPECT_TRUE(rows.front().contains(QStringLiteral("Nothing fits"))) << qPrintable(rows.front());
  go();
  EXPECT_TRUE(field("goToDialog").isVisible()) << "there is nowhere to go";
}

TEST(GoToSearch, LooksThroughAThousandSlaves) {
  const auto project = machineWithObjects(1000);
  const GoToSearch search(project, -1);
  QElapsedTimer timer;
  timer.start();
  EXPECT_EQ(search.settings({QStringLiteral("slave.900.alias")}, 50).size(), 1U);
  EXPECT_EQ(search.settings({QStringLiteral("alias")}, 50).size(), 50U) << "bounded";
  EXPECT_TRUE(search.settings({QStringLiteral("nowhere")}, 50).empty());
  EXPECT_EQ(search.objects({QStringLiteral("6040"), QStringLiteral("axis_777")}, 50).size(), 1U);
  EXPECT_EQ(search.objects({QStringLiteral("6040")}, 50).size(), 50U);
  EXPECT_LT(timer.elapsed(), test::kPatienceMs / 4) << "of five searches";
}

}  // namespace
}  // namespace syncline::ui
