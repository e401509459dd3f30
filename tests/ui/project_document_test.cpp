// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_document.h"

#include <gtest/gtest.h>

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

TEST_F(Document, EditWithoutEffectMakesNoStep) {
  const int steps = document_.undoStack().count();
  ASSERT_TRUE(set("master.name", std::string("Master")).has_value());
  EXPECT_EQ(document_.undoStack().count(), steps);
}

}  // namespace
}  // namespace syncline::ui
