// SPDX-License-Identifier: Apache-2.0
// The log of the master synchronisation that a run in the window keeps.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "settings/settings_table.h"
#include "support/running_window.h"
#include "trace/dcm_log.h"
#include "ui/models/message_model.h"

namespace syncline::ui {
namespace {

class DcmLogRecording : public test::RunningWindow {
 protected:
  void setLog(bool on) {
    ASSERT_TRUE(workspace_.document().set(QStringLiteral("log"), {{&settings::row("master.dc.log"), {}, on}}));
  }
  /// The demonstration machine with a file, as the user has it.
  void begin(bool log) {
    load();
    setLog(log);
    ASSERT_TRUE(workspace_.document().save(folder_.filePath(QStringLiteral("press.syncline"))));
    ASSERT_TRUE(workspace_.goOnline());
    for (int i = 0; i < 100 && workspace_.live().snapshot().state != AlState::kOp; ++i) run(200 * kMillisecond);
    ASSERT_EQ(workspace_.live().snapshot().state, AlState::kOp);
    run(2 * kSecond);
  }
  QStringList logs() { return QDir(folder_.path()).entryList({QStringLiteral("*.csv")}); }
  bool told(const QString& words) {
    const auto& messages = workspace_.messages();
    for (int row = 0; row < messages.rowCount(); ++row) {
      if (messages.message(row).text.contains(words)) return true;
    }
    return false;
  }

  QTemporaryDir folder_;
};

TEST_F(DcmLogRecording, LiesBesideTheProjectAndThePlaceIsTold) {
  begin(true);
  ASSERT_FALSE(HasFatalFailure());
  QSignalSpy ended(&workspace_.runs(), &NetworkRuns::dcmLogEnded);
  workspace_.live().shutDown();
  ASSERT_TRUE(test::waitFor([&] { return ended.count() == 1; }));
  ASSERT_EQ(logs().size(), 1);
  const auto path = folder_.filePath(logs().front());
  EXPECT_TRUE(logs().front().startsWith(QStringLiteral("press-dcmlog-"))) << qPrintable(logs().front());
  EXPECT_TRUE(told(path)) << "the user is told where";
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const auto rows = read_dcm_log(file.readAll().toStdString());
  ASSERT_TRUE(rows.has_value());
  EXPECT_GT(rows->size(), 1000U) << "a line a cycle";
  EXPECT_TRUE(rows->back().dcm_in_sync);
  EXPECT_NE(rows->back().dc_start_time_ns, 0);
}

TEST_F(DcmLogRecording, IsKeptOnlyWhereItIsWished) {
  begin(false);
  ASSERT_FALSE(HasFatalFailure());
  workspace_.live().shutDown();
  workspace_.runs().finish();
  EXPECT_TRUE(logs().isEmpty());
}

TEST_F(DcmLogRecording, BeginsWithTheParametersThatAreApplied) {
  begin(false);
  ASSERT_FALSE(HasFatalFailure());
  setLog(true);
  workspace_.runDifference().apply();
  run(kSecond);
  workspace_.live().shutDown();
  workspace_.runs().finish();
  ASSERT_EQ(logs().size(), 1);
}

TEST_F(DcmLogRecording, ThatCannotBeWrittenIsAnError) {
  load();
  setLog(true);
  const auto gone = folder_.filePath(QStringLiteral("gone"));
  ASSERT_TRUE(QDir().mkpath(gone));
  ASSERT_TRUE(workspace_.document().save(gone + QStringLiteral("/press.syncline")));
  ASSERT_TRUE(QDir(gone).removeRecursively());
  QFile in_its_place(gone);
  ASSERT_TRUE(in_its_place.open(QIODevice::WriteOnly));
  const int errors = workspace_.messages().count(Severity::kError);
  ASSERT_TRUE(workspace_.goOnline());
  EXPECT_EQ(workspace_.messages().count(Severity::kError), errors + 1);
  EXPECT_NE(workspace_.live().phase(), LiveSession::Phase::kOffline) << "the machine runs all the same";
}

}  // namespace
}  // namespace syncline::ui
