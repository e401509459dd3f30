// SPDX-License-Identifier: Apache-2.0
#include "record/recording_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "record/recorder.h"
#include "record/replay_run.h"
#include "support/whole_file.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

class RecordingNotes : public testing::Test {
 protected:
  RecordingNotes() { config_.slaves.resize(3); }
  [[nodiscard]] std::string path(const char* name = "run.slrec") const { return (folder_.path() / name).string(); }
  std::unique_ptr<Recorder> start() {
    Recorder::Options options;
    options.by_clock = false;
    options.keep_free_bytes = 0;
    auto recorder = Recorder::start(path(), about_run(config_), options, {});
    EXPECT_TRUE(recorder);
    return std::move(*recorder);
  }
  /// 2000 cycles with these notes.
  void record(const std::vector<RunNote>& notes) {
    auto recorder = start();
    test::MadeSamples made(3);
    for (int i = 0; i < 20; ++i) recorder->add(made.next(100));
    for (const auto& note : notes) recorder->add(note);
    ASSERT_TRUE(recorder->finish());
  }
  std::vector<RunNote> notes() {
    auto reader = RecordingReader::open(path());
    EXPECT_TRUE(reader);
    return reader->info()->notes;
  }

  NetworkConfig config_;
  test::TemporaryFolder folder_;
};

TEST_F(RecordingNotes, TakeThePlaceOfThoseBefore) {
  record({{5, "first"}, {9, "second"}});
  EXPECT_EQ(notes(), (std::vector<RunNote>{{5, "first"}, {9, "second"}}));
  const std::vector<RunNote> others = {{7,
                                        "Kabel \xC3\xBC"
                                        "berpr\xC3\xBC"
                                        "ft; \"quoted\"\nand a line"}};
  ASSERT_TRUE(write_notes(path(), others));
  EXPECT_EQ(notes(), others);
  EXPECT_FALSE(std::filesystem::exists(path() + "-wal")) << "one file, as before";
  ASSERT_TRUE(write_notes(path(), {}));
  EXPECT_TRUE(notes().empty());
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->verify()) << "nothing else has changed";
}

TEST_F(RecordingNotes, AreReplayedByTheirTimes) {
  record({{9, "later"}, {5, "earlier"}});
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  const auto run = replay_run(*reader, config_);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->record->notes(), (std::vector<RunNote>{{5, "earlier"}, {9, "later"}}));
}

TEST_F(RecordingNotes, OfOneThatIsBeingWrittenStay) {
  auto recorder = start();
  test::MadeSamples made(3);
  recorder->add(made.next(100));
  recorder->add(RunNote{5, "its own"});
  const auto status = write_notes(path(), std::vector<RunNote>{{6, "another's"}});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(status.error().file, path());
  for (int i = 0; i < 20; ++i) recorder->add(made.next(100));
  ASSERT_TRUE(recorder->finish()) << "whoever writes it is not disturbed";
  EXPECT_EQ(notes(), (std::vector<RunNote>{{5, "its own"}}));
}

TEST_F(RecordingNotes, AreForRecordingsOnly) {
  EXPECT_EQ(write_notes(path("none.slrec"), {}).error().code, ErrorCode::kFileNotFound);
  EXPECT_FALSE(std::filesystem::exists(path("none.slrec")));
  ASSERT_TRUE(write_whole_file(path("text.slrec"), "no recording"));
  EXPECT_EQ(write_notes(path("text.slrec"), {}).error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(*read_whole_file(path("text.slrec")), "no recording");
}

TEST(RunRecordNotes, StandByTheirTimesAndSayThatTheyChanged) {
  NetworkConfig config;
  RunRecord record(config);
  const auto before = record.notes_changed();
  record.add(RunNote{20, "b"});
  record.add(RunNote{10, "a"});
  record.add(RunNote{20, "c"});
  EXPECT_EQ(record.notes(), (std::vector<RunNote>{{10, "a"}, {20, "b"}, {20, "c"}}));
  EXPECT_NE(record.notes_changed(), before);
  const auto now = record.notes_changed();
  record.set_notes({});
  EXPECT_TRUE(record.notes().empty());
  EXPECT_NE(record.notes_changed(), now);
}

}  // namespace
}  // namespace syncline
