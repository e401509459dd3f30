// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/whole_file.h"
#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"
#include "trace/dcm_log.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

/// Scan, configure and export the demonstration machine; the ENI's path.
std::string export_demo(const TemporaryFolder& folder, const std::string& shift) {
  const auto project = folder.file("m.syncline");
  const auto eni = folder.file("m.eni.xml");
  const auto create = cli_run(
      {"project", "create", project, "--scan", demo(), "--cycle", "1000", "--shift", shift, "--sync-window", "on"});
  EXPECT_EQ(create.code, cli::kDone) << create.err;
  const auto exported = cli_run({"export", project, "-o", eni});
  EXPECT_EQ(exported.code, cli::kDone) << exported.err;
  return eni;
}

TEST(CliRun, ReadsObjectsWhileTheBusRuns) {
  const TemporaryFolder folder;
  const auto file = export_demo(folder, "bus");
  const std::vector<std::string> run{"run", file, "--link", demo(), "--for", "5s", "--json"};
  const auto with = [&](const std::string& object) {
    auto arguments = run;
    arguments.insert(arguments.end(), {"--sdo-read", object});
    return cli_run(arguments);
  };
  const auto read = with("3:0x1018:01");
  ASSERT_EQ(read.code, cli::kDone) << read.err;
  ASSERT_EQ(read.json()["answers"].size(), 1U);
  EXPECT_EQ(read.json()["answers"][0]["subject"], "object 0x1018:01");
  EXPECT_EQ(read.json()["answers"][0]["bytes"], "17 5c 00 00");
  EXPECT_EQ(read.json()["cycles"], cli_run(run).json()["cycles"]);
  const auto missing = with("3:0x5FFF:01");
  EXPECT_NE(missing.code, cli::kDone);
  EXPECT_NE(missing.err.find("does not exist"), std::string::npos) << missing.err;
  for (const std::string bad : {"3", "x:0x1018:01", "99:0x1018:01", "3:nothing"})
    EXPECT_NE(with(bad).err.find("--sdo-read"), std::string::npos) << bad;
}

/// On a bus that is simulated out of a project drives of no known family have no 0x1C32: their misses are computed, and
/// read nowhere.
TEST(CliRun, NamesNoObjectOfACounterThatIsNotThere) {
  const TemporaryFolder folder;
  (void)export_demo(folder, "bus");
  const auto project = folder.file("m.syncline");
  auto text = read_whole_file(project).value();
  constexpr std::string_view kVendor = "#x00005c17";
  for (auto at = text.find(kVendor); at != std::string::npos; at = text.find(kVendor, at + 1))
    text.replace(at, kVendor.size(), "#x00000a11");
  ASSERT_TRUE(write_whole_file(project, std::string_view(text)));
  const auto run = cli_run({"run", project, "--link", "sim:" + project + "?virtual", "--for", "8s", "--json"});
  const auto report = run.json();
  int computed = 0;
  for (const auto& slave : report["slaves"]) {
    if (slave["sm2_missed"].is_null()) continue;
    ++computed;
    EXPECT_EQ(slave["sm2_missed"], 0) << slave;
    EXPECT_TRUE(slave["sm2_object"].is_null()) << slave;
  }
  EXPECT_EQ(computed, 3) << run.out << run.err;
}

class CliRunMode : public testing::TestWithParam<std::string> {};

TEST_P(CliRunMode, DemonstrationMachineReachesOpInSync) {
  const TemporaryFolder folder;
  const auto run = cli_run({"run", export_demo(folder, GetParam()), "--link", demo(), "--for", "20s", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err << run.out;
  const auto report = run.json();
  const auto& events = report["events"];
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front()["time_ms"], 0.0);
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const auto& e) { return e["kind"] == "master_sync"; }));
  EXPECT_EQ(report["state"], "OP");
  EXPECT_EQ(report["cycle_us"], 1000);
  EXPECT_GT(report["cycles"], 15'000);
  EXPECT_EQ(report["wkc_errors"], 0);
  EXPECT_EQ(report["lost_frames"], 0);
  EXPECT_EQ(report["dc"]["monitored"], true);
  EXPECT_EQ(report["dc"]["in_sync"], true);
  EXPECT_EQ(report["dc"]["reference_clock"], 0);
  EXPECT_LT(report["dc"]["deviation_ns"]["max"], 100);
  EXPECT_EQ(report["dcm"]["mode"], GetParam() + "-shift");
  EXPECT_EQ(report["dcm"]["in_sync"], true);
  const auto holds = [](const auto& interval, double value) {
    return interval.size() == 2 && interval[0].template get<double>() <= value &&
           value <= interval[1].template get<double>();
  };
  EXPECT_TRUE(holds(report["dcm"]["drift_95_ppm"], report["dcm"]["drift_ppm"])) << report["dcm"];
  EXPECT_LT(report["dcm"]["drift_95_ppm"][1].get<double>() - report["dcm"]["drift_95_ppm"][0].get<double>(), 1);
  EXPECT_TRUE(holds(report["dcm"]["error_ns"]["mean_95"], report["dcm"]["error_ns"]["mean"])) << report["dcm"];
  const auto& drive = report["slaves"][3];
  EXPECT_TRUE(holds(drive["deviation_mean_95_ns"], drive["deviation_mean_ns"])) << drive;
  EXPECT_TRUE(report["slaves"][0]["deviation_mean_ns"].is_null()) << "it is the reference clock";
  for (const auto& slave : report["slaves"]) {
    EXPECT_EQ(slave["state"], "OP") << slave;
    if (!slave["deviation_ns"].is_null()) {
      EXPECT_LT(std::abs(slave["deviation_ns"].get<int>()), 100) << slave;
    }
    if (!slave["sm2_missed"].is_null()) {
      EXPECT_EQ(slave["sm2_missed"], 0) << slave;
    }
  }
}

TEST_P(CliRunMode, SameSeedGivesTheSameReport) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, GetParam());
  const std::vector<std::string> arguments{"run", eni, "--link", demo("?virtual&seed=5"), "--for", "4s", "--json"};
  const auto first = cli_run(arguments);
  EXPECT_EQ(first.out, cli_run(arguments).out);
  auto other = arguments;
  other[3] = demo("?virtual&seed=6");
  EXPECT_NE(first.out, cli_run(other).out) << "the seed has no effect";
}

INSTANTIATE_TEST_SUITE_P(Modes, CliRunMode, testing::Values("bus", "master"));

/// Nobody moves the timer: there is no moment from which errors count, and no figure of them.
TEST(CliRun, AMasterThatNeverWasInSyncHasNoFiguresOfItsError) {
  const TemporaryFolder folder;
  (void)export_demo(folder, "bus");
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "set", project, "master.dc.mode=master-shift-by-app"}).code, cli::kDone);
  const std::vector<std::string> run{"run", project, "--link", demo(), "--for", "5s"};
  EXPECT_THAT(cli_run(run).out, testing::AllOf(HasSubstr("drift"), testing::Not(HasSubstr("error mean"))));
  auto with_json = run;
  with_json.emplace_back("--json");
  const auto dcm = cli_run(with_json).json()["dcm"];
  EXPECT_EQ(dcm["in_sync"], false);
  for (const auto* figure : {"mean", "rms", "max"}) EXPECT_TRUE(dcm["error_ns"][figure].is_null()) << figure;
  EXPECT_TRUE(dcm["frame_error_ns"]["max"].is_null());
  EXPECT_TRUE(dcm["late_sends"].is_null());
}

TEST(CliRun, ProjectRunsAsItsEniDoes) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, "bus");
  const auto of_eni = cli_run({"run", eni, "--link", demo(), "--for", "3s", "--json"});
  const auto of_project = cli_run({"run", folder.file("m.syncline"), "--link", demo(), "--for", "3s", "--json"});
  EXPECT_EQ(of_eni.out, of_project.out);
}

TEST(CliRun, ConfigurationOfAnotherBusIsRefusedWithTheFirstDifference) {
  const TemporaryFolder folder;
  const auto project = folder.file("one.syncline");
  const auto slaves = cli_run({"scan", demo(), "--json"}).json()["slaves"];
  ASSERT_EQ(cli_run({"project", "create", project, "--device",
                     slaves[0]["vendor_id"].get<std::string>() + ":" + slaves[0]["product_code"].get<std::string>()})
                .code,
            cli::kDone);
  const auto run = cli_run({"run", project, "--link", demo(), "--for", "1s"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("1"));
}

TEST(CliRun, BrokenFileNamesFileAndLine) {
  const TemporaryFolder folder;
  const auto file = folder.file("broken.xml");
  std::ofstream(file) << "<EtherCATConfig>\n<Config>\n<Master></Config>\n";
  const auto run = cli_run({"run", file, "--link", demo(), "--for", "1s"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr(file));
}

TEST(CliRun, WritesTheLogOfTheMasterSynchronisationAndTakesItsParameters) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo(), "--shift", "master-ref-clock"}).code, cli::kDone);
  const auto log = folder.file("dcm.csv");
  const auto run = cli_run({"run", project, "--link", demo(), "--for", "5s", "--json", "--dcm-log", log, "--set",
                            "dcm.set_value_us=400", "--set", "master.dc.mode=master-shift"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_EQ(run.json()["dcm"]["mode"], "master-shift");
  EXPECT_EQ(run.json()["dcm"]["set_value_ns"], 400'000);
  EXPECT_EQ(run.json()["dcm"]["bus_shift_configured"], false) << "compiled with what is set for the run";
  std::ifstream file(log);
  std::ostringstream text;
  text << file.rdbuf();
  const auto rows = read_dcm_log(text.str());
  ASSERT_TRUE(rows) << rows.error().detail.text();
  ASSERT_GT(rows->size(), 2'000U);
  EXPECT_EQ(rows->back().set_value_ns, 400'000);
  EXPECT_TRUE(rows->back().dcm_in_sync);
  EXPECT_GT(rows->back().dc_start_time_ns, 0);
  EXPECT_NEAR(rows->back().drift_ppm, -12.5, 0.5);
}

/// The demonstration machine's clocks and what the host sees of them, ppm.
double drift_of(const nlohmann::json& report) { return report["dcm"]["drift_ppm"].get<double>(); }

TEST(CliRun, AProjectIsCompiledWithWhatIsSetForTheRun) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo(), "--shift", "master"}).code, cli::kDone);
  const auto with = [&](const std::vector<std::string>& settings, const std::string& length) {
    std::vector<std::string> arguments{"run", project, "--link", demo(), "--for", length, "--json"};
    for (const auto& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    const auto run = cli_run(arguments);
    EXPECT_EQ(run.code, cli::kDone) << run.err << run.out;
    return run.json();
  };
  const auto other = with({"dcm.reference_clock=3"}, "6s");
  EXPECT_EQ(other["dc"]["reference_clock"], 3);
  const auto first = with({}, "6s");
  EXPECT_GT(std::abs(drift_of(other) - drift_of(first)), 5)
      << "another quartz leads, and it is another one's rate that is seen";
  // The frames get the command that bus shift needs, and another cycle is another cycle.
  EXPECT_EQ(with({"dcm.mode=bus-shift"}, "6s")["dcm"]["bus_shift_configured"], true);
  EXPECT_EQ(with({"master.cycle_time_us=2000"}, "6s")["cycle_us"], 2000);
}

TEST(CliRun, OfAnEniNothingIsSetThatLiesInTheFile) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline"), eni = folder.file("m.xml");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo(), "--shift", "master"}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", eni}).code, cli::kDone);
  const auto run_with = [&](const std::string& setting, const std::string& length) {
    return cli_run({"run", eni, "--link", demo(), "--for", length, "--json", "--set", setting});
  };
  const auto refused = [&](const std::string& setting) {
    const auto run = run_with(setting, "1s");
    EXPECT_NE(run.code, cli::kDone) << setting;
    return run.err;
  };
  EXPECT_THAT(refused("dcm.mode=bus-shift"), HasSubstr("0x0910"));
  EXPECT_THAT(refused("dcm.all_slaves=on"), HasSubstr("start-up commands"));
  EXPECT_THAT(refused("dcm.show_64bit_system_time=on"), HasSubstr("cyclic frames"));
  EXPECT_THAT(refused("master.cycle_time_us=500"), HasSubstr("master.dc.*"));
  // The master chooses who leads, and addresses the file's commands to it.
  const auto other = run_with("dcm.reference_clock=3", "6s"), first = run_with("dcm.gain_ppt=3", "6s");
  ASSERT_EQ(other.code, cli::kDone) << other.err;
  EXPECT_EQ(other.json()["dc"]["reference_clock"], 3);
  EXPECT_EQ(first.json()["dc"]["reference_clock"], 0);
  EXPECT_GT(std::abs(drift_of(other.json()) - drift_of(first.json())), 5);
}

TEST(CliRun, ParametersThatCannotWorkAreRefusedByName) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo(), "--shift", "master"}).code, cli::kDone);
  const auto refused = [&](const std::string& setting) {
    const auto run = cli_run({"run", project, "--link", demo(), "--for", "1s", "--set", setting});
    EXPECT_NE(run.code, cli::kDone) << setting;
    return run.err;
  };
  EXPECT_THAT(refused("dcm.set_value_us=5"),
              testing::AllOf(HasSubstr("master.dc.set_value_us"), HasSubstr("5 us is outside")));
  EXPECT_THAT(refused("dcm.gain_ppt=501"), testing::AllOf(HasSubstr("master.dc.gain_ppt"), HasSubstr("0..500")));
  EXPECT_THAT(refused("dcm.mode=dcx"), HasSubstr("0x10F4"));
  EXPECT_THAT(refused("dcm.reference_clock=77"), HasSubstr("position 77"));
  EXPECT_THAT(refused("dcm.reference_clock"), HasSubstr("KEY=VALUE"));
  EXPECT_NE(cli_run({"project", "create", project, "--scan", demo(), "--shift", "sideways"}).code, cli::kDone);
}

TEST(CliRun, EveryReadingOfASlaveHasItsAge) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, "master");
  const auto run = cli_run({"run", eni, "--link", demo(), "--for", "20s", "--json"});
  int deviations = 0, sync_errors = 0;
  const auto told = run.json();
  for (const auto& slave : told["slaves"]) {
    SCOPED_TRACE(slave["name"]);
    EXPECT_GE(slave["al_status_age_ms"].get<double>(), 0);
    EXPECT_LT(slave["al_status_age_ms"].get<double>(), 500) << "each has its turn within 400 ms";
    EXPECT_EQ(slave["deviation_age_ms"].is_null(), slave["deviation_ns"].is_null());
    if (!slave["deviation_age_ms"].is_null()) {
      ++deviations;
      EXPECT_GE(slave["deviation_age_ms"].get<double>(), 0);
      EXPECT_LT(slave["deviation_age_ms"].get<double>(), 100);
    }
    const auto& age = slave["evidence"]["sync_error_age_ms"];
    if (age.is_null()) continue;
    ++sync_errors;
    EXPECT_GE(age.get<double>(), 0);
    EXPECT_LT(age.get<double>(), 10'000);
  }
  EXPECT_GT(deviations, 2);
  EXPECT_GT(sync_errors, 1);

  const auto off = "sim:" + source_dir() + "/resources/scenarios/faults/slave-off.toml?virtual";
  const auto gone = cli_run({"run", eni, "--link", off, "--for", "12s", "--json"});
  int away = 0;
  const auto left = gone.json();
  for (const auto& slave : left["slaves"]) {
    EXPECT_EQ(slave["al_status_age_ms"].is_null(), !slave["present"].get<bool>()) << slave["name"];
    away += slave["present"].get<bool>() ? 0 : 1;
  }
  EXPECT_GT(away, 0);
}

TEST(CliRun, TellsItsEventsByTheirTimes) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, "master");
  // Lost frames are told together, some of them after damaged ones that came later were read.
  const auto link = "sim:" + source_dir() + "/resources/scenarios/faults/bit-errors.toml?virtual&seed=1";
  const auto run = cli_run({"run", eni, "--link", link, "--for", "14s", "--json"});
  double last = 0;
  int lost = 0;
  const auto told = run.json();
  for (const auto& event : told["events"]) {
    EXPECT_GE(event["time_ms"].get<double>(), last) << event;
    last = event["time_ms"].get<double>();
    lost += event["kind"] == "frames_lost" ? 1 : 0;
  }
  EXPECT_GT(lost, 1);
}

TEST(CliRun, SavesWhatTheRunShowedOfItsHost) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, "master");
  const auto host = folder.file("host.toml");
  ASSERT_EQ(cli_run({"run", eni, "--link", demo(), "--for", "6s", "--save-host", host}).code, cli::kDone);
  std::ifstream file(host);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), testing::AllOf(HasSubstr("cycles of 1000 us with process data"), HasSubstr("[wake_up]"),
                                         HasSubstr("[stamp_error]")));
  const auto nothing = cli_run({"run", eni, "--link", demo(), "--for", "6s", "--state", "PREOP", "--save-host", host});
  EXPECT_NE(nothing.code, cli::kDone);
  EXPECT_THAT(nothing.err, HasSubstr("needs 1000 cycles with process data, the run had none"));
  const auto little = folder.file("little.toml");
  const auto few = cli_run({"run", eni, "--link", demo(), "--for", "2500ms", "--save-host", little});
  EXPECT_EQ(few.code, cli::kFailed);
  EXPECT_THAT(few.err, HasSubstr("a host profile needs 1000 cycles with process data, the run had "));
  EXPECT_FALSE(std::filesystem::exists(little));
}

/// A host that is late keeps a machine from OP, or makes it fall: it is measured wherever its lateness matters. What
/// was not measured is no lateness of 0.
TEST(CliRun, TellsTheLatenessOfAMachineThatDoesNotComeToOp) {
  const TemporaryFolder folder;
  const auto eni = export_demo(folder, "master");
  const auto lateness = [&](const std::string& state) {
    const auto run = cli_run({"run", eni, "--link", demo(), "--for", "5s", "--state", state, "--lateness", "--json"});
    return nlohmann::json::parse(run.out)["lateness"];
  };
  const auto in_preop = lateness("PREOP");
  EXPECT_GT(in_preop["cycles"], 2'000) << "the clocks are controlled there";
  EXPECT_GT(in_preop["p99_9_ns"], 0);
  EXPECT_GE(in_preop["max_ns"], in_preop["p99_9_ns"]);
  const auto in_init = lateness("INIT");
  EXPECT_EQ(in_init["cycles"], 0);
  for (const auto* figure : {"p50_ns", "p90_ns", "p99_ns", "p99_9_ns", "max_ns"})
    EXPECT_TRUE(in_init[figure].is_null());
}

/// The frames of a thousand terminals of 4 bytes need 333 us on the wire and 290 us to pass them all.
class CliRunThousand : public testing::Test {
 protected:
  TemporaryFolder folder;
  std::string esi = source_dir() + "/resources/esi", project = folder.file("thousand.syncline"), link;

  void SetUp() override {
    const auto scenario = folder.file("thousand.toml");
    std::ofstream(scenario) << "[[slave]]\nesi = \"" << esi << "/SL-1100.xml\"\n[[slave]]\nesi = \"" << esi
                            << "/SL-3002.xml\"\ncount = 999\n";
    link = "sim:" + scenario + "?virtual";
  }
  void create(const std::string& cycle_us) {
    ASSERT_EQ(cli_run({"project", "create", project, "--scan", link, "--esi", esi, "--cycle", cycle_us}).code,
              cli::kDone);
  }
};

TEST_F(CliRunThousand, ReachOpWhereTheirFramesComeBackInTime) {
  create("750");
  const auto run = cli_run({"run", project, "--link", link, "--for", "6s", "--json"});
  EXPECT_EQ(run.code, cli::kDone) << run.err;
  const auto report = run.json();
  EXPECT_EQ(report["state"], "OP");
  EXPECT_EQ(report["late_frames"], 0);
  EXPECT_EQ(report["lost_frames"], 0);
}

TEST_F(CliRunThousand, ACycleThatIsTooShortForThemIsTheCause) {
  create("600");
  const auto before = cli_run({"export", project, "-o", folder.file("m.xml"), "--json"}).json();
  const auto& findings = before["findings"];
  EXPECT_TRUE(std::ranges::any_of(findings, [](const auto& finding) {
    return finding["code"] == "cycle-too-short" && finding["key"] == "master.cycle_time_us";
  })) << findings;
  const auto run = cli_run({"run", project, "--link", link, "--for", "3s"});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  EXPECT_THAT(run.out, HasSubstr("error: The cycle of 600 us is too short"));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("stays in SAFEOP")));
}

}  // namespace
}  // namespace syncline::test
