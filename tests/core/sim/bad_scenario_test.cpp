// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "findings/error_text.h"
#include "sim/scenario/host_profile_file.h"
#include "tests/core/sim/sim_probe.h"

/// Scenarios and host profiles that contradict themselves, and the file, line and key that the error names.
namespace syncline::test {
namespace {

namespace fs = std::filesystem;

std::string write_file(const std::string& content, const std::string& suffix = ".toml") {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const auto path = (fs::temp_directory_path() / (std::string("syncline-bad-") + info->name() + suffix)).string();
  std::ofstream(path) << content;
  return path;
}

std::string servo() { return "[[slave]]\nesi = \"" + resource("esi/SL-SV7.xml") + "\"\n"; }
std::string terminal() { return "[[slave]]\nesi = \"" + resource("esi/SL-1002.xml") + "\"\n"; }

Result<SimConfig> load(const std::string& content) { return sim::load_scenario(write_file(content), scenario_device); }

struct Wrong {
  std::string content;
  std::string key;
  int line = 0;
  std::string says;
};

void expect_wrong(const Wrong& wrong) {
  const auto config = load(wrong.content);
  ASSERT_FALSE(config) << wrong.content;
  EXPECT_EQ(config.error().code, ErrorCode::kScenarioKey) << wrong.content;
  EXPECT_EQ(config.error().subject, wrong.key) << wrong.content;
  EXPECT_EQ(config.error().line, wrong.line) << wrong.content << describe(config.error());
  EXPECT_THAT(config.error().detail.text(), testing::HasSubstr(wrong.says)) << wrong.content;
  EXPECT_FALSE(config.error().file.empty());
}

/// Two slaves in four lines, then a fault from line 5 on.
Wrong fault(const std::string& keys, const std::string& key, int line, const std::string& says) {
  return {servo() + terminal() + "[[fault]]\n" + keys, key, line, says};
}

TEST(BadScenario, NumbersOutsideOfWhatTheirKeyCanHold) {
  for (const auto& wrong : {Wrong{servo() + "alias = 70000\n", "alias", 3, "0 to 65535"},
                            Wrong{servo() + "alias = -1\n", "alias", 3, "0 to 65535"},
                            Wrong{servo() + "alias = 1.5\n", "alias", 3, "whole number"},
                            Wrong{servo() + "ppm = \"much\"\n", "ppm", 3, "number"},
                            Wrong{servo() + "ppm = nan\n", "ppm", 3, "number"},
                            Wrong{servo() + "processing_delay_ns = -5\n", "processing_delay_ns", 3, "0 to"},
                            Wrong{servo() + "wander_ppm = -5\n", "wander_ppm", 3, "0 to"},
                            Wrong{servo() + "lrw = 1\n", "lrw", 3, "true or false"},
                            Wrong{servo() + "count = 0\n", "count", 3, "1 to"},
                            Wrong{servo() + "count = 64001\n", "count", 3, "1 to 64000"},
                            Wrong{servo() + "count = 2.0\n", "count", 3, "whole number"},
                            Wrong{servo() + "alias = 65530\ncount = 10\n", "alias", 3, "counts up to 65539"},
                            Wrong{servo() + "serial_no = 4294967290\ncount = 10\n", "serial_no", 3, "counts up beyond"},
                            Wrong{servo() + "entry = \"B\"\ncount = 2\n", "entry", 3, "one by one"},
                            Wrong{servo() + terminal() + "count = 64000\n", "count", 5, "64001"},
                            Wrong{servo() + "spread_ppm = nan\n", "spread_ppm", 3, "number"},
                            Wrong{servo() + "ppm = inf\n", "ppm", 3, "number"},
                            Wrong{"[host]\nppm = nan\n" + servo(), "ppm", 2, "number"},
                            Wrong{"seed = -1\n" + servo(), "seed", 1, "from 0 on"},
                            Wrong{"[bus]\nloss = 2\n" + servo(), "loss", 2, "0 to 1"},
                            Wrong{"[bus]\nlatch = 2\n" + servo(), "latch", 2, "is not a key"},
                            Wrong{"[host]\nppm = 1e9\n" + servo(), "ppm", 2, "-10000"}}) {
    expect_wrong(wrong);
  }
}

TEST(BadScenario, ACircleOfSlavesIsNoSegment) {
  auto config = load(servo() + terminal());
  ASSERT_TRUE(config) << describe(config.error());
  config->slaves[0].parent = 1;
  const auto bus = sim::SimBus::create(*config, VirtualClock::kDefaultStart);
  ASSERT_FALSE(bus) << "and the way of its frames ends";
  EXPECT_EQ(bus.error().subject, "slave 0");
}

TEST(BadScenario, SlavesThatContradictThemselves) {
  for (const auto& wrong :
       {Wrong{servo() + terminal() + "port = \"A\"\n", "port", 5, "is where slave 0 is wired"},
        Wrong{servo() + terminal() + terminal() + "parent = 0\n", "parent", 0, ""},
        Wrong{servo() + terminal() + "parent = 1\n", "parent", 5, "another slave"},
        Wrong{servo() + terminal() + "parent = -1\n", "parent", 5, "slave 0 is the one"},
        Wrong{servo() + "parent = 3\n", "parent", 3, "there are 1"},
        Wrong{servo() + "parent = 2\n" + terminal() + terminal(), "parent", 3, "no frame reaches it"},
        Wrong{servo() + "esc = \"et1100\"\ntdiff_ns = 20\n", "tdiff_ns", 4, "without esc"},
        Wrong{servo() + "esc = \"et2000\"\n", "esc", 3, "et1100"},
        Wrong{servo() + "tdiff_ns = 20\nprocessing_delay_ns = 300\n", "tdiff_ns", 3, "one of the two"},
        Wrong{servo() + "cable_m = 1\nasymmetry_ns = 30\n", "asymmetry_ns", 4, "1 m"},
        Wrong{servo() + "external_ppm = 3\n", "external_ppm", 3, "sync-bridge"},
        Wrong{servo() + "deviation_sign = \"both\"\n", "deviation_sign", 3, "older"}}) {
    if (wrong.line != 0) expect_wrong(wrong);
  }
  // Two slaves at one port: the line of the second one's table, since it does not say "port".
  const auto config = load(servo() + terminal() + terminal() + "parent = 0\n");
  ASSERT_FALSE(config);
  EXPECT_EQ(config.error().subject, "port");
  EXPECT_EQ(config.error().line, 5);
  EXPECT_THAT(config.error().detail.text(), testing::HasSubstr("has slave 1 already"));
}

TEST(BadScenario, FaultsThatTheMachineCannotHave) {
  for (const auto& wrong :
       {fault("kind = \"explode\"\n", "kind", 6, "must be one of"),
        fault("kind = \"cable-break\"\nslave = 2\n", "slave", 7, "0 to 1"),
        fault("kind = \"cable-break\"\n", "slave", 5, "position of a slave"),
        fault("kind = \"cable-break\"\nslave = 0\nvalue_ns = 3\n", "value_ns", 8, "does not go with cable-break"),
        fault("kind = \"clock-step\"\nslave = 0\n", "value_ns", 5, "is missing"),
        fault("kind = \"clock-step\"\nslave = 0\nvalue_ns = 1\nuntil_ms = 3\n", "until_ms", 9, "does not go"),
        fault("kind = \"mailbox-silence\"\nslave = 1\n", "kind", 6, "no mailbox"),
        fault("kind = \"slow-application\"\nslave = 1\nvalue_ns = 1\n", "kind", 6, "no firmware"),
        fault("kind = \"bit-errors\"\nslave = 1\nport = \"C\"\n", "port", 8, "no cable"),
        // Port B has a cable at slave 0, and at nobody else.
        fault("kind = \"bit-errors\"\nslave = 1\nport = \"B\"\n", "port", 8, "no cable"),
        fault("kind = \"closed-ring\"\nslave = 0\nport = \"B\"\nvalue_ns = 9\n", "port", 8, "not free"),
        fault("kind = \"reversed-cable\"\nslave = 0\nport = \"A\"\n", "port", 8, "anyway"),
        fault("kind = \"foreign-frames\"\nslave = 0\n", "slave", 7, "no slave's"),
        fault("kind = \"clock-slew\"\nvalue_ns = 5\nppm = -3\n", "ppm", 8, "above 0"),
        fault("kind = \"lose-frames\"\nprobability = 1.5\n", "probability", 7, "0 to 1"),
        fault("kind = \"lose-frames\"\nprobability = 0.5\ncount = 3\n", "count", 8, "one of the two"),
        fault("kind = \"lose-frames\"\nat_ms = 3\nuntil_ms = 9\n", "until_ms", 8, "count or a probability"),
        fault("kind = \"refuse-state\"\nslave = 0\nstate = \"OP\"\n", "code", 5, "is missing")}) {
    expect_wrong(wrong);
  }
  const auto without_clock =
      load(servo() + "dc = \"none\"\n[[fault]]\nkind = \"clock-step\"\nslave = 0\nvalue_ns = 5\n");
  ASSERT_FALSE(without_clock);
  EXPECT_THAT(without_clock.error().detail.text(), testing::HasSubstr("no clock"));
}

TEST(BadScenario, TimesThatContradictEachOther) {
  for (const auto& wrong :
       {fault("kind = \"cable-break\"\nslave = 0\nat_ms = 5\nuntil_ms = 4\n", "until_ms", 9,
              "before it begins, at 5 ms"),
        fault("kind = \"cable-break\"\nslave = 0\nat_ms = -5\n", "at_ms", 8, "0 to"),
        fault("kind = \"cable-break\"\nslave = 0\nat_ms = inf\n", "at_ms", 8, "0 to"),
        fault("kind = \"bit-errors\"\nslave = 1\nat_ms = 5\nuntil_ms = 9\ncount = 3\n", "count", 10,
              "without until_ms"),
        fault("kind = \"slave-off\"\nslave = 0\nat_ms = 5\nuntil_ms = 9\n[[fault]]\nkind = \"slave-off\"\nslave = "
              "0\nat_ms = 8\n",
              "at_ms", 13, "begins at 5 ms is not over"),
        fault("kind = \"slave-off\"\nslave = 0\nat_ms = 5\n[[fault]]\nkind = \"slave-off\"\nslave = 0\nat_ms = 800\n",
              "at_ms", 12, "not over")}) {
    expect_wrong(wrong);
  }
  for (const auto* fine :
       {"kind = \"slave-off\"\nslave = 0\nat_ms = 5\nuntil_ms = 9\n[[fault]]\nkind = \"slave-off\"\nslave = 0\nat_ms = "
        "9\n",
        "kind = \"slave-off\"\nslave = 0\nat_ms = 5\n[[fault]]\nkind = \"slave-off\"\nslave = 1\nat_ms = 8\n",
        "kind = \"lose-frames\"\nat_ms = 5\n[[fault]]\nkind = \"lose-frames\"\nat_ms = 5\ncount = 2\n",
        "kind = \"cable-break\"\nslave = 0\nat_ms = 5\n[[fault]]\nkind = \"slave-off\"\nslave = 0\nat_ms = 8\n"}) {
    const auto config = load(servo() + terminal() + "[[fault]]\n" + fine);
    EXPECT_TRUE(config) << fine << describe(config.error());
  }
}

TEST(HostProfileFile, SaysWhatItWasMadeFromAndIsReadBack) {
  for (const auto& profile : {JitterProfile::quiet(), JitterProfile::desktop(), JitterProfile::bad()}) {
    const auto text = sim::host_profile_text(profile, "Measured somewhere.\nTwice.");
    EXPECT_THAT(text, testing::StartsWith("# Measured somewhere.\n# Twice.\n"));
    const auto back = sim::read_host_profile(write_file(text));
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(sim::host_profile_text(*back, ""), sim::host_profile_text(profile, ""));
  }
}

TEST(HostProfileFile, StallsAloneAreAProfileHoweverSeldom) {
  const auto profile =
      sim::read_host_profile(write_file("[stalls]\nper_second = 0.5\nquantiles = [[0, 2e6], [1, 3e6]]\n"));
  ASSERT_TRUE(profile) << describe(profile.error());
  EXPECT_EQ(profile->stalls_per_second, 0.5);
}

TEST(HostProfileFile, IsTakenByAScenarioBesideIt) {
  const auto profile = write_file(
      "[wake_up]\nquantiles = [[0, 10], [1, 30]]\n[stalls]\nper_second = 0.5\nquantiles = [[0, 2e6], [1, 3e6]]\n",
      ".host.toml");
  const auto config = load("[host]\nprofile = \"" + fs::path(profile).filename().string() + "\"\n" + servo());
  ASSERT_TRUE(config) << describe(config.error());
  EXPECT_EQ(config->host_jitter.wake_up.at(0.5), 20);
  EXPECT_EQ(config->host_jitter.stalls_per_second, 0.5);
  EXPECT_EQ(config->host_jitter.stall.at(1), 3e6);
  expect_wrong({"[host]\njitter = \"quiet\"\nprofile = \"x.toml\"\n" + servo(), "profile", 3, "without jitter"});
}

TEST(BadScenario, AFileThatIsNotThereIsToldWhereItIsNamed) {
  expect_wrong({"[host]\nprofile = \"nowhere.toml\"\n" + servo(), "profile", 2, "there is no file"});
  expect_wrong({"[host]\nprofile = \".\"\n" + servo(), "profile", 2, "cannot be read: Is a directory"});
  expect_wrong({"name = \"x\"\nmachine = \"nowhere.toml\"\n", "machine", 2, "nowhere.toml"});
  expect_wrong({servo() + "[[slave]]\nesi = \"nowhere.xml\"\n", "esi", 4, "nowhere.xml"});
  // What is wrong in it stands there.
  const auto profile = write_file("[wake_up]\nquantiles = []\n", ".host.toml");
  const auto config = load("[host]\nprofile = \"" + fs::path(profile).filename().string() + "\"\n" + servo());
  ASSERT_FALSE(config);
  EXPECT_EQ(config.error().file, profile);
  EXPECT_EQ(config.error().line, 2);
}

TEST(BadScenario, ADeviceThatItsFileDoesNotHaveIsToldWhereItIsNamed) {
  const auto config = load("name = \"x\"\n" + servo() + "type = \"SL-9999\"\n");
  ASSERT_FALSE(config);
  EXPECT_EQ(config.error().line, 3) << describe(config.error());
}

/// A card holds frames up for so long, not for two lengths at once; what it does to frames and answers are two things.
TEST(BadScenario, WhatTheAdapterDoesHasOneLengthAtATime) {
  const std::string first = "kind = \"hold-frames\"\nat_ms = 5\nuntil_ms = 9\nvalue_ns = 100_000\n[[fault]]\n";
  expect_wrong(fault(first + "kind = \"hold-frames\"\nat_ms = 8\nvalue_ns = 1\n", "at_ms", 12,
                     "the hold-frames that begins at 5 ms is not over then"));
  expect_wrong(fault("kind = \"hold-answers\"\nat_ms = 5\n", "value_ns", 5, "is missing"));
  expect_wrong(fault("kind = \"hold-frames\"\nvalue_ns = 1_000_000_001\n", "value_ns", 7, "1000000000"));
  expect_wrong(fault("kind = \"adapter-off\"\nslave = 0\n", "slave", 7, "it is no slave's"));
  expect_wrong(fault("kind = \"adapter-off\"\nvalue_ns = 1\n", "value_ns", 7, "does not go with adapter-off"));
  for (const auto* fine :
       {"kind = \"hold-answers\"\nat_ms = 8\nvalue_ns = 1_000_000_000\n",
        "kind = \"hold-frames\"\nat_ms = 9\nvalue_ns = 1\n", "kind = \"adapter-off\"\nat_ms = 8\n"}) {
    const auto config = load(servo() + terminal() + "[[fault]]\n" + first + fine);
    EXPECT_TRUE(config) << fine << describe(config.error());
  }
}

TEST(BadScenario, StallsOfTheHostThatOverlap) {
  const std::string first = "kind = \"host-stall\"\nat_ms = 8000\nvalue_ns = 40_000_000\n[[fault]]\n";
  const auto second = [&](const char* at, const char* length) {
    return first + "kind = \"host-stall\"\nat_ms = " + at + "\nvalue_ns = " + length + "\n";
  };
  for (const auto& [at, length] : {std::pair{"8039.9", "1"}, {"7000", "2_000_000_000"}, {"8000", "40_000_000"}}) {
    expect_wrong(fault(second(at, length), "at_ms", 11, "overlaps the host-stall from 8000 ms to 8040 ms"));
  }
  for (const auto& [at, length] : {std::pair{"8040", "1_000_000"}, {"7000", "1_000_000_000"}}) {
    const auto config = load(servo() + terminal() + "[[fault]]\n" + second(at, length));
    EXPECT_TRUE(config) << at << describe(config.error());
  }
}

TEST(HostProfileFile, ContradictionsAreNamedWithLineAndKey) {
  const auto expect = [](const std::string& text, const std::string& key, int line, const std::string& says) {
    const auto path = write_file(text);
    const auto profile = sim::read_host_profile(path);
    ASSERT_FALSE(profile) << text;
    EXPECT_EQ(profile.error().file, path);
    EXPECT_EQ(profile.error().subject, key) << text;
    EXPECT_EQ(profile.error().line, line) << text << describe(profile.error());
    EXPECT_THAT(profile.error().detail.text(), testing::HasSubstr(says)) << text;
  };
  expect("[wake_up]\nquantiles = [[0, 10],\n  [0.5, 5]]\n", "quantiles", 3, "cannot be below 5 ns");
  expect("[wake_up]\nquantiles = [[0.5, 10],\n  [0.5, 50]]\n", "quantiles", 3, "must rise");
  expect("[wake_up]\nquantiles = [[0, -1]]\n", "quantiles", 2, "0 to 60000000000");
  expect("[wake_up]\nquantiles = [[0, nan]]\n", "quantiles", 2, "0 to 60000000000");
  expect("[wake_up]\nquantiles = [[50, 10]]\n", "quantiles", 2, "part from 0 to 1");
  expect("[wake_up]\nquantiles = []\n", "quantiles", 2, "list of [part, ns]");
  expect("[wake_up]\nscale = 3\n", "quantiles", 1, "list of [part, ns]");
  expect("[stamps]\nquantiles = [[0, 1]]\n", "stamps", 1, "is not a key");
  expect("[wake_up]\nquantiles = [[0, 1]]\n[stamps]\nquantiles = [[0, 1]]\n", "stamps", 3, "is not a key");
  expect("[stalls]\nper_second = 3\n", "quantiles", 1, "list of");
  expect("[wake_up]\nquantiles = [[0, 10]]\n[stalls]\nper_second = 0.5\n", "quantiles", 3, "list of");
  expect("[stalls]\nper_second = 300\nquantiles = [[0, 5e6]]\n", "per_second", 2, "no time at all");
  expect("", "wake_up", 1, "a host profile has times for one of them");
  expect("# nothing\n[stalls]\nper_second = 0\n", "wake_up", 1, "a host profile has times for one of them");
  EXPECT_EQ(sim::read_host_profile(write_file("[wake_up\n")).error().code, ErrorCode::kTomlMalformed);
}

}  // namespace
}  // namespace syncline::test
