// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "channels/snapshot.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "record/dcm_log_session.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// The log of a run in which the host's clock is 35 ppm slower than the reference clock.
TEST(DcmLogOfARun, SaysTheRun) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 3; ++i) network.add(test::io8());
  for (auto& slave : network.sim.slaves) slave.oscillator.ppm += 40;
  auto& dc = network.project.master.dc;
  dc.burst_total = 3'000;
  dc.dcm.mode = DcmMode::kMasterShift;
  dc.sync_window.enabled = true;
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  opened.link = network.link(*opened.clock);
  ASSERT_TRUE(opened.link);
  const auto config = network.compiled();
  std::string text;
  DcmLogSession log(config, [&text](std::string_view more) { text += more; });
  std::optional<Nanoseconds> start_time;
  RunRequest request;
  request.duration = 8 * kSecond;
  request.on_samples = [&log](std::span<const CycleSample> samples) { log.add(samples); };
  request.on_snapshot = [&](const Snapshot& snapshot) {
    log.add(snapshot);
    if (snapshot.online) start_time = snapshot.dc.start_time;
  };
  ASSERT_TRUE(run_network(config, std::move(opened), request));
  const auto rows = read_dcm_log(text);
  ASSERT_TRUE(rows);
  ASSERT_GT(rows->size(), 3'000U);
  const auto& last = rows->back();
  EXPECT_TRUE(last.dcm_in_sync && last.dc_in_sync);
  EXPECT_FALSE(rows->front().dcm_in_sync);
  EXPECT_EQ(last.dc_start_time_ns, start_time);
  EXPECT_GT(last.dc_start_time_ns, 0);
  EXPECT_EQ(last.set_value_ns, effective_set_value(config.dc.dcm, config.cycle_time()));
  EXPECT_EQ(last.bus_time_off_ns, last.bus_time_ns % kMillisecond);
  EXPECT_NEAR(last.drift_ppm, -35, 1) << "the host is the slower one";
  EXPECT_NEAR(last.output_sum, -35, 3) << "ns a cycle";
  EXPECT_NEAR(static_cast<double>(last.output_total), last.time_ms * -35, 5'000);
}

}  // namespace
}  // namespace syncline
