// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "sqlite/sqlite_database.h"
#include "tests/app/cli_runner.h"
#include "trace/csv.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliRecord : public testing::Test {
 protected:
  CliRecord() {
    const auto create =
        cli_run({"project", "create", project, "--scan", demo(), "--cycle", "1000", "--sync-window", "on"});
    EXPECT_EQ(create.code, cli::kDone) << create.err;
  }
  /// A run of the demonstration machine that is recorded.
  CliRun run(const std::vector<std::string>& more = {}, const std::string& record = "run.slrec") {
    std::vector<std::string> arguments{"run",   project, "--link",   demo("?virtual&seed=5"),
                                       "--for", "6s",    "--record", folder.file(record)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli_run(arguments);
  }

  TemporaryFolder folder;
  std::string project = folder.file("m.syncline"), recording = folder.file("run.slrec");
};

TEST_F(CliRecord, ExportsTheTableThatTheRunWrites) {
  const auto csv = folder.file("run.csv"), exported = folder.file("exported.csv");
  const auto recorded = run({"--csv", csv});
  ASSERT_EQ(recorded.code, cli::kDone) << recorded.err;
  const auto copied = cli_run({"record", "export", recording, exported});
  ASSERT_EQ(copied.code, cli::kDone) << copied.err;
  const auto table = read_text(csv);
  EXPECT_GT(table.size(), 100'000U);
  EXPECT_TRUE(table == read_text(exported)) << "byte for byte";
}

TEST_F(CliRecord, HoldsTheVariablesThatAreWatched) {
  const auto csv = folder.file("run.csv"), exported = folder.file("exported.csv");
  const auto recorded = run({"--csv", csv, "--watch", "3.Position actual value", "--watch", "3.statusword"});
  ASSERT_EQ(recorded.code, cli::kDone) << recorded.err;
  const auto table = read_text(csv);
  const auto head = table.substr(0, table.find('\n'));
  EXPECT_THAT(head, HasSubstr("Position actual value\",\""));
  EXPECT_TRUE(head.ends_with("Statusword\"")) << head;
  const auto last = table.substr(table.rfind('\n', table.size() - 2) + 1);
  EXPECT_EQ(std::ranges::count(last, ','), std::ranges::count(sample_csv_header(), ',') + 2) << last;
  EXPECT_NE(last[last.rfind(',') + 1], '\n') << "it has a value in OP";
  ASSERT_EQ(cli_run({"record", "export", recording, exported}).code, cli::kDone);
  EXPECT_TRUE(table == read_text(exported)) << "byte for byte";
  const auto json = cli_run({"record", "info", recording, "--json"}).json();
  ASSERT_EQ(json["variables"].size(), 2U);
  EXPECT_EQ(json["variables"][0]["slave"], 3);
  EXPECT_EQ(json["variables"][0]["type"], "DINT");
  EXPECT_EQ(json["variables"][0]["direction"], "input");
  EXPECT_EQ(cli_run({"record", "verify", recording}).code, cli::kDone);
}

TEST_F(CliRecord, RefusesVariablesThatAreNotThere) {
  const auto refused = run({"--watch", "3.Nothing of the kind"});
  EXPECT_EQ(refused.code, cli::kUsage) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--watch 3.Nothing of the kind"));
  EXPECT_FALSE(std::filesystem::exists(recording));
}

TEST_F(CliRecord, TellsWhatWasRun) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto told = cli_run({"record", "info", recording, "--json"});
  ASSERT_EQ(told.code, cli::kDone) << told.err;
  const auto json = told.json();
  EXPECT_EQ(json["ended"], "end of the run");
  EXPECT_EQ(json["missing_cycles"], 0);
  EXPECT_GT(json["cycles"], 4'000);
  EXPECT_EQ(json["cycle_time_us"], 1000);
  EXPECT_GT(json["limits"]["deviation_ns"], 0);
  EXPECT_GT(json["slaves"].size(), 3U);
  EXPECT_FALSE(json["events"].empty());
  const auto copy = folder.file("copy.syncline");
  ASSERT_EQ(cli_run({"record", "export", recording, copy, "--document", "project"}).code, cli::kDone);
  EXPECT_EQ(read_text(copy), read_text(project));
  const auto eni = folder.file("copy.xml"), exported = folder.file("m.eni.xml");
  ASSERT_EQ(cli_run({"record", "export", recording, eni, "--document", "configuration"}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", exported}).code, cli::kDone);
  EXPECT_EQ(read_text(eni), read_text(exported));
  EXPECT_EQ(cli_run({"record", "export", recording, copy, "--document", "poem"}).code, cli::kUsage);
  EXPECT_THAT(cli_run({"record", "info", recording}).out, HasSubstr("cycles of 1000 us"));
}

/// Each signal with its rate, the clock by which it is measured and how far that may be off.
TEST_F(CliRecord, TellsHowFarToBelieveASignal) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto json = cli_run({"record", "info", recording, "--json"}).json();
  const auto row = [&json](const std::string& key, bool of_slave) {
    for (const auto& one : json["signals"]) {
      if (one["key"] == key && one["slave"].is_null() != of_slave) return one;
    }
    return std::decay_t<decltype(json)>();
  };
  const auto error = row("dcm_error_ns", false);
  ASSERT_TRUE(error.is_object());
  EXPECT_EQ(error["clock"], "both");
  EXPECT_EQ(error["unit"], "ns");
  EXPECT_NEAR(error["rate_hz"].get<double>(), 1000, 20);
  EXPECT_GT(error["doubt_ns"].get<int>(), 10);
  const auto deviation = row("deviation_ns", true);
  ASSERT_TRUE(deviation.is_object());
  EXPECT_EQ(deviation["clock"], "slaves");
  EXPECT_EQ(deviation["doubt_ns"], 10);
  EXPECT_NEAR(deviation["rate_hz"].get<double>(), 200, 20) << "five clocks, one a cycle";
  EXPECT_TRUE(json["stamps"]["by"].contains("software")) << json["stamps"].dump();
  EXPECT_TRUE(json["triggers"].empty());
  const auto text = cli_run({"record", "info", recording}).out;
  EXPECT_THAT(text, HasSubstr("signal: dcm_error_ns: "));
  EXPECT_THAT(text, HasSubstr("by the clocks of the slaves, within 10 ns"));
  EXPECT_THAT(text, HasSubstr(" by software"));
}

TEST_F(CliRecord, PlotsWithoutAWindow) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto svg = folder.file("run.svg");
  const auto usual = cli_run({"record", "plot", recording, svg});
  ASSERT_EQ(usual.code, cli::kDone) << usual.err;
  const auto text = read_text(svg);
  EXPECT_THAT(text, HasSubstr("run.slrec: "));
  EXPECT_THAT(text, HasSubstr("DCM error"));
  EXPECT_THAT(text, HasSubstr("stroke-dasharray")) << "its limit";
  const auto named = cli_run({"record", "plot", recording, svg, "--signal", "round_trip_ns", "--signal",
                              "deviation_ns@3", "--from", "3s", "--to", "4s", "--size", "640x400"});
  ASSERT_EQ(named.code, cli::kDone) << named.err;
  const auto part = read_text(svg);
  EXPECT_THAT(part, HasSubstr("width=\"640\" height=\"400\""));
  EXPECT_THAT(part, HasSubstr("Round trip"));
  EXPECT_THAT(part, HasSubstr(">3.5 s<"));
  for (const auto& [arguments, words] :
       {std::pair<std::vector<std::string>, std::string>{{"--signal", "speed"}, "speed"},
        {{"--signal", "deviation_ns@99"}, "deviation_ns@99"},
        {{"--signal", "al_status@1"}, "a state"},
        {{"--size", "640"}, "--size 640"},
        {{"--from", "1h"}, "the range"}}) {
    std::vector<std::string> all{"record", "plot", recording, svg};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto refused = cli_run(all);
    EXPECT_EQ(refused.code, cli::kUsage) << words;
    EXPECT_THAT(refused.err, HasSubstr(words));
  }
  EXPECT_EQ(read_text(svg), part) << "what was refused has left it";
  EXPECT_EQ(cli_run({"record", "plot", recording, folder.file("run.png")}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"record", "plot", recording, recording + ".svg/x.svg"}).code, cli::kFailed);
}

TEST_F(CliRecord, ExportsARange) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto all = folder.file("all.csv"), part = folder.file("part.csv");
  ASSERT_EQ(cli_run({"record", "export", recording, all}).code, cli::kDone);
  const auto exported = cli_run({"record", "export", recording, part, "--from", "1s", "--to", "1500ms"});
  ASSERT_EQ(exported.code, cli::kDone) << exported.err;
  const auto whole = read_text(all), table = read_text(part);
  EXPECT_NEAR(static_cast<double>(std::count(table.begin(), table.end(), '\n')), 1 + 500, 1) << "half a second";
  const auto lines = table.substr(table.find('\n') + 1);
  EXPECT_THAT(whole, HasSubstr(lines));
  EXPECT_EQ(table.substr(0, table.find('\n')), whole.substr(0, whole.find('\n')));
  const auto empty = cli_run({"record", "export", recording, folder.file("none.csv"), "--from", "1h"});
  EXPECT_EQ(empty.code, cli::kUsage);
  EXPECT_THAT(empty.err, HasSubstr("it holds nothing of the recording"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("none.csv")));
  EXPECT_EQ(cli_run({"record", "export", recording, part, "--from", "2s", "--to", "1s"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"record", "export", recording, part, "--from", "soon"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"record", "export", recording, part, "--from", "1s", "--document", "project"}).code, cli::kUsage);
}

/// The table of a range says the same as the figures of it.
TEST_F(CliRecord, FiguresAreThoseOfItsCycles) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto part = folder.file("part.csv");
  ASSERT_EQ(cli_run({"record", "export", recording, part, "--from", "3s", "--to", "4s"}).code, cli::kDone);
  std::istringstream lines(read_text(part));
  std::string line;
  std::getline(lines, line);
  double sum = 0, largest = 0;
  int count = 0;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int column = 0; column < 6; ++column) std::getline(cells, cell, ',');  // dcm_error_ns
    if (cell.empty()) continue;
    ++count;
    sum += std::stod(cell);
    if (std::abs(std::stod(cell)) > std::abs(largest)) largest = std::stod(cell);
  }
  ASSERT_GT(count, 900);
  const auto told =
      cli_run({"record", "figures", recording, "--from", "3s", "--to", "4s", "--signal", "dcm_error_ns", "--json"});
  ASSERT_EQ(told.code, cli::kDone) << told.err;
  const auto json = told.json();
  EXPECT_EQ(json["cycles"], 1000);
  ASSERT_EQ(json["signals"].size(), 1U);
  const auto& error = json["signals"][0];
  EXPECT_EQ(error["key"], "dcm_error_ns");
  EXPECT_EQ(error["unit"], "ns");
  EXPECT_EQ(error["count"], count);
  EXPECT_NEAR(error["mean"], sum / count, 0.001);
  ASSERT_EQ(error["mean_95"].size(), 2U);
  EXPECT_LT(error["mean_95"][0], error["mean"]);
  EXPECT_GT(error["mean_95"][1], error["mean"]);
  EXPECT_EQ(error["max"], largest);
  EXPECT_GE(error["max_s"], 3.0);
  EXPECT_LT(error["max_s"], 4.0);
  EXPECT_GT(error["limit"], 0);
  EXPECT_TRUE(error["margin"].is_null()) << "single late cycles are borne: the filtered error is judged";
  EXPECT_EQ(json["slaves"].size(), cli_run({"record", "info", recording, "--json"}).json()["slaves"].size());
}

/// The table of a run makes the recording of which it is the table; of the log, its figures are those of the run.
TEST_F(CliRecord, ImportsWhatIsNoRecording) {
  const auto csv = folder.file("run.csv"), log = folder.file("run.dcm.csv");
  ASSERT_EQ(run({"--csv", csv, "--dcm-log", log}).code, cli::kDone);
  const auto table = folder.file("table.slrec"), again = folder.file("again.csv");
  const auto imported = cli_run({"record", "import", csv, table});
  ASSERT_EQ(imported.code, cli::kDone) << imported.err;
  EXPECT_THAT(imported.out, HasSubstr("cycles of 1000 us"));
  ASSERT_EQ(cli_run({"record", "export", table, again}).code, cli::kDone);
  EXPECT_TRUE(read_text(csv) == read_text(again)) << "byte for byte";
  EXPECT_EQ(cli_run({"record", "verify", table}).code, cli::kDone);
  const auto of_log = folder.file("log.slrec");
  ASSERT_EQ(cli_run({"record", "import", log, of_log, "--dcm-limit-ns", "4000"}).code, cli::kDone);
  // Of a stretch in OP: what counts as settled a log does not know as well as the run.
  const auto figures = [](const std::string& file) {
    return cli_run(
               {"record", "figures", file, "--from", "3s", "--to", "4s", "--signal", "dcm_error_filtered_ns", "--json"})
        .json();
  };
  const auto is = figures(of_log), was = figures(recording);
  EXPECT_EQ(is["sync"]["master"]["state"], "in_sync");
  EXPECT_EQ(is["signals"][0]["limit"], 4000);
  EXPECT_NEAR(is["signals"][0]["max"].get<double>(), was["signals"][0]["max"].get<double>(), 0.5);
  EXPECT_TRUE(is["slaves"].empty());
  EXPECT_TRUE(is["sm2_missed"].is_null()) << "nobody has told";
  const auto all = cli_run({"record", "figures", of_log, "--signal", "round_trip_ns", "--json"}).json();
  EXPECT_EQ(all["signals"][0]["count"], 0);
  EXPECT_TRUE(all["signals"][0]["mean"].is_null());
  const auto other = cli_run({"record", "import", project, folder.file("none.slrec")});
  EXPECT_EQ(other.code, cli::kFailed);
  EXPECT_THAT(other.err, HasSubstr("a log of the master synchronisation"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("none.slrec")));
  EXPECT_EQ(cli_run({"record", "import", csv, table}).code, cli::kFailed) << "it replaces nothing";
  // Which is said before hours are read for it.
  EXPECT_THAT(cli_run({"record", "import", project, table}).err, HasSubstr("a recording replaces nothing"));
}

/// What the capture of a run tells is what the run's own table says.
TEST_F(CliRecord, ImportsACapture) {
  const auto csv = folder.file("run.csv"), capture = folder.file("run.pcapng"), imported = folder.file("capture.slrec"),
             again = folder.file("capture.csv");
  ASSERT_EQ(run({"--csv", csv, "--capture", capture}).code, cli::kDone);
  const auto import = cli_run({"record", "import", capture, imported, "--deviation-limit-ns", "127"});
  ASSERT_EQ(import.code, cli::kDone) << import.err;
  EXPECT_THAT(import.out, HasSubstr("cycles of 1000 us"));
  ASSERT_EQ(cli_run({"record", "export", imported, again}).code, cli::kDone);
  const auto rows = [](const std::string& path) {
    std::map<std::string, std::vector<std::string>> by_time;  // of the send time
    std::istringstream lines(read_text(path));
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells;
      std::istringstream text(line + ',');
      for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
      by_time[cells.at(1)] = cells;
    }
    return by_time;
  };
  const auto was = rows(csv), is = rows(again);
  enum : std::size_t {
    kLateness = 2,
    kRoundTrip = 3,
    kReference = 4,
    kError = 5,
    kOred = 9,
    kExpected = 14,
    kWkc = 15
  };
  std::size_t same = 0;
  for (const auto& [time, cells] : is) {
    const auto own = was.find(time);
    if (own == was.end() || time == "send_time_ns") continue;
    ++same;
    for (const auto column : {kRoundTrip, kReference, kOred}) EXPECT_EQ(cells[column], own->second[column]) << time;
    for (const auto column : {kLateness, kError, kExpected}) EXPECT_EQ(cells[column], "") << "no capture tells";
    // The mailboxes' states are read by a logical command, too, which is no process data.
    EXPECT_EQ(std::stoi(cells[kWkc]), std::stoi(own->second[kWkc]) + 3) << time;
    if (HasFailure()) break;
  }
  EXPECT_GT(same, 4'000U);
  EXPECT_GE(is.size(), was.size()) << "frames go on until the bus is left";
  const auto figures = cli_run({"record", "figures", imported, "--json"}).json();
  EXPECT_TRUE(figures["wkc_errors"].is_null());
  EXPECT_EQ(figures["lost_frames"], 0);
  EXPECT_EQ(figures["sync"]["slaves"]["state"], "unknown");
}

/// As the window's dialog: a part by times since the first frame, or so many frames.
TEST_F(CliRecord, ImportsAPartOfACapture) {
  const auto capture = folder.file("run.pcapng"), csv = folder.file("run.csv");
  ASSERT_EQ(run({"--capture", capture, "--csv", csv}).code, cli::kDone);
  const auto cycles_of = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"record", "import", capture, folder.file(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto import = cli_run(arguments);
    EXPECT_EQ(import.code, cli::kDone) << import.err;
    return cli_run({"record", "info", folder.file(name), "--json"}).json()["cycles"].get<int>();
  };
  const auto all = cycles_of("all.slrec", {}), part = cycles_of("part.slrec", {"--from", "3s", "--to", "3.5s"}),
             rest = cycles_of("rest.slrec", {"--from", "3s"}),
             few = cycles_of("few.slrec", {"--from", "3s", "--frames", "400"});
  EXPECT_NEAR(part, 500, 2) << "1 ms each";
  EXPECT_GT(rest, 2'000);
  EXPECT_LT(rest, all);
  EXPECT_GT(few, 100) << "sent and come back";
  EXPECT_LE(few, 200);
  const auto refused = [&](const std::string& file, const std::vector<std::string>& more, const std::string& why) {
    const auto out = folder.file("none.slrec");
    std::vector<std::string> arguments{"record", "import", file, out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto import = cli_run(arguments);
    EXPECT_NE(import.code, cli::kDone) << why;
    EXPECT_THAT(import.err, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(out)) << why;
  };
  refused(capture, {"--from", "2s", "--to", "2s"}, "it is not behind --from");
  refused(capture, {"--from", "1 day"}, "use a duration such as");
  refused(capture, {"--from", "900s"}, "it holds nothing of the recording");
  refused(capture, {"--frames", "0"}, "--frames");
  refused(csv, {"--from", "2s"}, "are for captures");
  refused(csv, {"--frames", "7"}, "are for captures");
}

TEST_F(CliRecord, ImportsACaptureThatBreaksOffUpToThere) {
  const auto capture = folder.file("run.pcapng"), imported = folder.file("capture.slrec");
  ASSERT_EQ(run({"--capture", capture}).code, cli::kDone);
  std::filesystem::resize_file(capture, std::filesystem::file_size(capture) * 9 / 10 - 3);
  const auto import = cli_run({"record", "import", capture, imported});
  EXPECT_EQ(import.code, cli::kAnswerIsNo) << import.err;
  EXPECT_THAT(import.err, HasSubstr("breaks off behind"));
  EXPECT_THAT(import.out, HasSubstr("cycles of 1000 us"));
  EXPECT_THAT(cli_run({"record", "info", imported}).out, HasSubstr("breaks off behind"))
      << "it stands in the recording";
}

/// What is damaged is no row of the table that is exported, and both say so.
TEST_F(CliRecord, ExportsWhatIsWholeOfADamagedOne) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto before = folder.file("before.csv"), after = folder.file("after.csv");
  ASSERT_EQ(cli_run({"record", "export", recording, before}).code, cli::kDone);
  ASSERT_TRUE(SqlDatabase::open(recording)->execute(
      "UPDATE data SET cells = zeroblob(length(cells)) WHERE id = 2 * 1048576 + 3"));
  const auto exported = cli_run({"record", "export", recording, after});
  EXPECT_EQ(exported.code, cli::kAnswerIsNo);
  EXPECT_THAT(exported.err, testing::AllOf(HasSubstr("2097155"), HasSubstr("table data"), HasSubstr("gap")));
  const auto whole = read_text(before), rest = read_text(after);
  EXPECT_LT(rest.size(), whole.size());
  EXPECT_GT(rest.size(), whole.size() / 2);
  std::istringstream lines(rest);
  for (std::string line; std::getline(lines, line);) ASSERT_NE(whole.find(line + '\n'), std::string::npos) << line;
  const auto verified = cli_run({"record", "verify", recording, "--json"});
  EXPECT_EQ(verified.code, cli::kAnswerIsNo);
  EXPECT_EQ(cli_run({"record", "figures", recording}).code, cli::kAnswerIsNo);
}

TEST_F(CliRecord, FiguresWithoutARangeAreSinceItWasArmed) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto json = cli_run({"record", "figures", recording, "--json"}).json();
  ASSERT_FALSE(json["armed_s"].is_null());
  EXPECT_EQ(json["from_s"], json["armed_s"]);
  EXPECT_EQ(json["sync"]["slaves"]["state"], "in_sync");
  EXPECT_EQ(json["sync"]["master"]["state"], "in_sync");
  EXPECT_TRUE(json["episodes"].empty());
  for (const auto& signal : json["signals"]) EXPECT_GT(signal["count"], 0) << signal["key"];
  const auto words = cli_run({"record", "figures", recording}).out;
  EXPECT_THAT(words, HasSubstr("since it was armed"));
  EXPECT_THAT(words, HasSubstr("slaves: in sync for"));
  EXPECT_THAT(words, HasSubstr("DCM error, filtered"));
  const auto none = cli_run({"record", "figures", recording, "--signal", "poem"});
  EXPECT_EQ(none.code, cli::kUsage);
  EXPECT_THAT(none.err, HasSubstr("dcm_error_ns"));
  EXPECT_EQ(cli_run({"record", "figures", project}).code, cli::kFailed);
}

TEST_F(CliRecord, VerifiesAndExplains) {
  ASSERT_EQ(run().code, cli::kDone);
  EXPECT_EQ(cli_run({"record", "verify", recording}).code, cli::kDone);
  const auto size = std::filesystem::file_size(recording);
  std::filesystem::resize_file(recording, size - size / 20);
  const auto cut = cli_run({"record", "verify", recording});
  EXPECT_EQ(cut.code, cli::kAnswerIsNo);
  EXPECT_THAT(cut.err, AllOf(HasSubstr("The file is cut off: "), Not(HasSubstr(".."))));
  const auto left = cli_run({"record", "info", recording});
  EXPECT_EQ(left.code, cli::kDone) << left.err;
  EXPECT_THAT(left.out + left.err, HasSubstr("is cut off"));
  std::filesystem::resize_file(recording, size / 20);
  for (const auto* const command : {"verify", "info"}) {
    const auto none = cli_run({"record", command, recording});
    EXPECT_EQ(none.code, command == std::string("verify") ? cli::kAnswerIsNo : cli::kFailed) << none.out;
    EXPECT_THAT(none.err, AllOf(HasSubstr("damaged or cut off"), HasSubstr("no whole cycle"), HasSubstr(recording)));
  }
  const auto other = cli_run({"record", "verify", project});
  EXPECT_EQ(other.code, cli::kFailed);
  EXPECT_THAT(other.err, HasSubstr("another kind of file"));
  EXPECT_EQ(cli_run({"record", "info", folder.file("none")}).code, cli::kFailed);
}

TEST_F(CliRecord, EndsAtItsBoundAndTheRunGoesOn) {
  const auto bounded = run({"--record-longest", "2s"});
  EXPECT_EQ(bounded.code, cli::kDone) << bounded.err;
  EXPECT_THAT(bounded.err, HasSubstr("the recording has ended, it has its length of 2 s"));
  const auto told = cli_run({"record", "info", recording, "--json"}).json();
  EXPECT_NEAR(told["duration_s"].get<double>(), 2.0, 1.1);
  const auto again = run();
  EXPECT_EQ(again.code, cli::kFailed) << "it replaces nothing";
  EXPECT_THAT(again.err, HasSubstr("already"));
  const auto full = run({"--record-keep-free-mib", "4000000000"}, "full.slrec");
  EXPECT_EQ(full.code, cli::kFailed);
  EXPECT_THAT(full.err, HasSubstr("left on the disk"));
  EXPECT_EQ(cli_run({"record", "verify", folder.file("full.slrec")}).code, cli::kDone);
}

}  // namespace
}  // namespace syncline::test
