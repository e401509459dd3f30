// SPDX-License-Identifier: Apache-2.0
// Machines with slaves that are wired in by another port than A.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>

#include "dc/propagation_delay.h"
#include "sim/scenario/scenario_loader.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/event_match.h"
#include "tests/support/swapped_network.h"

namespace syncline {
namespace {

TEST(SwappedCables, ScenarioNamesAParentThatFramesComeToLater) {
  const auto path = testing::TempDir() + "swapped.toml";
  std::ofstream(path) << "[[slave]]\nesi = \"x\"\n[[slave]]\nesi = \"x\"\nparent = 2\nport = \"A\"\n"
                         "[[slave]]\nesi = \"x\"\nparent = 0\nentry = \"B\"\n";
  const auto config = sim::load_scenario(path, [](const sim::DeviceQuery&) -> Result<sim::ScenarioDevice> {
    return sim::ScenarioDevice{test::io8(), {}};
  });
  ASSERT_TRUE(config) << config.error().detail.text();
  EXPECT_EQ(config->slaves[1].parent, 2);
  EXPECT_TRUE(sim::SimBus::create(*config, 0));
}

/// As close as clocks of upright slaves: 100 ns, the smallest limit that anything here is judged by.
TEST(SwappedCables, RunsInSyncAndSaysWhatToDo) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    test::DiagnosedRun machine;
    machine.network = test::swapped_network(8, seed);
    machine.run(8 * kSecond);
    RC_ASSERT(machine.report.state == AlState::kOp);
    RC_LOG() << machine.said();
    RC_ASSERT(machine.report.deviation_max_ns.value_or(0) < 100);
    for (const auto& finding : machine.findings) RC_ASSERT(finding.severity != Severity::kError);
    const auto swapped =
        std::ranges::count_if(machine.network.sim.slaves, [](const auto& slave) { return slave.entry_port != 0; });
    const auto told = std::ranges::count_if(machine.events, [](const Event& event) {
      return test::with(&events::DelayFinding::warning, dc::DelayWarning::kReversedCable)(event);
    });
    RC_ASSERT(told == swapped);
  }));
}

}  // namespace
}  // namespace syncline
