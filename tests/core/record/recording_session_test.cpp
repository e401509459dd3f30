// SPDX-License-Identifier: Apache-2.0
#include "record/recording_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "channels/event.h"
#include "config/network_config.h"
#include "made_samples.h"
#include "record/recorded_event.h"
#include "record/recording_reader.h"
#include "record/run_record.h"
#include "record/trigger_document.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

class RecordedRun : public testing::Test {
 protected:
  RecordedRun() {
    config_.slaves.resize(3);
    record_ = std::make_unique<RunRecord>(config_);
  }
  std::unique_ptr<RecordingSession> start(Nanoseconds begun = 0) {
    auto about = about_run(*record_);
    add_source(about, {"test 1", "sim:demo", "m.syncline", "the project", "<the ENI/>"});
    auto session = RecordingSession::start({.path = path(), .virtual_time = true}, about, {}, begun);
    EXPECT_TRUE(session) << session.error().detail.text();
    return std::move(*session);
  }
  /// Of one second.
  std::vector<CycleSample> run(RecordingSession& session) {
    auto samples = made_.next(1000);
    record_->add(samples);
    session.add(samples);
    session.follow(*record_);
    return samples;
  }
  RecordingInfo read() {
    auto reader = RecordingReader::open(path());
    EXPECT_TRUE(reader) << reader.error().detail.text();
    return reader->info().value();
  }
  [[nodiscard]] std::string path() const { return folder_.file("run.slrec"); }

  NetworkConfig config_;
  std::unique_ptr<RunRecord> record_;
  test::MadeSamples made_{3};
  test::TemporaryFolder folder_;
};

TEST_F(RecordedRun, SaysWhatWasRun) {
  auto session = start();
  run(*session);
  ASSERT_TRUE(session->finish("end of the run", session->close(*record_)));
  const auto about = read().about;
  EXPECT_EQ(about.program, "test 1");
  EXPECT_EQ(about.link, "sim:demo");
  const RecordedDocument project{"project", "m.syncline", "the project"};
  const RecordedDocument configuration{"configuration", "configuration.eni.xml", "<the ENI/>"};
  EXPECT_THAT(about.documents, testing::UnorderedElementsAre(project, configuration));
}

TEST_F(RecordedRun, HoldsEventsInTheirWordsAndNoneThatOnlyProgramsCareAbout) {
  auto session = start();
  const auto samples = run(*session);
  const Event lost{samples[10].send_time, 2, events::SlaveLost{}};
  session->add(Event{samples[5].send_time, -1, events::ScanProgress{}});
  session->add(lost);
  ASSERT_TRUE(session->finish("end of the run", {}));
  const auto events = read().events;
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0], recorded_event(lost));
  EXPECT_EQ(events[0].kind, "slave_lost");
  EXPECT_TRUE(events[0].text.starts_with("slave 2")) << events[0].text;
}

TEST_F(RecordedRun, CountsItsMomentsFromItsFirstSample) {
  auto earlier = made_.next(1000);
  record_->add(earlier);
  auto session = start(earlier.back().send_time);
  EXPECT_EQ(session->told_from(), earlier.back().send_time);
  EXPECT_EQ(session->duration(*record_), 0);
  const auto samples = run(*session);
  EXPECT_EQ(session->told_from(), samples.front().send_time);
  EXPECT_EQ(session->duration(*record_), samples.back().send_time - earlier.back().send_time);
}

TEST_F(RecordedRun, TellsItsStandingWhenItIsAnother) {
  auto session = start();
  run(*session);
  session->begin(*record_);
  record_->arm();
  run(*session);
  ASSERT_TRUE(session->finish("end of the run", session->close(*record_)));
  EXPECT_EQ(read().about.armed, record_->standing().armed.value_or(RecordingAbout::kNotArmed));
}

TEST_F(RecordedRun, TellsWhatTriggersFoundAtItsEndAtTheLatest) {
  auto session = start();
  run(*session);
  KeptTrigger kept;
  kept.trigger.signal = Signal::kDcmError;
  kept.episodes.resize(1);
  record_->keep(kept);
  EXPECT_TRUE(kept_triggers(read().about).empty());
  session->note_triggers();
  ASSERT_TRUE(session->finish("end of the run", session->close(*record_)));
  EXPECT_EQ(kept_triggers(read().about), std::vector{kept});
}

TEST_F(RecordedRun, IsNoneWhereThereIsAFileAlready) {
  auto session = start();
  ASSERT_TRUE(session->finish("end of the run", {}));
  const auto second = RecordingSession::start({.path = path()}, about_run(*record_), {});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kFileNotWritable);
}

}  // namespace
}  // namespace syncline
