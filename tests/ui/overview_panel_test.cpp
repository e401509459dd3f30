// SPDX-License-Identifier: Apache-2.0
// The overview of machines that are not what they were: dead slaves, several episodes, tails of jitter.
#include "ui/panels/overview_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>
#include <QToolButton>
#include <initializer_list>
#include <vector>

#include "support/running_window.h"
#include "support/whole_file.h"
#include "ui/dialogs/file_commands.h"
#include "ui/panels/figure_card.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr Nanoseconds kRunBegin = 830'000'000 * kSecond;

CycleSample goodCycle(std::uint64_t number) {
  CycleSample sample;
  sample.cycle = number;
  sample.send_time = kRunBegin + static_cast<Nanoseconds>(number) * kMillisecond;
  sample.flags =
      CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
  sample.slaves_sync = sample.master_sync = SyncState::kInSync;
  sample.deviation_ns = 12;
  sample.slave_position = static_cast<std::int16_t>(1 + number % 2);
  return sample;
}

class OverviewPanelTest : public testing::Test {
 protected:
  OverviewPanelTest() : record_(network()) {
    panel_.setRecord(&record_, false);
    panel_.setLive(true);
    panel_.show();
  }
  static NetworkConfig network() {
    NetworkConfig config;
    for (const auto* name : {"Coupler", "Servo 1", "Servo 2", "Servo 3"}) config.slaves.emplace_back().name = name;
    config.cyclic.resize(1);
    config.cyclic.front().cycle_time = kMillisecond;
    config.dc.enabled = config.dc.sync_window.enabled = true;
    return config;
  }
  void go(int cycles, std::initializer_list<std::uint16_t> states = {8, 8, 8, 8}, std::int32_t filtered = 0) {
    for (int i = 0; i < cycles; ++i) {
      auto sample = goodCycle(cycle_++);
      sample.dcm_error_ns = sample.dcm_error_filtered_ns = filtered;
      record_.add({&sample, 1});
    }
    Snapshot snapshot;
    snapshot.time = now();
    snapshot.online = true;
    for (const auto state : states) {
      auto& slave = snapshot.slaves.emplace_back();
      slave.present = state != 0;
      slave.al_status = state;
      slave.absent_since = state != 0 ? 0 : snapshot.time;
    }
    record_.add(snapshot);
    panel_.refresh();
  }
  Nanoseconds now() const { return kRunBegin + static_cast<Nanoseconds>(cycle_ - 1) * kMillisecond; }
  std::string banner() { return panel_.findChild<QLabel*>(QStringLiteral("overviewFault"))->text().toStdString(); }
  std::string label(const char* name) { return panel_.findChild<QLabel*>(QLatin1String(name))->text().toStdString(); }
  Pill& slaves() { return *panel_.findChild<Pill*>(QStringLiteral("overviewSlaves")); }
  QToolButton& button(const char* name) { return *panel_.findChild<QToolButton*>(QLatin1String(name)); }

  RunRecord record_;
  OverviewPanel panel_;
  std::uint64_t cycle_ = 0;
};

/// The verdict is of those who answer: a machine without half of its drives is not in sync.
TEST_F(OverviewPanelTest, ALampOverDeadSlavesIsRed) {
  go(1000);
  EXPECT_EQ(slaves().tone(), theme::Tone::kGood);
  EXPECT_EQ(label("overviewStanding"), "4 of 4 slaves in OP");
  go(1000, {8, 8, 0, 0});
  EXPECT_EQ(slaves().tone(), theme::Tone::kBad);
  EXPECT_THAT(slaves().text().toStdString(), StartsWith("1 of 2 do")) << "the last one never followed";
  EXPECT_THAT(label("overviewSlavesText"), HasSubstr("the others: In sync"));
  EXPECT_THAT(label("overviewStanding"), StartsWith("2 of 4 slaves in OP, 2 do"));
  EXPECT_THAT(panel_.text().toStdString(), HasSubstr("2 of 4 slaves in OP, 2 do")) << "copied, too";
  go(1000);
  EXPECT_EQ(slaves().tone(), theme::Tone::kGood);
}

/// An or of magnitudes is more than any of them, and no figure of a slave.
TEST_F(OverviewPanelTest, AnUpperEstimateIsCalledOne) {
  go(100);
  auto* card = panel_.findChild<FigureCard*>(QStringLiteral("overviewDeviation"));
  ASSERT_NE(card, nullptr);
  const auto told = [card] { return card->lines().join(u'\n'); };
  EXPECT_FALSE(told().contains(QChar(0x2264))) << qPrintable(told());
  for (int i = 0; i < 300; ++i) {
    auto sample = goodCycle(cycle_++);
    sample.flags |= CycleSample::kDeviationValid;
    sample.deviation_ored_ns = sample.deviation_ns;
    record_.add({&sample, 1});
  }
  panel_.refresh();
  EXPECT_EQ(told().count(QStringLiteral("\u2264 12")), 5) << qPrintable(told());
}

/// Also where nothing runs that would refresh it.
TEST_F(OverviewPanelTest, TheSlavesInOpHaveTheColourOfTheTheme) {
  go(1000);
  auto* standing = panel_.findChild<QLabel*>(QStringLiteral("overviewStanding"));
  const auto color = [standing] { return standing->palette().color(QPalette::WindowText); };
  const auto light = color();
  theme::apply(theme::Mode::kDark);
  QApplication::processEvents();
  const auto dark = color();
  theme::apply(theme::Mode::kLight);
  QApplication::processEvents();
  EXPECT_NE(dark, light);
  EXPECT_EQ(color(), light);
}

/// What came later does not hide what is not over, and each episode can be looked at.
TEST_F(OverviewPanelTest, GoesThroughTheEpisodes) {
  go(1000);
  const auto broken = now();
  record_.add(Event{broken, -1, events::WkcError{15, 12, 1}});
  record_.add(Event{broken + kMillisecond, 2, events::CableChanged{}});
  record_.add(Event{broken + kMillisecond, 3, events::SlaveLost{}});
  go(1000);
  EXPECT_TRUE(button("overviewEarlier").isHidden()) << "there is one";
  EXPECT_THAT(banner(), HasSubstr("Seen 1 cycle"));
  EXPECT_THAT(banner(), HasSubstr("Then in the same cycle"));
  EXPECT_LT(banner().find("NOTHING COMES BACK"), banner().find("Working counter 12 instead of 15")) << banner();
  EXPECT_THAT(banner(), HasSubstr("and it is not over."));
  go(5000);
  record_.add(Event{now(), 1, events::SlavesOutOfSync{48'502, 1}});
  go(1000);
  EXPECT_THAT(banner(), HasSubstr("It is episode 2 of 2"));
  EXPECT_THAT(banner(), HasSubstr("Not over: ")) << "the cable of the first one";
  EXPECT_THAT(banner(), HasSubstr("NOTHING COMES BACK"));
  button("overviewEarlier").click();
  EXPECT_THAT(banner(), HasSubstr("It is episode 1 of 2"));
  EXPECT_FALSE(button("overviewEarlier").isEnabled());
  go(10);
  EXPECT_THAT(banner(), HasSubstr("It is episode 1 of 2")) << "it stays";
  button("overviewLater").click();
  EXPECT_FALSE(button("overviewLater").isEnabled());
  record_.add(Event{now(), 2, events::CableChanged{.healed = true}});
  record_.add(Event{now(), 3, events::SlaveFound{}});
  record_.add(Event{now(), -1, events::SlavesInSync{}});
  go(1);
  EXPECT_THAT(banner(), Not(HasSubstr("Not over")));
  button("overviewEarlier").click();
  EXPECT_THAT(banner(), HasSubstr(", until "));
}

/// The lamp, the card and the margin are one verdict: a tail that it bears is not red, what it was lost by is.
TEST_F(OverviewPanelTest, ATailOfJitterIsNotRedAndALossIs) {
  const auto note = [this] {
    return panel_.findChild<FigureCard*>(QStringLiteral("overviewDcm"))->noteText().toStdString();
  };
  go(1000);
  const auto limit = static_cast<std::int32_t>(record_.limits().dcm_error_ns);
  ASSERT_GT(limit, 0);
  go(20, {8, 8, 8, 8}, 2 * limit);
  go(1000);
  EXPECT_THAT(note(), HasSubstr("filtered, lasting: 100 % margin"));
  go(300, {8, 8, 8, 8}, 2 * limit);
  EXPECT_THAT(note(), HasSubstr("2.0 times the limit"));
  record_.arm();
  go(100);
  auto lost = goodCycle(cycle_++);
  lost.master_sync = SyncState::kOutOfSync;
  record_.add({&lost, 1});
  go(1000);
  EXPECT_THAT(note(), HasSubstr("lost 1 time"));
}

class RecordedStatus : public test::RunningWindow {};

/// The status bar over a recording is of the recording, not of a project that is not there.
TEST_F(RecordedStatus, SaysWhatTheRecordingSays) {
  goOnline();
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("run.slrec"));
  bool ended = false;
  QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_, [&ended] { ended = true; });
  ASSERT_TRUE(workspace_.disk().start(path));
  run(2 * kSecond);
  workspace_.runs().shutDown();
  ASSERT_TRUE(test::waitFor([&ended] { return ended; }));
  window_.files().openAny(path);
  ASSERT_TRUE(test::waitFor([this] { return workspace_.recording().isOpen(); }));
  const auto text = [this](const char* name) { return field<QLabel>(name).text().replace(QChar::Nbsp, u' '); };
  const auto count = project().slaves.size();
  EXPECT_EQ(text("statusSlaves"), QStringLiteral("Slaves %1/%1 OP").arg(count));
  EXPECT_EQ(text("statusLosses"), QStringLiteral("Lost 0  Late 0  Left out 0"));
  EXPECT_EQ(text("statusCycle"), QStringLiteral("Cycle 1 ms"));
  EXPECT_EQ(text("statusLink"), QStringLiteral("run.slrec"));
  EXPECT_EQ(field<Pill>("statusDc").tone(), theme::Tone::kGood);
  // A table that tells neither: no zeros.
  const auto table = folder.filePath(QStringLiteral("run.csv"));
  ASSERT_TRUE(write_whole_file(table.toStdString(),
                               std::string_view("cycle,send_time_ns,dcm_error_ns\n0,1000000,5\n1,2000000,7\n"
                                                "2,3000000,6\n3,4000000,5\n")));
  window_.files().openAny(table);
  ASSERT_TRUE(test::waitFor([&] { return workspace_.recording().path() == table; }));
  EXPECT_EQ(text("statusLosses"), QStringLiteral("Lost \u2013  Late \u2013  Left out \u2013"));
  EXPECT_EQ(text("statusSlaves"), QStringLiteral("Slaves \u2013"));
}

}  // namespace
}  // namespace syncline::ui
