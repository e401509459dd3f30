// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_document.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <vector>

#include "settings/settings_table.h"
#include "support/ui_test_support.h"

namespace syncline::ui {
namespace {

class Document : public ::testing::Test {
 protected:
  Document() { document_.replace(QStringLiteral("load"), test::smallProject()); }
  Status set(const char* key, const settings::Value& value, std::size_t slave = 0) {
    return document_.set(QStringLiteral("edit"), {{&settings::row(key), {.slave = slave}, value}});
  }
  ProjectDocument document_;
};

TEST_F(Document, EditsThroughSettingsKeysAndUndoes) {
  const Project before = document_.project();
  ASSERT_TRUE(set("master.cycle_time_us", 500 * kMicrosecond).has_value());
  EXPECT_EQ(document_.project().master.cycle_time, 500 * kMicrosecond);
  document_.undoStack().undo();
  EXPECT_EQ(document_.project(), before);
  document_.undoStack().redo();
  EXPECT_EQ(document_.project().master.cycle_time, 500 * kMicrosecond);
}

TEST_F(Document, RefusedEditChangesNothingAndMakesNoStep) {
  const Project before = document_.project();
  const int steps = document_.undoStack().count();
  const auto refused = set("master.cycle_time_us", Nanoseconds{1});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().subject, "master.cycle_time_us");
  EXPECT_FALSE(set("master.cycle_time_us", std::string("soon")).has_value());
  EXPECT_FALSE(set("master.cycle_time_us", settings::Unset{}).has_value()) << "it always has a value";
  EXPECT_EQ(set("slave.N.alias", std::int64_t{1}, 99).error().subject, "slave.99.alias");
  EXPECT_EQ(document_.project(), before);
  EXPECT_EQ(document_.undoStack().count(), steps);
}

/// Whoever looks at curves does not edit the machine; but what the file lacks is unsaved.
TEST_F(Document, ViewsAreUnsavedAndNoStep) {
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("m.syncline"));
  ASSERT_TRUE(document_.save(path));
  ASSERT_FALSE(document_.isModified());
  const int steps = document_.undoStack().count();
  int told = 0, edited = 0;
  QObject::connect(&document_, &ProjectDocument::modifiedChanged, &document_, [&](bool modified) {
    ++told;
    EXPECT_TRUE(modified);
  });
  QObject::connect(&document_, &ProjectDocument::projectChanged, &document_, [&] { ++edited; });
  const std::vector<MonitorView> views{{"Cabinet", {{}}}};
  document_.setViews(views);
  document_.setViews(views);
  EXPECT_TRUE(document_.isModified());
  EXPECT_EQ(told, 1);
  EXPECT_EQ(edited, 0) << "nothing is compiled again";
  EXPECT_EQ(document_.undoStack().count(), steps);
  document_.disconnect(&document_);
  ASSERT_TRUE(document_.save(path));
  EXPECT_FALSE(document_.isModified());
  ProjectDocument other;
  ASSERT_TRUE(other.load(path));
  EXPECT_EQ(other.views(), views);
  EXPECT_FALSE(other.isModified());
}

TEST_F(Document, ViewsStayWhateverIsUndone) {
  ASSERT_TRUE(set("master.cycle_time_us", 500 * kMicrosecond).has_value());
  const std::vector<MonitorView> views{{"Cabinet", {{}}}};
  document_.setViews(views);
  document_.replace(QStringLiteral("scan"), Project{});
  EXPECT_EQ(document_.views(), views) << "another machine, the same views";
  document_.undoStack().undo();
  document_.undoStack().undo();
  EXPECT_EQ(document_.views(), views);
  document_.undoStack().redo();
  EXPECT_EQ(document_.views(), views);
  document_.reset();
  EXPECT_TRUE(document_.views().empty());
}

/// Each network has its own.
TEST_F(Document, ViewsAreOfTheNetworkInWork) {
  const std::vector<MonitorView> views{{"Press", {{}}}};
  document_.setViews(views);
  document_.addNetwork(QStringLiteral("Second"));
  EXPECT_TRUE(document_.views().empty());
  document_.chooseNetwork(0);
  EXPECT_EQ(document_.views(), views);
}

TEST_F(Document, EditWithoutEffectMakesNoStep) {
  const int steps = document_.undoStack().count();
  ASSERT_TRUE(set("master.name", std::string("Master")).has_value());
  EXPECT_EQ(document_.undoStack().count(), steps);
}

}  // namespace
}  // namespace syncline::ui
