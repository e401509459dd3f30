// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_document.h"

#include <gtest/gtest.h>

#include "support/ui_test_support.h"
#include "ui/session/setting_keys.h"

namespace syncline::ui {
namespace {

class Document : public ::testing::Test {
 protected:
  Document() { document_.replace(QStringLiteral("load"), test::smallProject()); }
  ProjectDocument document_;
};

TEST_F(Document, EditsThroughSettingsKeysAndUndoes) {
  const Project before = document_.project();
  ASSERT_TRUE(document_.set(QStringLiteral("cycle"), keys::master(keys::kCycleTime), QStringLiteral("500")).has_value());
  EXPECT_EQ(document_.project().master.cycle_time, 500 * kMicrosecond);
  document_.undoStack().undo();
  EXPECT_EQ(document_.project(), before);
  document_.undoStack().redo();
  EXPECT_EQ(document_.project().master.cycle_time, 500 * kMicrosecond);
}

TEST_F(Document, RefusedEditChangesNothingAndMakesNoStep) {
  const Project before = document_.project();
  const int steps = document_.undoStack().count();
  EXPECT_FALSE(document_.set(QStringLiteral("cycle"), keys::master(keys::kCycleTime), QStringLiteral("soon")).has_value());
  EXPECT_FALSE(document_.set(QStringLiteral("none"), QStringLiteral("master.no_such_key"), QStringLiteral("1")).has_value());
  EXPECT_EQ(document_.project(), before);
  EXPECT_EQ(document_.undoStack().count(), steps);
}

TEST_F(Document, EditWithoutEffectMakesNoStep) {
  const int steps = document_.undoStack().count();
  ASSERT_TRUE(document_.set(QStringLiteral("name"), keys::master(keys::kMasterName), QStringLiteral("Master")).has_value());
  EXPECT_EQ(document_.undoStack().count(), steps);
}

/// Every key that a page edits is a key that the command line knows, in both directions.
TEST_F(Document, EveryKeyOfThePagesIsASetting) {
  const auto& project = document_.project();
  for (const char* key : {keys::kMasterName, keys::kCycleTime, keys::kDcEnabled, keys::kReferenceClock, keys::kDcmMode,
                          keys::kSetValue, keys::kDcmLimit, keys::kDcmSettle, keys::k64Bit,
                          keys::kSyncWindow, keys::kSyncWindowExponent, keys::kSyncWindowSettle}) {
    const auto value = get_setting(project, keys::master(key).toStdString());
    ASSERT_TRUE(value.has_value()) << key;
    EXPECT_TRUE(document_.set(QStringLiteral("same"), keys::master(key), QString::fromStdString(*value)).has_value()) << key;
  }
  for (const char* key : {keys::kName, keys::kStationAddress, keys::kAlias, keys::kCheckVendor, keys::kCheckProduct,
                          keys::kCheckRevision, keys::kCheckSerial, keys::kOpMode, keys::kPotentialReference,
                          keys::kRxPdos, keys::kTxPdos}) {
    const auto value = get_setting(project, keys::slave(1, key).toStdString());
    ASSERT_TRUE(value.has_value()) << key;
    EXPECT_TRUE(document_.set(QStringLiteral("same"), keys::slave(1, key), QString::fromStdString(*value)).has_value()) << key;
  }
  for (const int unit : {0, 1}) {
    for (const char* key : {keys::kFactor, keys::kUserCycle, keys::kShift}) {
      const auto name = keys::sync(1, unit, key);
      EXPECT_TRUE(get_setting(project, name.toStdString()).has_value()) << qPrintable(name);
      EXPECT_TRUE(document_.set(QStringLiteral("unset"), name, keys::unset()).has_value()) << qPrintable(name);
    }
  }
}

}  // namespace
}  // namespace syncline::ui
