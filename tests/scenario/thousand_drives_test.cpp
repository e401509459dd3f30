// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "channels/command.h"
#include "channels/events/service_events.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "tests/support/small_machines.h"

/// Long buses with a project's defaults.
namespace syncline::test {
namespace {

std::string run_to_op(std::size_t slaves, const DeviceDescription& device, const std::string& behaviour) {
  SimulatedNetwork network;
  network.project.master.cycle_time = kMillisecond;
  for (std::size_t i = 0; i < slaves; ++i) network.add(device, behaviour);
  VirtualClock clock;
  auto link = network.link(clock);
  if (!link) return "no simulated bus";
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  (void)service.step();
  for (const auto& event : service.channels().events.drain()) {
    if (const auto* failure = event.as<events::Failure>()) return describe(failure->error);
  }
  Snapshot snapshot;
  (void)service.channels().snapshot.read(snapshot);
  return snapshot.state == AlState::kOp ? "" : "not in OP";
}

TEST(ManySlaves, TwoHundredTerminalsWithClocksReachOp) { EXPECT_EQ(run_to_op(200, io8(), "generic"), ""); }
TEST(ManySlaves, AThousandDrivesWithClocksReachOpAtAMillisecond) {
  EXPECT_EQ(run_to_op(1000, small_servo(), "servo-y"), "");
}

}  // namespace
}  // namespace syncline::test
