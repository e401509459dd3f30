// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/dcm_query.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "dc/clock_registers.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "protocol/dcm_error.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

using ::testing::HasSubstr;

/// Three simulated terminals with clocks and a master on virtual time.
class DcmRun : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::SimulatedNetwork network;
  std::unique_ptr<MasterService> service;
  sim::SimBus* bus = nullptr;
  Snapshot snapshot;
  std::vector<Event> events;
  std::vector<CycleSample> samples;

  void SetUp() override {
    for (int i = 0; i < 3; ++i) network.add(test::io8());
    for (auto& slave : network.sim.slaves) slave.oscillator.ppm += 40;
    network.project.master.dc.burst_total = 3'000;
  }
  DcmSettings& dcm() { return network.project.master.dc.dcm; }
  void go_online(const JitterProfile& jitter = JitterProfile::quiet()) {
    clock.set_wakeup_jitter(jitter, 3);
    auto made = sim::SimBus::create(network.sim, clock.now());
    ASSERT_TRUE(made);
    bus = made->get();
    auto link = make_simulated_link("sim", std::move(*made), clock, SimulatedHost::with(jitter, 4));
    service = std::make_unique<MasterService>(std::move(link), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    (void)service->step();
    drain();
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    drain();
  }
  void drain() {
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().samples.pop(samples);
    service->channels().snapshot.read(snapshot);
  }
  [[nodiscard]] std::optional<Error> error() const {
    for (const auto& event : events) {
      if (const auto* failure = event.as<events::Failure>()) return failure->error;
    }
    return std::nullopt;
  }
};

TEST_F(DcmRun, EveryModeThatControlsComesInSyncOnTheBus) {
  for (const auto mode :
       {DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock}) {
    dcm().mode = mode;
    events.clear();
    go_online();
    run(3 * kSecond);
    EXPECT_FALSE(error()) << dcm_mode_name(mode) << error().value_or(Error{}).detail.text();
    EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync) << dcm_mode_name(mode);
    EXPECT_LT(snapshot.dcm.in_sync_after_ms.value_or(1e9), 2'000) << dcm_mode_name(mode);
    EXPECT_EQ(dcm_bus_shift_configured(snapshot), steers_reference_clock(mode));
    EXPECT_EQ(snapshot.dcm.set_value_ns, 666'666);
    EXPECT_GT(snapshot.dc.start_time, VirtualClock::kDefaultStart);
    EXPECT_EQ(snapshot.dc.state, SyncState::kNotMonitored);
    EXPECT_GT(snapshot.dc.since, clock.now() - 10 * kSecond) << "since it was started";
  }
}

/// The error itself may be small while something else stands in the way.
TEST_F(DcmRun, SaysWhatKeepsItFromTheLockAndNotAnErrorWithinTheLimit) {
  dcm().set_value = 11 * kMicrosecond;  // enough for the frame, not for its way along this cable
  network.sim.slaves[2].cable_m = 2'000;
  go_online();
  ASSERT_TRUE(error());
  EXPECT_THAT(describe(*error()),
              testing::AllOf(HasSubstr("set value is too small"), testing::Not(HasSubstr("beyond the limit"))));
}

TEST_F(DcmRun, TheLinkCorrectsWhatSoftwareDoesNotKnow) {
  const auto rms = [this](DcmMode mode) {
    dcm().mode = mode;
    go_online(JitterProfile::desktop());
    run(2 * kSecond);
    service->channels().commands.push(ResetDcmStatusCommand{});
    run(5 * kSecond);
    return snapshot.dcm.error_rms_ns;
  };
  EXPECT_GT(rms(DcmMode::kBusShift), 2 * rms(DcmMode::kLinkLayerRefClock));
}

TEST_F(DcmRun, ALinkWithoutAClockIsNoHardwareForIt) {
  struct Plain final : Link {
    Status send(std::span<const std::uint8_t>) override { return {}; }
    Result<ReceivedFrame> receive(std::span<std::uint8_t>, Nanoseconds) override { return ReceivedFrame{}; }
    [[nodiscard]] LinkDescription describe() const override { return {}; }
  };
  dcm().mode = DcmMode::kLinkLayerRefClock;
  service = std::make_unique<MasterService>(std::make_unique<Plain>(), clock);
  service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  (void)service->step();
  drain();
  ASSERT_TRUE(error());
  EXPECT_EQ(error()->received, dc::kDcmErrorInvalidHardwareLayer);
}

TEST_F(DcmRun, TheStatusIsResetAndParametersChangeWhileItRuns) {
  dcm().mode = DcmMode::kMasterShift;
  go_online();
  run(2 * kSecond);
  ASSERT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  EXPECT_GT(dcm_status(snapshot).difference_max_ns, 0);
  EXPECT_EQ(samples.back().external_error_ns, CycleSample::kNoExternalClock);
  EXPECT_FALSE(dcm_adjust(snapshot)) << "the controller has the timer";

  auto change = dcm();
  change.set_value = 400'000;
  change.in_sync_limit = 6'000;
  service->channels().commands.push(ConfigureDcmCommand{change});
  run(3 * kSecond);
  EXPECT_EQ(snapshot.dcm.set_value_ns, 400'000);
  EXPECT_EQ(snapshot.dcm.in_sync_limit, 6'000);
  EXPECT_EQ(snapshot.dcm.times_configured, 1U);
  // Whoever changes the controller knows that it settles anew.
  EXPECT_TRUE(std::ranges::none_of(events, [](const Event& event) { return event.is<events::MasterOutOfSync>(); }));
  EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  // SYNC0 stands where it was; the frames moved.
  const auto distance =
      ((snapshot.dc.start_time - samples.back().reference_time) % kMillisecond + kMillisecond) % kMillisecond;
  EXPECT_NEAR(static_cast<double>(distance), 400'000, 2'000);

  change.gain_ppt = 501;
  service->channels().commands.push(ConfigureDcmCommand{change});
  run(kMillisecond);
  ASSERT_TRUE(error());
  EXPECT_EQ(error()->subject, "master.dc.gain_ppt");
  EXPECT_EQ(snapshot.dcm.set_value_ns, 400'000);
}

TEST_F(DcmRun, AnApplicationMovesTheTimerByTheReportedAdjustment) {
  dcm().mode = DcmMode::kMasterShiftByApp;
  go_online();
  ASSERT_FALSE(error());
  EXPECT_EQ(snapshot.state, AlState::kOp) << "nobody waits for the application";
  for (int i = 0; i < 4'000; ++i) {
    const auto adjust = dcm_adjust(snapshot);
    ASSERT_TRUE(adjust);
    service->channels().timer_adjust_permil = *adjust;
    run(kMillisecond);
  }
  EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  EXPECT_NEAR(*dcm_adjust(snapshot), -0.035, 0.002) << "35 ppm";
}

TEST_F(DcmRun, DriftThatNobodyBalancesIsTheErrorThatSaysSo) {
  for (auto& slave : network.sim.slaves) slave.oscillator.ppm = 700;
  dcm().mode = DcmMode::kMasterShift;
  go_online();
  run(2 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).error_code, 0x981201CAU);
}

class DcmDcx : public DcmRun {
 protected:
  std::unique_ptr<sim::SimBus> other;  // the segment on the other side

  void SetUp() override {
    DcmRun::SetUp();
    network.add(test::bridge(), "sync-bridge");
    test::SimulatedNetwork other_network;
    other_network.add(test::io8());
    other_network.sim.slaves[0].oscillator.ppm = -25;
    auto made = sim::SimBus::create(other_network.sim, clock.now());
    ASSERT_TRUE(made);
    other = std::move(*made);
    dcm().mode = DcmMode::kDcx;
  }
  [[nodiscard]] Nanoseconds apart() {
    const auto theirs = static_cast<Nanoseconds>(other->system_time(0)),
               ours = static_cast<Nanoseconds>(bus->system_time(0));
    return dc::wrap_to_half(theirs - ours, kMillisecond);
  }
};

TEST_F(DcmDcx, TwoSegmentsKeepTheSameTimeThroughABridge) {
  network.sim.slaves.back().external_time = [this](Nanoseconds time) {
    other->advance_to(time);
    return std::optional(static_cast<Nanoseconds>(other->system_time(0)));
  };
  go_online();
  ASSERT_FALSE(error()) << error()->detail.text();
  run(30 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).error_code, 0U);
  EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  for (int i = 0; i < 500; ++i) {
    run(10 * kMillisecond);
    ASSERT_EQ(samples.back().external_error_ns, snapshot.dcm.external_error_ns) << i;
    other->advance_to(clock.now());
    bus->advance_to(clock.now());
    ASSERT_LT(std::abs(apart()), 1'000) << i;
  }
}

/// Both ways: it ends at the external clock and not behind it, no slave leaves a window of 127 ns on it, and it is told
/// as the way.
TEST_F(DcmDcx, TheWayToTheExternalClockEndsThere) {
  dcm().in_sync_limit = 4'000;
  network.project.master.dc.sync_window.enabled = true;
  for (const Nanoseconds away : {170 * kMicrosecond, -170 * kMicrosecond}) {
    SCOPED_TRACE(away);
    Nanoseconds phase = 0;
    network.sim.slaves.back().external_time = [&phase, away, this](Nanoseconds time) {
      if (phase == 0) phase = static_cast<Nanoseconds>(bus->system_time(0)) + away - time;
      return std::optional(time + phase);
    };
    go_online();
    ASSERT_FALSE(error()) << error()->detail.text();
    run(2 * kSecond);
    ASSERT_TRUE(snapshot.dcm.external_error_ns);
    EXPECT_EQ(snapshot.dcm.obstacle, dc::SyncObstacle::kToExternalClock);
    Nanoseconds farthest = 0;
    for (int i = 0; i < 350; ++i) {
      run(100 * kMillisecond);
      const Nanoseconds ahead = snapshot.dcm.external_error_ns.value_or(0);
      farthest = std::max(farthest, away > 0 ? ahead : -ahead);
      ASSERT_EQ(snapshot.dc.state, SyncState::kInSync) << i;
    }
    EXPECT_LT(farthest, 4'000) << "it does not go past it";
    EXPECT_NEAR(static_cast<double>(*snapshot.dcm.external_error_ns), 0, 100);
    EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  }
}

/// Its cable to the other network is unplugged: it shows the last time of it.
TEST_F(DcmDcx, ATimeThatStandsStillIsNoExternalClock) {
  Nanoseconds last = INT64_MAX;
  network.sim.slaves.back().external_time = [&last, this](Nanoseconds time) {
    other->advance_to(time);
    return std::optional(std::min(static_cast<Nanoseconds>(other->system_time(0)), last));
  };
  go_online();
  ASSERT_FALSE(error()) << error()->detail.text();
  run(30 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).state, SyncState::kInSync);
  last = static_cast<Nanoseconds>(other->system_time(0));
  run(2 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).error_code, dc::kDcxErrorNoExternalClock);
  EXPECT_FALSE(snapshot.dcm.external_error_ns);
  EXPECT_LT(std::abs(snapshot.dcm.error_ns), 4'000) << "the host stays with the reference clock";
  last = INT64_MAX;
  run(5 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).error_code, 0U);
  EXPECT_TRUE(snapshot.dcm.external_error_ns);
}

TEST_F(DcmDcx, ABridgeWithNobodyBehindItIsNoExternalClock) {
  go_online();
  ASSERT_FALSE(error()) << error()->detail.text();
  run(2 * kSecond);
  EXPECT_EQ(dcm_status(snapshot).error_code, dc::kDcxErrorNoExternalClock);
  EXPECT_NE(dcm_status(snapshot).state, SyncState::kInSync);
}

}  // namespace
}  // namespace syncline
