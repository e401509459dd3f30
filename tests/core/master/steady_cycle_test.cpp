// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "cycle_hooks.h"
#include "eni/esi/esi_reader.h"
#include "master/operation.h"
#include "tests/support/source_dir.h"
#include "tests/support/test_bus.h"

namespace syncline {
namespace {

TEST(SteadyCycle, AllocatesNothing) {
  VirtualClock clock;
  test::TestBus bus(clock, 2);
  const auto esi = eni::read_esi(test::source_dir() + "/resources/esi/SL-SV7.xml");
  ASSERT_TRUE(esi);
  Project project;
  project.master.dc.sync_window.enabled = true;
  project.master.dc.burst_total = 100;
  for (std::uint16_t i = 0; i < 2; ++i) {
    project.slaves.push_back(default_slave(esi->devices.front(), i));
    sii::Image image;
    image.vendor_id = esi->devices.front().identity.vendor_id;
    image.product_code = esi->devices.front().identity.product_code;
    bus.slave(i).sii = sii::encode(image);
    bus.slave(i).has_mailbox = true;
    bus.slave(i).objects[0x1C320C] = {0, 0};
  }
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  test::UncountedLink link(bus);
  FrameExchange exchange(link, clock);
  MasterChannels channels;
  Operation operation(compiled->config, exchange, clock, channels);
  ASSERT_TRUE(operation.start(AlState::kOp));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(operation.run_cycle());

  test::CycleCounts counts;
  bool ok = true;
  {
    const test::CountingCycle counting(counts);
    for (int i = 0; i < 2000; ++i) ok = operation.run_cycle().has_value() && ok;
  }
  EXPECT_TRUE(ok);
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
  // The counter was read many times meanwhile: this covers the mailbox, too.
  EXPECT_TRUE(operation.run().snapshot.slaves[0].sm2_missed.valid);
}

}  // namespace
}  // namespace syncline
