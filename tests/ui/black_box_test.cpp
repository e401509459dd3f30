// SPDX-License-Identifier: Apache-2.0
// The black box of raw frames in the window: wished for in a dialog, kept run by run, told in status bar and messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <cerrno>
#include <memory>

#include "support/running_window.h"
#include "tests/support/pcapng_file.h"
#include "ui/dialogs/black_box_dialog.h"
#include "ui/dialogs/network_commands.h"
#include "ui/text/black_box_text.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

class BlackBoxWindow : public test::RunningWindow {
 protected:
  BlackBoxWindow() { window_.show(); }
  [[nodiscard]] QString folder() const { return folder_.filePath(QStringLiteral("frames")); }
  void wish(bool on) { workspace_.setBlackBox({on, folder(), 128}); }
  std::unique_ptr<BlackBoxDialog> dialog() {
    auto shown = std::make_unique<BlackBoxDialog>(workspace_);
    shown->show();
    return shown;
  }
  [[nodiscard]] QStringList files() const { return QDir(folder()).entryList(QDir::Files, QDir::Name); }
  [[nodiscard]] std::vector<test::PcapngBlock> packets() const {
    return test::packets_in(test::files_in(folder().toStdString()));
  }
  FrameKeeper& frames() { return workspace_.runs().current().frames; }
  Pill& pill() { return *window_.findChild<Pill*>(QStringLiteral("statusBlackBox")); }
  void goOffline() {
    workspace_.live().goOffline();
    ASSERT_TRUE(test::waitFor(
        [&] { return workspace_.live().phase() == LiveSession::Phase::kOffline && !frames().isWriting(); }));
  }
  /// Of this source, the newest.
  QString message(const QString& source) {
    for (int row = 0; row < workspace_.messages().rowCount(); ++row) {
      if (workspace_.messages().message(row).source == source) return workspace_.messages().message(row).text;
    }
    return {};
  }

  QTemporaryDir folder_;
};

TEST_F(BlackBoxWindow, KeepsTheFramesOfARunFromItsFirstOne) {
  wish(true);
  EXPECT_TRUE(pill().isHidden());
  goOnline();
  EXPECT_TRUE(frames().isKeeping());
  EXPECT_FALSE(pill().isHidden());
  run(5 * kSecond);
  EXPECT_TRUE(test::waitFor([&] { return frames().report().frames > 10'000; }));
  workspace_.live().advance(100 * kMillisecond);
  EXPECT_TRUE(pill().text().startsWith(QStringLiteral("Black box "))) << pill().text().toStdString();
  EXPECT_TRUE(pill().toolTip().contains(QStringLiteral("machine_*.pcapng"))) << pill().toolTip().toStdString();
  const auto end = workspace_.live().record()->samples().last_time();
  goOffline();
  EXPECT_TRUE(pill().isHidden());
  const auto kept = packets();
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(kept.size(), frames().report().frames);
  EXPECT_TRUE(files().front().startsWith(QStringLiteral("machine_00001_"))) << files().front().toStdString();
  EXPECT_GE(kept.back().time, end) << "until it was taken down";
  std::vector<std::string> comments;
  for (const auto& packet : kept) {
    for (auto& comment : packet.comments()) comments.push_back(std::move(comment));
  }
  EXPECT_THAT(comments, testing::Contains(testing::HasSubstr("online")));
  EXPECT_TRUE(message(QStringLiteral("Black box")).startsWith(QStringLiteral("The last ")));
}

TEST_F(BlackBoxWindow, LabelsOfTheDialogLeadToTheirFields) {
  BlackBoxDialog dialog(workspace_, &window_);
  for (const auto* label : dialog.findChildren<QLabel*>()) {
    if (!label->text().contains(u'&')) continue;
    EXPECT_NE(label->buddy(), nullptr) << label->text().toStdString() << " would show its key's mark";
  }
}

TEST_F(BlackBoxWindow, BeginsAndEndsWhileTheMachineRuns) {
  goOnline();
  EXPECT_FALSE(frames().isKeeping());
  wish(true);
  EXPECT_TRUE(frames().isKeeping());
  run(2 * kSecond);
  wish(false);
  EXPECT_FALSE(frames().isKeeping());
  EXPECT_TRUE(test::waitFor([&] { return !frames().isWriting(); }));
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  const auto first = packets().size();
  EXPECT_GT(first, 2'000U);
  run(1 * kSecond);
  EXPECT_EQ(packets().size(), first) << "nothing is kept any more";
  wish(true);
  run(1 * kSecond);
  goOffline();
  EXPECT_GT(packets().size(), first);
  EXPECT_EQ(files().size(), 2);
}

TEST_F(BlackBoxWindow, AsksAndRemembers) {
  load();
  auto shown = dialog();
  auto* on = test::find<QCheckBox>(*shown, "blackBoxOn");
  auto* place = test::find<QLineEdit>(*shown, "blackBoxFolder");
  auto* mib = test::find<QSpinBox>(*shown, "blackBoxMib");
  auto* reach = test::find<QLabel>(*shown, "blackBoxReach");
  auto* ok = test::find<QPushButton>(*shown, "blackBoxAccept");
  EXPECT_FALSE(on->isChecked());
  EXPECT_FALSE(place->text().isEmpty());
  EXPECT_FALSE(place->isEnabled());
  on->click();
  place->clear();
  EXPECT_FALSE(ok->isEnabled());
  place->setText(folder());
  EXPECT_TRUE(ok->isEnabled());
  mib->setValue(1);
  const auto little = reach->text();
  mib->setValue(1'000);
  EXPECT_NE(reach->text(), little);
  ok->click();
  EXPECT_EQ(workspace_.runs().blackBox(), (BlackBoxWish{true, folder(), 1'000}));
  EXPECT_TRUE(dialog()->findChild<QCheckBox*>(QStringLiteral("blackBoxOn"))->isChecked());
  ASSERT_NE(window_.findChild<QAction*>(QStringLiteral("actionBlackBox")), nullptr);
}

TEST_F(BlackBoxWindow, IsRememberedFromOneWindowToTheNext) {
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder_.filePath(QStringLiteral("settings.ini"));
  const BlackBoxWish wished{true, folder(), 17};
  {
    Workspace before(environment);
    EXPECT_EQ(before.runs().blackBox(), BlackBoxWish{});
    before.setBlackBox(wished);
  }
  Workspace after(environment);
  EXPECT_EQ(after.runs().blackBox(), wished);
}

TEST_F(BlackBoxWindow, EndsWithAMessageWhenTheFolderIsTakenAway) {
  wish(true);
  goOnline();
  ASSERT_TRUE(test::waitFor([&] { return !files().isEmpty(); }));
  ASSERT_TRUE(QDir(folder()).removeRecursively());
  ASSERT_TRUE(test::waitFor([&] {
    workspace_.live().advance(100 * kMillisecond);
    return !frames().isKeeping() && !frames().isWriting();
  }));
  workspace_.live().advance(100 * kMillisecond);
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  EXPECT_EQ(pill().text(), QStringLiteral("Black box ended"));
  EXPECT_TRUE(message(QStringLiteral("Black box")).contains(QStringLiteral("the file is gone")))
      << message(QStringLiteral("Black box")).toStdString();
}

TEST_F(BlackBoxWindow, WhereItCannotBeTheMachineRunsWithout) {
  ASSERT_TRUE(write_whole_file(folder().toStdString(), "no folder"));
  wish(true);
  goOnline();
  EXPECT_FALSE(frames().isKeeping());
  EXPECT_EQ(pill().text(), QStringLiteral("Black box ended"));
  EXPECT_TRUE(message(QStringLiteral("Black box")).contains(QStringLiteral("Not a directory")));
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
}

TEST_F(BlackBoxWindow, EachNetworkHasItsOwn) {
  Machine machine;
  machine.networks.resize(2);
  workspace_.document().take(machine, {}, true);
  wish(true);
  goOnline();
  window_.findChild<NetworkCommands*>()->choose(1);
  goOnline();
  run(1 * kSecond);
  workspace_.runs().shutDown();
  workspace_.runs().finish();
  const auto found = files().join(u'\n');
  EXPECT_TRUE(found.contains(QStringLiteral("machine-Network 1_00001_"))) << found.toStdString();
  EXPECT_TRUE(found.contains(QStringLiteral("machine-Network 2_00001_"))) << found.toStdString();
}

TEST(BlackBoxText, SaysWhatIsThereAndWhatIsMissing) {
  BlackBox::Report report;
  EXPECT_EQ(blackBoxText(report), QStringLiteral("No frame of the run yet"));
  report.name = "/frames/machine";
  report.frames = 20'000;
  report.files = 3;
  report.bytes = 3U << 20U;
  report.end = 10 * kSecond;
  report.lost = 7;
  report.error = Error{.code = ErrorCode::kFileNotWritable, .detail = Reason::of_system(ENOSPC), .file = "f"};
  const auto lines = blackBoxText(report).split(u'\n');
  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[0].startsWith(QStringLiteral("The last 10 s of the run, ")));
  EXPECT_TRUE(lines[0].endsWith(QStringLiteral("in /frames/machine_*.pcapng")));
  EXPECT_TRUE(lines[2].startsWith(QStringLiteral("7 frames are missing")));
}

}  // namespace
}  // namespace syncline::ui
