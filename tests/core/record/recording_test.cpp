// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "record/recorded_signals.h"
#include "record/recorder.h"
#include "record/recording_reader.h"
#include "record/recording_writer.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "sqlite/database_files.h"
#include "support/whole_file.h"
#include "tests/core/record/made_samples.h"
#include "tests/core/record/older_recording.h"
#include "tests/support/temporary_folder.h"
#include "trace/counted_at_least.h"
#include "trace/csv.h"

namespace syncline {
namespace {

using testing::HasSubstr;

RecordingAbout machine() {
  RecordingAbout about;
  about.program = "test 1";
  about.link = "sim:machine.toml?virtual";
  about.documents = {{"configuration", "c.xml", "<EtherCATConfig/>"},
                     {"project", "p.syncline", std::string("\0<p/>", 5)}};
  about.slaves = {{"Coupler", 2, 0x44C2C52, 1}, {"Input", 2, 3, 4}, {"Servo", 0x539, 5, 6}};
  about.limits = {kMillisecond, 511, 4000};
  return about;
}

Snapshot snapshot(Nanoseconds time, std::uint32_t missed) {
  Snapshot s;
  s.time = time;
  s.online = true;
  s.lost_frames = missed / 2;
  s.slaves.resize(3);
  for (auto& slave : s.slaves) {
    slave.present = true;
    slave.al_status = 8;
  }
  s.slaves[2].dc_enabled = true;
  s.slaves[2].propagation_delay_ns = 1'300;
  s.slaves[2].sm2_missed.known = true;
  s.slaves[2].sm2_missed.missed = missed;
  s.slaves[1].evidence.ports[0].lost_links = missed / 3;
  s.slaves[1].evidence.ports_time = time;
  return s;
}

/// The servo has SYNC0 and outputs.
NetworkConfig with_sync0() {
  CyclicCmd command;
  command.command = Command::kLrw;
  command.data_length = 64;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic[0].cycle_time = kMillisecond;
  config.cyclic[0].frames.resize(1);
  config.cyclic[0].frames[0].commands = {command};
  config.slaves.resize(3);
  config.slaves[2].dc = SlaveDcConfig{true, false, kMillisecond, 0, 40 * kMicrosecond, 0x0300};
  config.slaves[2].send = ImageRange{0, 64};
  return config;
}

std::string csv(std::span<const CycleSample> samples) {
  auto text = sample_csv_header();
  append_sample_csv(text, samples);
  return text;
}

class RecordingFile : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name = "run.slrec") const { return folder_.file(name); }
  std::unique_ptr<Recorder> start(const Recorder::Options& options = {}, const std::string& name = "run.slrec") {
    auto recorder = Recorder::start(path(name), about_, options, [this](const Recorder::Stop& stop) {
      stop_ = stop;
      ++stops_;
    });
    EXPECT_TRUE(recorder) << recorder.error().detail.text();
    return std::move(*recorder);
  }
  /// A recording of some seconds.
  void make(const std::string& name = "run.slrec") {
    auto recorder = start({.by_clock = false}, name);
    test::MadeSamples made(1);
    for (int i = 0; i < 40; ++i) {
      samples_ = made.next(100);
      recorder->add(samples_);
      recorder->add(snapshot(samples_.back().send_time, static_cast<std::uint32_t>(i)));
    }
    ASSERT_TRUE(recorder->finish());
  }
  static std::string read_csv(RecordingReader& reader) {
    auto text = sample_csv_header();
    const auto status = reader.samples([&text](std::span<const CycleSample> samples) {
      append_sample_csv(text, samples);
      return true;
    });
    EXPECT_TRUE(status) << status.error().detail.text();
    return text;
  }

  RecordingAbout about_ = machine();
  test::TemporaryFolder folder_;
  std::vector<CycleSample> samples_;
  Recorder::Stop stop_;
  int stops_ = 0;
};

TEST_F(RecordingFile, HoldsTheRunAsItWas) {
  test::MadeSamples made(7);
  SampleStore live({.slaves = 3});
  std::vector<CycleSample> all;
  auto recorder = start();
  for (int i = 0; i < 120; ++i) {
    const auto samples = made.next(100);
    all.insert(all.end(), samples.begin(), samples.end());
    recorder->add(samples);
    live.append(samples);
    const auto now = snapshot(samples.back().send_time, static_cast<std::uint32_t>(i / 7));
    recorder->add(now);
    live.append(now);
  }
  const RecordedEvent lost{all[50].send_time, -1, "frames_lost", "1 frame lost"};
  const RecordedEvent error{all[60].send_time, 2, "al_status_error", "slave 2: error"};
  recorder->add(lost);
  recorder->add(error);
  recorder->add(RunNote{all[70].send_time, "cable pulled"});
  ASSERT_TRUE(
      recorder->finish("end of the run", std::vector<RecordedFinding>{{"frames-lost", "warning", -1, "noise"}}));

  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->about.program, "test 1");
  EXPECT_EQ(info->about.link, machine().link);
  EXPECT_EQ(info->about.documents, machine().documents);
  EXPECT_EQ(info->about.slaves, machine().slaves);
  EXPECT_EQ(info->about.limits, machine().limits);
  EXPECT_EQ(info->ended, "end of the run");
  EXPECT_EQ(info->cycles, all.size());
  EXPECT_EQ(info->missing_cycles, all.back().cycle - all.front().cycle + 1 - all.size());
  EXPECT_EQ(info->events, (std::vector<RecordedEvent>{lost, error}));
  EXPECT_EQ(info->findings.size(), 1U);
  EXPECT_EQ(info->notes, (std::vector<RunNote>{{all[70].send_time, "cable pulled"}}));
  EXPECT_EQ(read_csv(*reader), csv(all)) << "byte for byte";
  EXPECT_TRUE(reader->verify());
  EXPECT_FALSE(std::filesystem::exists(path() + "-wal")) << "one file, when it is done";

  for (int slave = 0; slave < 3; ++slave) {
    const auto twice = reader->points(Signal::kSlaveDeviation, slave);
    ASSERT_TRUE(twice);
    EXPECT_TRUE(twice->times.empty()) << "readings stand in their cycles, and nowhere else";
  }
  // What the plots hold is what the file holds.
  for (const auto& [signal, slave] : {std::pair{Signal::kSm2Missed, 2},
                                      {Signal::kLostFrames, -1},
                                      {port_signal(0, PortSignal::kLostLinks), 1},
                                      {Signal::kAlState, 0}}) {
    const auto points = reader->points(signal, slave);
    ASSERT_TRUE(points);
    RecordingReader::Points drawn;
    const auto& series = live.series(signal, static_cast<std::size_t>(std::max(slave, 0)));
    series.for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds time, float value) {
      drawn.times.push_back(time);
      drawn.values.push_back(value);
    });
    EXPECT_EQ(points->times, drawn.times) << syncline::info(signal).key;
    EXPECT_EQ(points->values.size(), drawn.values.size());
  }
  const auto overview = reader->overview(Signal::kDcmError);
  ASSERT_TRUE(overview);
  const auto extent = live.series(Signal::kDcmError).extent(INT64_MIN, INT64_MAX);
  double low = 0, high = 0;
  for (const auto& block : *overview) {
    low = std::min(low, block.min);
    high = std::max(high, block.max);
  }
  EXPECT_EQ(low, static_cast<double>(extent->min));
  EXPECT_EQ(high, static_cast<double>(extent->max));
}

/// Between two snapshots a slave may fall and come back: the events tell it, in the file, too.
TEST_F(RecordingFile, HoldsAFallThatNoSnapshotHasMet) {
  auto recorder = start({.by_clock = false});
  test::MadeSamples made(3);
  Nanoseconds fall = 0, back = 0, end = 0;
  const auto tell = [&](Nanoseconds time, AlState from, AlState to) {
    recorder->add(RecordedEvent{time, 1, "state", "words", encode_event(events::StateChanged{from, to})});
  };
  for (int i = 0; i < 30; ++i) {
    const auto samples = made.next(100);
    recorder->add(samples);
    auto now = snapshot(samples.back().send_time, 0);
    for (auto& slave : now.slaves) slave.al_status = 8;
    if (i == 15) {
      fall = samples[20].send_time;
      back = samples[25].send_time;
      tell(fall, AlState::kOp, AlState::kSafeop);
      recorder->add(RecordedEvent{fall, 1, "error", "words", encode_event(events::AlStatusError{0x14, 0x1B})});
      tell(back, AlState::kSafeop, AlState::kOp);
    }
    recorder->add(now);
    end = samples[90].send_time;
  }
  tell(end, AlState::kOp, AlState::kInit);
  recorder->add(RecordedEvent{end, -1, "offline", "words", encode_event(events::Offline{})});
  ASSERT_TRUE(recorder->finish());
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  NetworkConfig config;
  config.slaves.resize(3);
  const auto run = replay_run(*reader, config);
  ASSERT_TRUE(run);
  const auto& samples = run->record->samples();
  EXPECT_EQ(samples.value(Signal::kAlState, 1, fall - 1)->value, 8);
  EXPECT_EQ(samples.value(Signal::kAlState, 1, fall)->value, 0x14) << "with its error";
  EXPECT_EQ(samples.value(Signal::kAlState, 1, back)->value, 8);
  EXPECT_EQ(samples.value(Signal::kAlState, 1, samples.last_time())->value, 8) << "how it was left is no part of it";
}

/// A counter at its end stop counts no further: what a recording shows of it is a lower bound from then on.
TEST_F(RecordingFile, HoldsWhichCountsMayBeHigher) {
  const auto errors = port_signal(0, PortSignal::kLostLinks);
  auto recorder = start({.by_clock = false});
  test::MadeSamples made(3);
  Nanoseconds before = 0, since = 0;
  for (int i = 0; i < 30; ++i) {
    const auto samples = made.next(100);
    recorder->add(samples);
    auto now = snapshot(samples.back().send_time, static_cast<std::uint32_t>(i));
    now.slaves[1].evidence.ports[0].at_least = i >= 15;
    recorder->add(now);
    if (i < 15) before = now.time;
    if (i == 15) since = now.time;
  }
  ASSERT_TRUE(recorder->finish());
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->verify());
  NetworkConfig config;
  config.slaves.resize(3);
  const auto run = replay_run(*reader, config);
  ASSERT_TRUE(run);
  const auto& store = run->record->samples();
  EXPECT_FALSE(counted_at_least(store, errors, 1, before));
  EXPECT_TRUE(counted_at_least(store, errors, 1, since));
  EXPECT_TRUE(counted_at_least(store, errors, 1, store.last_time()));
  EXPECT_FALSE(counted_at_least(store, errors, 2, store.last_time())) << "of another slave";
  EXPECT_FALSE(counted_at_least(store, Signal::kSm2Missed, 2, store.last_time())) << "of another count";
}

TEST_F(RecordingFile, TellsHowOftenEachSignalWasReadAndWhoStampedIt) {
  make();
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  const auto found = recorded_signals(*reader, 3);
  ASSERT_TRUE(found);
  std::vector<CycleSample> all;
  ASSERT_TRUE(reader->samples([&all](std::span<const CycleSample> samples) {
    all.insert(all.end(), samples.begin(), samples.end());
    return true;
  }));
  const auto values_of = [&found](Signal signal, int slave) {
    const auto one = std::ranges::find_if(
        found->signals, [&](const RecordedSignal& of) { return of.signal == signal && of.slave == slave; });
    return one == found->signals.end() ? 0 : one->values;
  };
  const auto count = [&all](auto has) { return static_cast<std::uint64_t>(std::ranges::count_if(all, has)); };
  const auto answered = count([](const CycleSample& s) { return (s.flags & CycleSample::kFrameLost) == 0; });
  EXPECT_EQ(values_of(Signal::kRoundTrip, -1), answered);
  EXPECT_EQ(values_of(Signal::kLateness, -1), all.size());
  EXPECT_EQ(values_of(Signal::kSlaveDeviation, 2), count([](const CycleSample& s) { return s.slave_position == 2; }));
  EXPECT_EQ(found->stamps[static_cast<std::size_t>(StampSource::kKernel)], answered);
  EXPECT_EQ(found->stamps[static_cast<std::size_t>(StampSource::kSoftware)], 0U);
  EXPECT_EQ(found->worst_stamp, std::ranges::max_element(all, {}, &CycleSample::stamp_doubt_ns)->stamp_doubt_ns);
}

/// Replayed, each series of the store has the samples that it had while the run went on, bit for bit.
TEST_F(RecordingFile, ReplaysWhatWasDrawn) {
  auto config = with_sync0();
  about_.sync0 = sync0_slaves(config);
  RunRecord live(config, 16'384);  // as much as a recording of that length keeps
  auto recorder = start();
  test::MadeSamples made(11);
  for (int i = 0; i < 150; ++i) {
    const auto samples = made.next(100);
    auto now = snapshot(samples.back().send_time, static_cast<std::uint32_t>(i / 9));
    now.slaves[0].present = i % 40 < 30;  // it comes and goes
    now.slaves[0].absent_since = now.time - kMillisecond;
    recorder->add(samples);
    recorder->add(now);
    live.add(samples);
    live.add(now);
  }
  ASSERT_TRUE(recorder->finish());
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  const auto replayed = replay_run(*reader, config);
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  const auto points = [](const MinMaxSeries& series) {
    std::vector<std::pair<Nanoseconds, std::uint32_t>> all;
    series.for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds time, float value) {
      all.emplace_back(time, std::isnan(value) ? 0xFFFF'FFFFU : std::bit_cast<std::uint32_t>(value));
    });
    return all;
  };
  for (const auto& signal : signals()) {
    if (signal.form == SignalInfo::Form::kCell || signal.form == SignalInfo::Form::kWatched) continue;
    const bool of_slaves = signal.scope == SignalInfo::Scope::kSlave;
    for (std::size_t slave = 0; slave < (of_slaves ? 3U : 1U); ++slave) {
      const auto was = points(live.samples().series(signal.id, slave));
      const auto is = points(replayed->record->samples().series(signal.id, slave));
      EXPECT_TRUE(was == is) << signal.key << " of " << slave << ": " << was.size() << " and " << is.size();
    }
  }
  EXPECT_FALSE(live.samples().series(Signal::kArrivalPhase, 2).empty());
  EXPECT_GT(live.samples().series(Signal::kSetpointSlips, 2).size(), 10U);
  config.slaves.resize(2);
  EXPECT_FALSE(replay_run(*reader, config));
}

/// Version 2 has neither the base of the SYNC grid nor delays: what is made of them is not known.
TEST_F(RecordingFile, OfVersionTwoTellsNoArrivals) {
  const auto config = with_sync0();
  auto recorder = start({.by_clock = false});
  test::MadeSamples made(1);
  auto samples = made.next(500);
  for (auto& sample : samples) {
    sample.sync_base = 0;
    sample.flags &= static_cast<std::uint16_t>(~CycleSample::kSyncBaseValid);
  }
  recorder->add(samples);
  ASSERT_TRUE(recorder->finish());
  ASSERT_TRUE(test::make_older(path(), 2));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto replayed = replay_run(*reader, config);
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  const auto& store = replayed->record->samples();
  EXPECT_FALSE(store.series(Signal::kArrivalPhase, 2).extent(INT64_MIN, INT64_MAX));
  EXPECT_TRUE(store.series(Signal::kSetpointSlips, 2).empty());
  EXPECT_FALSE(store.series(Signal::kDcmError).empty());
}

/// Events, figures, faults and findings are those that the run had.
TEST_F(RecordingFile, ReplaysWhatWasToldAndFound) {
  NetworkConfig config;
  config.slaves.resize(3);
  RunRecord live(config);
  auto recorder = start();
  test::MadeSamples made(5);
  std::vector<Finding> findings;
  std::vector<std::string_view> codes;  // whose words need no figure
  for (const auto& row : all_finding_words()) {
    if ((std::string(row.facts[0].text) + std::string(row.mend)).find('{') == std::string::npos)
      codes.push_back(row.code);
  }
  for (int i = 0; i < 80; ++i) {
    const auto samples = made.next(100);
    const auto now = snapshot(samples.back().send_time, 0);
    recorder->add(samples);
    recorder->add(now);
    live.add(samples);
    live.add(now);
    if (i % 9 != 0) continue;
    const Event event{samples[50].send_time, i % 3,
                      i % 2 == 0 ? EventDetails(events::SlaveLost{}) : EventDetails(events::WkcError{9, 6, 2})};
    recorder->add(RecordedEvent{event.time, event.slave, "kind", "words", encode_event(event.what)});
    live.add(event);
    findings = {Finding{codes[static_cast<std::size_t>(i) % codes.size()], Severity::kWarning, Place(1)}};
    findings.front().figures = {{"count", Figure::Unit::kCount, i}};
    recorder->tell(recorded(findings));
  }
  recorder->add(RecordedEvent{1, -1, "kind", "of which only the words are known"});
  ASSERT_TRUE(recorder->finish("end of the run", recorded(findings)));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  const auto replayed = replay_run(*reader, config);
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  EXPECT_TRUE(replayed->only_words);
  ASSERT_EQ(replayed->record->events().size(), live.events().size());
  for (std::size_t i = 0; i < live.events().size(); ++i) {
    const auto &was = live.events()[i], &is = replayed->record->events()[i];
    EXPECT_EQ(is.time, was.time);
    EXPECT_EQ(is.slave, was.slave);
    EXPECT_EQ(encode_event(is.what), encode_event(was.what));
  }
  EXPECT_EQ(replayed->record->findings(), findings);
  const auto &was = live.overview(), &is = replayed->record->overview();
  ASSERT_TRUE(was.armed);
  EXPECT_EQ(is.armed, was.armed);
  EXPECT_EQ(is.deviation.statistics.mean(), was.deviation.statistics.mean());
  EXPECT_EQ(is.deviation.statistics.rms(), was.deviation.statistics.rms());
  EXPECT_EQ(is.dcm_error.magnitudes.percentile(0.9999), was.dcm_error.magnitudes.percentile(0.9999));
  EXPECT_EQ(is.dcm_error.largest->time, was.dcm_error.largest->time);
  EXPECT_EQ(is.missed.count, was.missed.count);
  EXPECT_EQ(is.slaves.last_lost, was.slaves.last_lost);
  EXPECT_EQ(is.master.since, was.master.since);
  ASSERT_EQ(is.faults.episodes().size(), was.faults.episodes().size());
  for (std::size_t i = 0; i < was.faults.episodes().size(); ++i) {
    EXPECT_EQ(is.faults.episodes()[i].begin, was.faults.episodes()[i].begin);
    EXPECT_EQ(is.faults.episodes()[i].faults.size(), was.faults.episodes()[i].faults.size());
  }
}

/// A recording that begins in the midst of a run, which is armed anew and given another limit while it is recorded.
TEST_F(RecordingFile, ReplaysTheOverviewOfARunThatWentOnBefore) {
  NetworkConfig config;
  config.slaves.resize(3);
  RunRecord live(config, 0, {kMillisecond, 500, 4'000}, 0x1000);
  test::MadeSamples made(7);
  for (int i = 0; i < 20; ++i) live.add(made.next(100));
  ASSERT_TRUE(live.standing().armed);
  const auto armed_before = *live.standing().armed;
  auto recorder = start();
  recorder->tell(live.standing());
  const auto replay = [&] {
    auto reader = RecordingReader::open(path());
    return replay_run(*reader, config);
  };
  const auto run = [&](int batches) {
    for (int i = 0; i < batches; ++i) {
      const auto samples = made.next(100);
      recorder->add(samples);
      live.add(samples);
      const Event event{samples[50].send_time, i % 3, events::SlaveLost{}};
      recorder->add(RecordedEvent{event.time, event.slave, "kind", "words", encode_event(event.what)});
      live.add(event);
    }
  };
  run(30);
  Snapshot now;
  now.online = true;
  now.time = live.samples().last_time();
  now.dcm.in_sync_limit = 700;
  now.dcm.times_configured = 1;
  live.add(now);
  run(10);
  live.arm();
  recorder->tell(live.standing());
  run(20);
  ASSERT_TRUE(recorder->finish());
  const auto replayed = replay();
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  const auto &was = live.overview(), &is = replayed->record->overview();
  EXPECT_GT(*was.armed, armed_before);
  EXPECT_EQ(is.armed, was.armed);
  EXPECT_EQ(replayed->record->standing(), live.standing());
  EXPECT_EQ(replayed->record->limits().dcm_error_ns, 700);
  EXPECT_EQ(is.deviation.statistics.count(), was.deviation.statistics.count());
  EXPECT_EQ(is.deviation.statistics.rms(), was.deviation.statistics.rms());
  EXPECT_EQ(is.dcm_filtered.largest->time, was.dcm_filtered.largest->time);
  EXPECT_EQ(is.slaves.times_lost, was.slaves.times_lost);
  EXPECT_EQ(is.slaves.last_lost, was.slaves.last_lost);
  EXPECT_EQ(is.missed.count, was.missed.count);
  EXPECT_EQ(is.faults.count(), was.faults.count());
  EXPECT_EQ(is.faults.episodes().back().faults.size(), was.faults.episodes().back().faults.size());
}

TEST_F(RecordingFile, AReplaySaysHowFarItIsAndCanBeCancelled) {
  make();
  auto reader = RecordingReader::open(path());
  NetworkConfig config;
  config.slaves.resize(3);
  std::vector<std::uint64_t> seen;
  const auto stopped = replay_run(*reader, config, {.progress = [&](std::uint64_t done, std::uint64_t all) {
    EXPECT_EQ(all, 4000U);
    seen.push_back(done);
    return seen.size() < 2;
  }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(seen.size(), 2U);
}

/// What the program before this one has written lacks the values beside the words.
TEST_F(RecordingFile, ReadsTheVersionBefore) {
  auto recorder = start({.by_clock = false});
  test::MadeSamples made(1);
  recorder->add(made.next(500));
  recorder->add(RecordedEvent{5, 1, "state", "slave 1: OP", encode_event(events::SlaveLost{})});
  ASSERT_TRUE(recorder->finish("end", std::vector<RecordedFinding>{{"frames-lost", "warning", -1, "noise"}}));
  ASSERT_TRUE(test::make_older(path(), 1));
  ASSERT_TRUE(SqlDatabase::open(path())->execute(
      "ALTER TABLE event DROP COLUMN details; ALTER TABLE finding DROP COLUMN details"));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->events, (std::vector<RecordedEvent>{{5, 1, "state", "slave 1: OP"}}));
  ASSERT_EQ(info->findings.size(), 2U);
  EXPECT_EQ(info->findings[1].code, "recording-unchecked");
  NetworkConfig config;
  config.slaves.resize(3);
  const auto replayed = replay_run(*reader, config);
  ASSERT_TRUE(replayed);
  EXPECT_TRUE(replayed->only_words);
  EXPECT_TRUE(reader->verify());
}

/// Where the file is taken away, the recording says so instead of writing to nowhere.
TEST_F(RecordingFile, EndsWhenTheFileIsGone) {
  std::filesystem::create_directory(path("folder"));
  auto recorder = start({.by_clock = false}, "folder/run.slrec");
  test::MadeSamples made(3);
  recorder->add(made.next(2000));
  std::filesystem::remove_all(path("folder"));
  for (int i = 0; i < 5; ++i) recorder->add(made.next(2000));
  const auto status = recorder->finish();
  EXPECT_FALSE(status);
  EXPECT_EQ(stops_, 1);
  ASSERT_TRUE(stop_.error);
  EXPECT_EQ(stop_.error->code, ErrorCode::kFileNotWritable);
}

/// Killed, it has what was found up to the last commit.
TEST_F(RecordingFile, FindingsAreCommittedWhileTheRunGoesOn) {
  auto recorder = start({.commit_every = 20 * kMillisecond});
  test::MadeSamples made(3);
  const std::vector<Finding> findings{Finding{all_finding_words().front().code, Severity::kError, Place(2)}};
  recorder->tell({{"old", "note", -1, "what it meant before"}});
  recorder->add(made.next(100));
  recorder->tell(recorded(findings));
  recorder->add(made.next(100));
  for (int i = 0; i < 500; ++i) {
    auto reader = RecordingReader::open(path());
    const auto info = reader ? reader->info() : Result<RecordingInfo>(tl::unexpected(reader.error()));
    if (info && info->findings == recorded(findings)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->info()->findings, recorded(findings));
  EXPECT_FALSE(reader->info()->ended);
}

TEST_F(RecordingFile, TheSameRunGivesTheSameFile) {
  make("one");
  make("two");
  const auto one = read_whole_file(path("one")), two = read_whole_file(path("two"));
  ASSERT_TRUE(one && two);
  EXPECT_TRUE(*one == *two);
}

TEST_F(RecordingFile, ReplacesNothing) {
  make();
  const auto again = Recorder::start(path(), machine(), {}, {});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::kFileNotWritable);
  EXPECT_THAT(again.error().detail.text(), HasSubstr("already"));
  EXPECT_TRUE(RecordingReader::open(path())->verify());
}

TEST_F(RecordingFile, EndsAtItsLengthAndSize) {
  for (const bool by_size : {false, true}) {
    Recorder::Options options;
    (by_size ? options.most_bytes : options.keep_free_bytes) = by_size ? 1'000'000 : 0;
    if (!by_size) options.longest = 2 * kSecond;
    const std::string name = by_size ? "size" : "length";
    auto recorder = start(options, name);
    test::MadeSamples made(3);
    stops_ = 0;
    for (int i = 0; i < 600; ++i) recorder->add(made.next(100));
    EXPECT_TRUE(recorder->finish()) << "that was asked for";
    EXPECT_EQ(stops_, 1);
    EXPECT_THAT(stop_.why, HasSubstr(by_size ? "size" : "length"));
    auto reader = RecordingReader::open(path(name));
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info()->ended, stop_.why);
    EXPECT_LT(reader->info()->cycles, by_size ? 30'000U : 3'100U);
    EXPECT_GE(reader->info()->cycles, 1'500U);
    EXPECT_TRUE(reader->verify());
  }
}

TEST_F(RecordingFile, StopsWithAMessageBeforeTheDiskIsFull) {
  Recorder::Options options;
  options.keep_free_bytes = UINT64_MAX;
  auto recorder = start(options);
  test::MadeSamples made(3);
  for (int i = 0; i < 30; ++i) recorder->add(made.next(100));
  const auto status = recorder->finish();
  ASSERT_FALSE(status);
  EXPECT_EQ(stops_, 1);
  ASSERT_TRUE(stop_.error);
  EXPECT_THAT(stop_.error->detail.text(), HasSubstr("left on the disk"));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->verify());
  EXPECT_GT(reader->info()->cycles, 0U);
}

/// A file that may not grow any more, as on a full disk: what was committed stays.
TEST_F(RecordingFile, SurvivesADiskThatIsFull) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{400'000, 400'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    auto recorder = Recorder::start(path(), machine(), {}, {});
    if (!recorder) ::_exit(2);
    test::MadeSamples made(3);
    for (int i = 0; i < 4000; ++i) (*recorder)->add(made.next(100));
    ::_exit((*recorder)->finish() ? 3 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->verify());
}

/// What could not be begun is no recording: nobody finds one that holds nothing.
TEST_F(RecordingFile, OfWhatCannotBeBegunNothingIsLeft) {
  for (const rlim_t room : {rlim_t{4'096}, rlim_t{40'000}, rlim_t{120'000}, rlim_t{200'000}}) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{room, room};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::_exit(RecordingWriter::create(path(), machine()) ? 3 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 0) {
      EXPECT_FALSE(std::filesystem::exists(path())) << room;
      EXPECT_FALSE(std::filesystem::exists(path() + "-wal")) << room;
    }
    remove_database(path());
  }
}

/// Killed at any moment it is whole up to the last commit, and what it holds is what was recorded.
TEST_F(RecordingFile, KilledAtAnyMomentItIsWhole) {
  Random random(2026);
  constexpr int kRounds = 30;
  int with_samples = 0;
  // A busy machine commits less in the same time: then there are more rounds.
  for (int round = 0; round < kRounds || with_samples <= kRounds / 2; ++round) {
    ASSERT_LT(round, 10 * kRounds);
    const auto name = "killed" + std::to_string(round);
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      auto recorder = Recorder::start(path(name), machine(), {.commit_every = 20 * kMillisecond}, {});
      if (!recorder) ::_exit(2);
      test::MadeSamples made(static_cast<std::uint64_t>(round));
      for (char i = 0;; ++i) {
        const auto samples = made.next(20);
        (*recorder)->add(samples);
        (*recorder)->add(snapshot(samples.back().send_time, 1));
        (void)!::write(told[1], &i, 1);
        std::this_thread::sleep_for(std::chrono::microseconds(300));
      }
    }
    ::close(told[1]);
    char first = 0;
    (void)!::read(told[0], &first, 1);
    std::this_thread::sleep_for(
        std::chrono::microseconds(random.next() % (60'000U * (1U + static_cast<unsigned>(round / kRounds)))));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(told[0]);
    ASSERT_TRUE(WIFSIGNALED(status));
    auto reader = RecordingReader::open(path(name));
    ASSERT_TRUE(reader) << reader.error().detail.text();
    const auto verified = reader->verify();
    ASSERT_TRUE(verified) << verified.error().detail.text();
    const auto info = reader->info();
    ASSERT_TRUE(info);
    EXPECT_FALSE(info->ended) << "cut short, and says so";
    with_samples += info->cycles > 0 ? 1 : 0;
    test::MadeSamples made(static_cast<std::uint64_t>(round));
    std::vector<CycleSample> expected;
    while (expected.size() < info->cycles) {
      const auto more = made.next(20);
      expected.insert(expected.end(), more.begin(), more.end());
    }
    expected.resize(info->cycles);
    EXPECT_TRUE(read_csv(*reader) == csv(expected)) << "round " << round;
  }
}

TEST_F(RecordingFile, WhatIsNoneIsRefusedWithItsReason) {
  EXPECT_EQ(RecordingReader::open(path("none")).error().code, ErrorCode::kFileNotFound);
  EXPECT_EQ(RecordingReader::open(folder_.path().string()).error().code, ErrorCode::kNotThatKindOfFile);
  ASSERT_TRUE(write_whole_file(path("text"), "cycle,send_time_ns\n1,2\n"));
  EXPECT_EQ(RecordingReader::open(path("text")).error().code, ErrorCode::kNotThatKindOfFile);
  ASSERT_TRUE(write_whole_file(path("empty"), ""));
  EXPECT_EQ(RecordingReader::open(path("empty")).error().code, ErrorCode::kNotThatKindOfFile);
  ASSERT_TRUE(SqlDatabase::open(path("photos"))->execute("CREATE TABLE photos(name)"));
  const auto foreign = RecordingReader::open(path("photos"));
  ASSERT_FALSE(foreign);
  EXPECT_THAT(foreign.error().detail.text(), HasSubstr("another program"));
  make();
  ASSERT_TRUE(SqlDatabase::open(path())->execute("PRAGMA user_version=7"));
  const auto future = RecordingReader::open(path());
  ASSERT_FALSE(future);
  EXPECT_EQ(future.error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_THAT(future.error().detail.text(), HasSubstr("version 7"));
}

TEST_F(RecordingFile, CutOffItIsExplained) {
  make();
  const auto whole = *read_whole_file(path());
  for (const std::size_t size : {whole.size() / 2, whole.size() - 1000, std::size_t{5000}, std::size_t{100}}) {
    ASSERT_TRUE(write_whole_file(path("cut"), std::string_view(whole).substr(0, size)));
    auto reader = RecordingReader::open(path("cut"));
    const auto verified = reader ? reader->verify() : Result<std::uint64_t>(tl::unexpected(reader.error()));
    ASSERT_FALSE(verified) << size;
    EXPECT_EQ(verified.error().file, path("cut"));
    EXPECT_THAT(verified.error().detail.text(), testing::AnyOf(HasSubstr("damaged"), HasSubstr("cut off"))) << size;
  }
}

TEST_F(RecordingFile, RowsThatContradictEachOtherAreFound) {
  for (const char* const harm :
       {"UPDATE block SET cycles = cycles + 1 WHERE number = 0", "UPDATE block SET first_cycle = 9 WHERE number = 0",
        "UPDATE block SET cycles = -5", "UPDATE block SET cycles = 1000000000", "DELETE FROM block WHERE number = 0",
        "UPDATE data SET cells = substr(cells, 1, length(cells) - 1) WHERE codec = 2", "UPDATE data SET codec = 9",
        "UPDATE data SET count = 1000000000000", "DELETE FROM data WHERE codec = 1", "UPDATE summary SET max = max + 1",
        "DELETE FROM summary", "UPDATE slave SET position = 77 WHERE position = 1", "DELETE FROM limits",
        "DROP TABLE event", "UPDATE limits SET value = 0"}) {
    std::filesystem::remove(path());
    make();
    ASSERT_TRUE(SqlDatabase::open(path())->execute(harm)) << harm;
    auto reader = RecordingReader::open(path());
    ASSERT_TRUE(reader) << harm;
    const auto verified = reader->verify();
    EXPECT_FALSE(verified) << harm;
  }
}

/// Whatever happens to its bytes, it is read or refused, and nothing worse.
TEST_F(RecordingFile, DamagedBytesAreReadOrRefused) {
  make();
  const auto whole = *read_whole_file(path());
  EXPECT_TRUE(rc::check([&] {
    auto harmed = whole;
    const auto hits = *rc::gen::inRange(1, 30);
    for (int i = 0; i < hits; ++i)
      harmed[static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(harmed.size())))] =
          static_cast<char>(*rc::gen::inRange(0, 256));
    RC_ASSERT(write_whole_file(path("harmed"), harmed).has_value());
    if (auto reader = RecordingReader::open(path("harmed"))) {
      (void)reader->info();
      (void)reader->verify();
      (void)reader->overview(Signal::kDcmError);
      (void)reader->points(Signal::kSm2Missed, 2);
    }
  }));
}

}  // namespace
}  // namespace syncline
