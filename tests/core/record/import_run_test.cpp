// SPDX-License-Identifier: Apache-2.0
#include "record/import_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"
#include "trace/csv.h"
#include "trace/dcm_log.h"
#include "trace/outages.h"
#include "trace/range_figures.h"

namespace syncline {
namespace {

using testing::HasSubstr;

constexpr Nanoseconds kLogBegin = 830'000'000 * kSecond;

/// Of a machine that comes in sync after 100 of 1000 cycles.
std::vector<CycleSample> logged_cycles() {
  std::vector<CycleSample> samples(1000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto& s = samples[i];
    s.cycle = i + 5;
    s.send_time = kLogBegin + static_cast<Nanoseconds>(i) * kMillisecond + static_cast<Nanoseconds>(i % 3) * 1000;
    s.reference_time = s.send_time + 333;
    s.flags = CycleSample::kReferenceValid | CycleSample::kDcmActive | CycleSample::kDeviationValid |
              CycleSample::kFollowersRead;
    s.dcm_error_ns = static_cast<std::int32_t>(i % 50) - 20;
    s.dcm_error_filtered_ns = s.dcm_error_ns / 2;
    s.drift_ppm = 12.5F;
    s.dcm_adjust_ns = -3;
    s.deviation_ored_ns = s.deviation_ns = 15 + static_cast<std::uint32_t>(i % 9);
    s.wkc_expected = s.wkc_received = 9;
    s.round_trip_ns = 30'000;
    s.master_state = 8;
    s.slaves_sync = s.master_sync = i < 100 ? SyncState::kBusy : SyncState::kInSync;
  }
  return samples;
}

std::string dcm_log_of(const std::vector<CycleSample>& samples) {
  DcmLog log(500'000, kMillisecond);
  auto text = dcm_log_header();
  for (const auto& sample : samples) {
    if (const auto row = log.row(sample)) append_dcm_log(text, *row);
  }
  return text;
}

TEST(ImportRun, ALogOfTheMasterSynchronisationIsWhatItHolds) {
  const auto samples = logged_cycles();
  const auto run = import_table(dcm_log_of(samples), "run.dcm.csv");
  ASSERT_TRUE(run.has_value());
  ASSERT_EQ(run->samples.size(), samples.size());
  EXPECT_EQ(run->about.limits.cycle_time, kMillisecond);
  EXPECT_EQ(run->samples[7].dcm_error_ns, samples[7].dcm_error_ns) << "with our sign";
  EXPECT_EQ(run->samples[7].drift_ppm, 12.5F);
  EXPECT_EQ(run->samples[7].reference_time, samples[7].reference_time);
  const auto replay = replayed(*run);
  const auto& record = *replay.record;
  EXPECT_EQ(record.samples().series(Signal::kDcmError).count(0, INT64_MAX), 1000U);
  EXPECT_EQ(record.samples().value(Signal::kDeviation, record.samples().last_time())->value, 15.0F + 999 % 9);
  // Armed when both came in sync, as the run itself was.
  ASSERT_TRUE(record.overview().armed);
  EXPECT_EQ(*record.overview().armed - record.overview().begin, 100 * kMillisecond + 1000);
  EXPECT_EQ(record.overview().dcm_error.statistics.count(), 900U);
  EXPECT_EQ(record.overview().slaves.state, SyncState::kInSync);
  EXPECT_TRUE(record.findings().empty());
}

/// What nobody knows has no value, and is not zero.
TEST(ImportRun, WhatALogDoesNotHoldIsUnknown) {
  const auto run = import_table(dcm_log_of(logged_cycles()), "run.dcm.csv");
  ASSERT_TRUE(run.has_value());
  RangeFigures figures(0, 0, INT64_MAX, false);
  figures.add(run->samples);
  for (const auto& [signal, figure, lasting] : figures.signals()) {
    const bool held = signal == Signal::kDcmError || signal == Signal::kDcmErrorFiltered || signal == Signal::kDrift ||
                      signal == Signal::kDcmAdjust || signal == Signal::kDeviation ||
                      signal == Signal::kDeviationOred || signal == Signal::kNetworkToSlave ||
                      signal == Signal::kMasterToNetwork || signal == Signal::kDcmOutputSum ||
                      signal == Signal::kDcmOutputTotal;
    EXPECT_EQ(figure.statistics.count(), held ? 1000U : 0U) << info(signal).key;
  }
  const auto replay = replayed(*run);
  const auto& store = replay.record->samples();
  EXPECT_TRUE(outages(store, store.first_time(), store.last_time(), kMillisecond).empty()) << "nor is it an outage";
  for (const auto signal : {Signal::kWkcExpected, Signal::kWkcReceived, Signal::kFramesLost, Signal::kSkippedCycles,
                            Signal::kMasterState}) {
    EXPECT_FALSE(replay.record->samples().value(signal, run->samples.back().send_time)) << info(signal).key;
  }
}

TEST(ImportRun, OtherTabulatorsOrdersAndFewerColumnsDo) {
  const auto run = import_table("CtlErr [ns]\tTime[ms]\n-5\t0\n7\t0.25\n9\t0.5\n11\t1.25\n", "log.csv");
  ASSERT_TRUE(run.has_value());
  ASSERT_EQ(run->samples.size(), 4U);
  EXPECT_EQ(run->about.limits.cycle_time, 250'000);
  EXPECT_EQ(run->samples[0].dcm_error_ns, 5);
  EXPECT_EQ(run->samples[2].cycle, 2U);
  EXPECT_EQ(run->samples[3].cycle, 5U) << "two are missing";
  EXPECT_EQ(run->samples[3].slaves_sync, SyncState::kUnknown);
  EXPECT_FALSE(info(Signal::kReferenceTime).of_cycle(run->samples[0]));
  const auto replay = replayed(*run);
  EXPECT_EQ(replay.info.missing_cycles, 2U);
  EXPECT_EQ(replay.record->overview().dcm_error.statistics.count(), 4U) << "without a verdict all counts";
  EXPECT_EQ(replay.record->overview().slaves.state, SyncState::kUnknown);
}

TEST(ImportRun, WhatWasInSyncAndIsNoMoreIsOutOfSync) {
  const auto run = import_table("Time[ms];CtlErr [ns];DCMInSync;DCInSync\n0;1;0;0\n1;1;1;1\n2;1;0;1\n", "log.csv");
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->samples[0].master_sync, SyncState::kBusy);
  EXPECT_EQ(run->samples[1].master_sync, SyncState::kInSync);
  EXPECT_EQ(run->samples[2].master_sync, SyncState::kOutOfSync);
  EXPECT_EQ(run->samples[2].slaves_sync, SyncState::kInSync);
  EXPECT_EQ(replayed(*run).record->overview().master.times_lost, 1U);
}

/// Cycles of less than the host's column shows are told apart by the bus's time.
TEST(ImportRun, TheBusTellsCyclesApartWhereTheHostDoesNot) {
  const std::string rows =
      "Time[ms];BusTime [ns];CtlErr [ns]\n0;830000000000000000;1\n0;830000000000250000;2\n"
      "0;830000000000500000;3\n1;830000000000750000;4\n";
  const auto run = import_table(rows, "log.csv");
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->about.limits.cycle_time, 250'000);
  EXPECT_EQ(run->samples.back().send_time, 830000000000750000);
  const auto none = import_table("Time[ms];CtlErr [ns]\n0;1\n0;1\n", "log.csv");
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::kBadValue);
}

std::string table_of(const std::vector<CycleSample>& samples) {
  auto text = sample_csv_header();
  append_sample_csv(text, samples);
  return text;
}

/// Every column of the table, whatever happened: the table of the import is the table.
TEST(ImportRun, ATableOfARunIsReadWhole) {
  auto samples = test::MadeSamples(7).next(5000);
  for (auto& sample : samples) {
    if (sample.slaves_sync != SyncState::kInSync) sample.slaves_sync = SyncState::kOutOfSync;
  }
  const auto table = table_of(samples);
  const auto run = import_table(table, "run.csv");
  ASSERT_TRUE(run.has_value()) << run.error().detail.text();
  auto again = table_of(run->samples);
  // Without a clock nobody can say that a table's own zeros are known ones.
  const auto without_derived = [](const std::string& text) {
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string cell;
      for (int column = 0; std::getline(cells, cell, ','); ++column) {
        if (column != 19 && column != 20) out += cell + ',';
      }
      out += '\n';
    }
    return out;
  };
  EXPECT_TRUE(without_derived(again) == without_derived(table));
  EXPECT_TRUE(table.substr(0, table.find('\n')).find("NetworkToSubDeviceClkDiff_ns") != std::string::npos);
  const auto replay = replayed(*run);
  EXPECT_EQ(replay.info.missing_cycles, samples.back().cycle - samples.front().cycle + 1 - samples.size());
  EXPECT_GT(run->about.slaves.size(), 0U);
}

TEST(ImportRun, AnImportIsARecordingLikeAnother) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("import.slrec");
  const auto run = import_table(dcm_log_of(logged_cycles()), "run.dcm.csv", {127, 4000});
  ASSERT_TRUE(run.has_value());
  ASSERT_TRUE(write_recording(*run, path).has_value());
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value());
  EXPECT_TRUE(reader->verify().has_value());
  const auto info = reader->info();
  ASSERT_TRUE(info.has_value());
  EXPECT_EQ(info->cycles, 1000U);
  EXPECT_EQ(info->about.link, "run.dcm.csv");
  EXPECT_EQ(info->about.limits, (RunLimits{kMillisecond, 127, 4000}));
  const auto opened = replay_run(*reader, NetworkConfig{});
  ASSERT_TRUE(opened.has_value());
  const auto direct = replayed(*run);
  const auto& is = opened->record->overview();
  const auto& was = direct.record->overview();
  EXPECT_EQ(is.armed, was.armed);
  EXPECT_EQ(is.dcm_error.statistics.rms(), was.dcm_error.statistics.rms());
  EXPECT_EQ(is.dcm_error.statistics.count(), was.dcm_error.statistics.count());
  EXPECT_EQ(is.deviation.margin(127), was.deviation.margin(127));
  EXPECT_TRUE(opened->record->samples().series(Signal::kRoundTrip).extent(0, INT64_MAX) == std::nullopt);
  EXPECT_FALSE(write_recording(*run, path).has_value()) << "it replaces nothing";
}

/// Half of an import is none: whoever finds the file would take it for the whole.
TEST(ImportRun, OnAFullDiskNothingIsLeft) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("import.slrec");
  const auto run = import_table(dcm_log_of(logged_cycles()), "run.dcm.csv", {127, 4000});
  ASSERT_TRUE(run);
  // No table fits, then not all samples do.
  for (const rlim_t room : {rlim_t{4'096}, rlim_t{60'000}, rlim_t{90'000}}) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{room, room};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::_exit(write_recording(*run, path) ? 3 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << room << ": " << status;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << room;
  }
}

TEST(ImportRun, SaysWhatIsWrong) {
  const auto code = [](const std::string& text) {
    const auto run = import_table(text, "x.csv");
    EXPECT_FALSE(run.has_value());
    return run ? ErrorCode::kCancelled : run.error().code;
  };
  EXPECT_EQ(code(""), ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(code("a,b,c\n1,2,3\n"), ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(code("cycle,send_time_ns,lateness_ns\n"), ErrorCode::kBadValue);
  EXPECT_EQ(code("Time[ms];CtlErr [ns]\n"), ErrorCode::kBadValue);
  EXPECT_EQ(code("Time[ms];CtlErr [ns]\n0;soon\n"), ErrorCode::kMalformedData);
  const auto back = import_table("cycle,send_time_ns,lateness_ns\n4,1000,2\n4,2000,2\n5,3000,1\n", "x.csv");
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().line, 3);
  const auto never = import_table("cycle,send_time_ns,lateness_ns\n4,1000,2\n5,9223372036854775807,2\n", "x.csv");
  ASSERT_FALSE(never);
  EXPECT_EQ(never.error().line, 3);
  const auto bad = import_table("cycle,send_time_ns,lateness_ns\n0,1000,2\n1,2000,late\n", "x.csv");
  ASSERT_FALSE(bad.has_value());
  EXPECT_EQ(bad.error().line, 3);
  EXPECT_THAT(bad.error().detail.text(), HasSubstr("late"));
  EXPECT_FALSE(table_kind(std::string("\0\1\2", 3)));
}

/// Cut at every byte: lines that are whole are all there, and what is not is told with its number.
TEST(ImportRun, CutAnywhereNothingIsLostSilently) {
  auto cycles = logged_cycles();
  cycles.resize(20);
  for (const auto& table : {dcm_log_of(cycles), table_of(cycles)}) {
    const auto whole = import_table(table, "x.csv");
    ASSERT_TRUE(whole.has_value());
    EXPECT_TRUE(whole->findings.empty());
    const auto begin = table.find('\n') + 1;
    for (auto size = table.find('\n', begin) + 1; size < table.size(); ++size) {
      const auto text = table.substr(0, size);
      const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
      const auto run = import_table(text, "x.csv");
      ASSERT_TRUE(run.has_value()) << size;
      const bool ended = text.ends_with('\n');
      ASSERT_EQ(run->findings.empty(), ended) << size;
      const auto kept = run->samples.size() - (lines - 1);
      EXPECT_LE(kept, ended ? 0U : 1U) << size;
      if (ended) continue;
      const auto told = describe(run->findings[0]);
      EXPECT_THAT(told, HasSubstr("ine " + std::to_string(lines + 1))) << size;
      EXPECT_EQ(run->findings[0].severity, kept == 1 ? Severity::kNote : Severity::kWarning) << size;
    }
  }
}

TEST(ImportRun, ALastLineWithoutAnEndIsKeptWhereItIsComplete) {
  const auto run = import_table("Time[ms];CtlErr [ns]\n0;1\n1;2\n2;3", "log.csv");
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->samples.size(), 3U);
  ASSERT_EQ(run->findings.size(), 1U);
  EXPECT_EQ(run->findings[0].severity, Severity::kNote);
  const auto replay = replayed(*run);
  EXPECT_EQ(replay.record->findings().size(), 1U);
  EXPECT_EQ(replay.info.findings.size(), 1U);
}

TEST(ImportRun, ALineThatLacksCellsIsAnErrorAndNoZeros) {
  for (const std::string text : {"Time[ms];CtlErr [ns];DCMInSync\n0;1;1\n1\n2;3;1\n",
                                 "cycle,send_time_ns,lateness_ns\n0,1000,2\n1\n2,3000,4\n"}) {
    const auto run = import_table(text, "x.csv");
    ASSERT_FALSE(run.has_value()) << text;
    EXPECT_EQ(run.error().line, 3) << text;
    EXPECT_THAT(run.error().detail.text(), HasSubstr("it has only 1")) << text;
  }
}

TEST(ImportRun, TheMarkOfUtf8IsNoPartOfTheFirstColumn) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string text :
       {"Time[ms];CtlErr [ns]\n0;1\n1;2\n", "cycle,send_time_ns,lateness_ns\n7,1000,2\n8,2000,4\n"}) {
    const auto run = import_table(mark + text, "x.csv");
    ASSERT_TRUE(run.has_value()) << text;
    EXPECT_EQ(run->samples[0].cycle, import_table(text, "x.csv")->samples[0].cycle);
    EXPECT_EQ(table_kind(mark + text), table_kind(text));
  }
}

}  // namespace
}  // namespace syncline
