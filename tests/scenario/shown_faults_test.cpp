// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "app/composition/open_link.h"
#include "compile/compile.h"
#include "diagnosis/run_diagnosis.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "findings/error_text.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

struct ShownFault {
  const char* scenario;
  const char* found;  // code of the finding that names the cause
  int slave;
};

/// The scenarios of docs/monitor.md: of each, what was done to the machine is what is found.
class ShownFaults : public testing::TestWithParam<ShownFault> {};

Project demo_project() {
  const auto scan = scan_bus(open_link("sim:" + test::source_dir() + "/resources/demo/machine.toml?virtual"));
  EXPECT_TRUE(scan) << describe(scan.error());
  eni::EsiCatalogue catalogue;
  EXPECT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  auto project = eni::project_from_scan(*scan, catalogue).project;
  project.master.dc.sync_window.enabled = true;
  return project;
}

TEST_P(ShownFaults, AreFound) {
  const auto& fault = GetParam();
  const auto compiled = compile(demo_project());
  ASSERT_TRUE(compiled);
  RunRequest request;
  request.duration = 15 * kSecond;
  const auto outcome = run_network(
      compiled->config,
      open_link("sim:" + test::source_dir() + "/resources/scenarios/faults/" + fault.scenario + ".toml?virtual"),
      request);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  std::string said;
  bool found = false;
  for (const auto& finding : diagnose(outcome->report)) {
    said += std::string(finding.code) + " " + std::to_string(finding.place.slave) + "\n";
    found = found || (finding.code == fault.found && finding.place.slave == fault.slave);
  }
  EXPECT_TRUE(found) << "of " << fault.found << " at " << fault.slave << " nothing:\n" << said;
}

constexpr ShownFault kShownFaults[] = {
    {"adapter-off", "adapter-was-away", -1},
    {"bit-errors", "port-errors", 4},
    {"cable-break", "slave-was-absent", 6},
    {"clock-step", "sync-window-left", 3},
    {"held-frames", "frames-late", -1},
    {"host-stall", "host-stalled", -1},
    {"hung-firmware", "firmware-hung", 3},
    {"lost-frames", "frames-lost", -1},
    {"noisy-delay", "sync-window-left", 4},
    {"reference-step", "sync-window-left", 0},
    {"slave-off", "slave-absent-behind-cable", 5},
    {"slow-firmware", "firmware-slow", 4},
};

INSTANTIATE_TEST_SUITE_P(All, ShownFaults, testing::ValuesIn(kShownFaults), [](const auto& shown) {
  std::string name = shown.param.scenario;
  std::erase(name, '-');
  return name;
});

/// None is shown without being tested.
TEST(ShownFaultsOfTheFolder, AreAllTested) {
  std::set<std::string> files, tested;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() + "/resources/scenarios/faults"))
    files.insert(entry.path().stem().string());
  for (const auto& fault : kShownFaults) tested.insert(fault.scenario);
  EXPECT_EQ(files, tested);
}

}  // namespace
}  // namespace syncline
