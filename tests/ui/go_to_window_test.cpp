// SPDX-License-Identifier: Apache-2.0
// Whoever types a few letters gets to slaves, settings and commands of the machine.
#include <gtest/gtest.h>

#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <algorithm>

#include "settings/settings_table.h"
#include "support/building_window.h"

namespace syncline::ui {
namespace {

using test::Building;
using test::find;

TEST_F(Building, GoToOffersWhatTheDeviceHas) {
  const auto& slave = project().slaves[1];
  const auto setting = std::ranges::find_if(
      settings::table(), [&](const auto& one) { return one.applies && !one.items && !one.applies(slave); });
  ASSERT_NE(setting, settings::table().end());
  const auto key = QString::fromStdString(settings::key_of(*setting, {.slave = 1}));
  window_.selectNode(1);
  QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
  QTest::keyClicks(&field<QLineEdit>("goToSearch"), key);
  EXPECT_TRUE(field<QListWidget>("goToList").findItems(QStringLiteral(" ") + key, Qt::MatchEndsWith).isEmpty())
      << key.toStdString();
  QTest::keyClick(&field<QLineEdit>("goToSearch"), Qt::Key_Escape);
  const bool shown = window_.editor().showKey(key);
  EXPECT_EQ(workspace_.expert(), shown && setting->words.expert);
}

TEST_F(Building, GoesToSlavesSettingsAndCommandsByAFewLetters) {
  const auto go = [this](const char* words) {
    QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
    auto* dialog = window_.findChild<QDialog*>(QStringLiteral("goToDialog"));
    ASSERT_NE(dialog, nullptr);
    auto* field = find<QLineEdit>(*dialog, "goToSearch");
    QTest::keyClicks(field, QLatin1String(words));
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  go("drive 1005");
  EXPECT_EQ(selected(), 4);
  go("slave.4.alias");
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveGeneralPage"));
  go("flat");
  EXPECT_EQ(window_.explorer().view(), ExplorerPanel::View::kFlat);
}

}  // namespace
}  // namespace syncline::ui
