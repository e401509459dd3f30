// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "compile/compile.h"
#include "config/project.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "protocol/sii.h"
#include "support/jitter_profile.h"
#include "tests/support/event_match.h"
#include "tests/support/own_devices.h"
#include "tests/support/test_bus.h"

namespace syncline {
namespace {

std::vector<std::uint8_t> sii_of(const Identity& identity) {
  sii::Image image;
  image.vendor_id = identity.vendor_id;
  image.product_code = identity.product_code;
  image.revision_no = identity.revision_no;
  return sii::encode(image);
}

/// A coupler and two servo drives on a TestBus, taken online by a MasterService.
class OperationTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::TestBus* link = nullptr;
  std::unique_ptr<MasterService> service;
  Project project;
  NetworkConfig config;
  std::vector<Event> events;
  std::vector<CycleSample> samples;
  Snapshot snapshot;

  void SetUp() override {
    const std::array types{"SL-1100", "SL-SV7", "SL-SV7"};
    auto bus = std::make_unique<test::TestBus>(clock, types.size());
    link = bus.get();
    for (std::uint16_t i = 0; i < types.size(); ++i) {
      const auto description = sample::own(types[i]);
      ASSERT_NE(description.identity.vendor_id, 0U);
      project.slaves.push_back(default_slave(description, i));
      link->slave(i).sii = sii_of(description.identity);
      link->slave(i).has_mailbox = description.mailbox.has_value();
      link->slave(i).objects[0x1C320C] = {3, 0, 0, 0};
    }
    link->slave(0).has_system_time = false;
    project.master.dc.reference_clock = 1;
    project.master.dc.burst_total = 5000;
    service = std::make_unique<MasterService>(std::move(bus), clock);
    compile_project();
  }

  void compile_project() {
    auto result = compile(project);
    ASSERT_TRUE(result);
    config = std::move(result->config);
  }
  void go_online(AlState target = AlState::kOp) {
    service->channels().commands.push(GoOnlineCommand{config, target});
    ASSERT_TRUE(service->step());
    drain();
  }
  void drain() {
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().samples.pop(samples);
    service->channels().snapshot.read(snapshot);
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    drain();
  }
  [[nodiscard]] std::optional<Error> first_error() const {
    for (const auto& event : events) {
      if (const auto* failure = event.as<events::Failure>()) return failure->error;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t count(EventKind kind) const {
    return static_cast<std::size_t>(std::ranges::count(events, kind, [](const Event& e) { return e.kind(); }));
  }
  /// Over the counts in all events of a kind.
  template <class What>
  [[nodiscard]] std::int64_t sum() const {
    std::int64_t total = 0;
    for (const auto& event : events) {
      if (const auto* what = event.as<What>()) total += what->count;
    }
    return total;
  }
  [[nodiscard]] Nanoseconds time_of(EventKind kind) const {
    const auto found = std::ranges::find(events, kind, [](const Event& e) { return e.kind(); });
    return found == events.end() ? -1 : found->time;
  }
  [[nodiscard]] Nanoseconds time_of_state(AlState state) const {
    for (const auto& event : events) {
      if (event.slave < 0 && test::with(&events::StateChanged::to, state)(event)) return event.time;
    }
    return -1;
  }
};

TEST_F(OperationTest, ReachesOpAndStaysThere) {
  go_online();
  EXPECT_FALSE(first_error()) << static_cast<int>(first_error()->code) << first_error()->subject
                              << first_error()->detail.text();
  run(kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_TRUE(snapshot.online);
  EXPECT_EQ(snapshot.wkc_errors, 0U);
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_EQ(count(kind_of<events::Online>), 1U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(link->slave(i).get<std::uint16_t>(reg::kAlStatus), 8);
  // Every slave was led through all states once.
  EXPECT_EQ(link->slave(1).requests.back(), AlState::kOp);
  EXPECT_EQ(std::ranges::count(link->slave(1).requests, AlState::kSafeop), 1);
}

TEST_F(OperationTest, TellsTheStartUpInTheOrderOfTheDocument) {
  project.master.dc.sync_window.enabled = true;
  compile_project();
  go_online();
  const auto init = time_of_state(AlState::kInit), slaves = time_of(kind_of<events::SlavesInSync>),
             clocks = time_of(kind_of<events::DcInitialised>), master = time_of(kind_of<events::MasterInSync>),
             preop = time_of_state(AlState::kPreop), safeop = time_of_state(AlState::kSafeop),
             op = time_of_state(AlState::kOp);
  ASSERT_GE(init, 0);
  EXPECT_LT(init, slaves);
  EXPECT_LE(slaves, clocks);
  EXPECT_LT(clocks, preop);
  EXPECT_LT(preop, safeop);
  EXPECT_LT(master, safeop);
  EXPECT_LT(safeop, op);
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
  EXPECT_TRUE(snapshot.dc.monitored);
}

TEST_F(OperationTest, SendsCyclicFramesWithoutAPauseWhileItBringsUp) {
  go_online();
  ASSERT_GT(samples.size(), 1500U);  // the settle time of the DCM alone
  for (std::size_t i = 1; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i].cycle, samples[i - 1].cycle + 1);
    ASSERT_LT(samples[i].send_time - samples[i - 1].send_time, 1'100'000);
  }
}

TEST_F(OperationTest, WritesOffsetsDelaysAndOneStartGrid) {
  go_online();
  EXPECT_EQ(link->slave(1).get<std::uint32_t>(reg::kSystemTimeDelay), 0U);
  const auto hop = link->slave(2).get<std::uint32_t>(reg::kSystemTimeDelay);
  EXPECT_NEAR(hop, 500, 21);  // the bus has no processing delay, the rule counts on 40 ns
  const auto first = link->slave(1).get<std::uint64_t>(reg::kStartTimeCyclicOperation);
  const auto second = link->slave(2).get<std::uint64_t>(reg::kStartTimeCyclicOperation);
  EXPECT_GT(first, 0U);
  EXPECT_EQ(first % 1'000'000, second % 1'000'000);
  EXPECT_EQ(link->slave(1).get<std::uint16_t>(reg::kCyclicUnitControl), 0x0300);
  EXPECT_EQ(snapshot.slaves[2].propagation_delay_ns, hop);
  EXPECT_TRUE(snapshot.slaves[1].is_reference_clock);
  EXPECT_FALSE(snapshot.slaves[0].dc_enabled);
}

TEST_F(OperationTest, AClockInFrontOfTheReferenceDoesNotSpoilTheSyncWindow) {
  project.master.dc.sync_window.enabled = true;
  link->slave(0).has_system_time = true;
  compile_project();
  ASSERT_EQ(config.dc.reference_clock, 1);
  go_online();
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
}

TEST_F(OperationTest, PutsTheFrameWhereTheSetValueSays) {
  project.master.dc.dcm.set_value = 400'000;
  compile_project();
  go_online();
  run(kSecond);
  const auto sync0 = static_cast<Nanoseconds>(link->slave(1).get<std::uint64_t>(reg::kStartTimeCyclicOperation));
  const auto& last = samples.back();
  ASSERT_NE(last.flags & CycleSample::kReferenceValid, 0);
  const auto distance = ((sync0 - last.reference_time) % 1'000'000 + 1'000'000) % 1'000'000;
  EXPECT_NEAR(static_cast<double>(distance), 400'000, 4'000);
}

TEST_F(OperationTest, MasterShiftFollowsAFastReferenceClock) {
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  link->slave(1).ppm = link->slave(2).ppm = 80;
  compile_project();
  go_online();
  run(2 * kSecond);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync);
  EXPECT_NEAR(snapshot.dcm.drift_ppm, 80, 1);
  EXPECT_LT(*snapshot.dcm.in_sync_after_ms, 2000);
  EXPECT_LT(snapshot.dcm.error_max_ns, 4000);
  // The period became shorter by the drift.
  const auto& a = samples[samples.size() - 1001];
  const auto& b = samples.back();
  EXPECT_NEAR(static_cast<double>(b.send_time - a.send_time), 1e9 * (1 - 80e-6), 2000);
}

/// A link without stamps of its own leaves those of the master.
TEST_F(OperationTest, EachCycleSaysWhoStampedIt) {
  go_online();
  run(500 * kMillisecond);
  ASSERT_GT(samples.size(), 100U);
  for (const auto& sample : samples) ASSERT_EQ(sample.stamped_by, StampSource::kSoftware) << sample.cycle;
}

TEST_F(OperationTest, ReadsTheSm2CounterWhereTheVendorHasIt) {
  go_online();
  run(500 * kMillisecond);
  EXPECT_TRUE(snapshot.slaves[1].sm2_missed.valid);
  EXPECT_EQ(snapshot.slaves[1].sm2_missed.sub_index, 0x0C);
  EXPECT_EQ(snapshot.slaves[2].sm2_missed.value, 3U);
  EXPECT_FALSE(snapshot.slaves[0].sm2_missed.valid);
  // Those from before OP are no misses of this run.
  EXPECT_TRUE(
      std::ranges::any_of(samples, [](const auto& s) { return s.sm2_position == 2 && s.slave_sm2_missed == 0; }));
}

TEST_F(OperationTest, RunsTheCoeStartUpCommandsBeforeSafeop) {
  project.slaves[1].startup.push_back({{Transition::kPS}, 0x6060, 0, {8}, false, false, true, 0, "CSP"});
  compile_project();
  go_online();
  EXPECT_EQ(link->slave(1).objects[0x606000], (std::vector<std::uint8_t>{8}));
}

TEST_F(OperationTest, SaysWhichCodeASlaveRefusesWith) {
  link->slave(2).refuse = {AlState::kSafeop, 0x001D};
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kAlState);
  EXPECT_EQ(first_error()->extra, 0x001D);
  const auto event = std::ranges::find_if(events, [](const Event& e) { return e.is<events::AlStatusError>(); });
  ASSERT_NE(event, events.end());
  EXPECT_EQ(event->slave, 2);
  EXPECT_EQ(event->as<events::AlStatusError>()->al_status_code, 0x001D);
  // The others finished the step; the bus stays online to be looked at, and goes on when it is cured.
  EXPECT_EQ(link->slave(1).get<std::uint16_t>(reg::kAlStatus), 4);
  EXPECT_TRUE(service->online());
  EXPECT_EQ(snapshot.state, AlState::kPreop);
  link->slave(2).refuse.reset();
  events.clear();
  service->channels().commands.push(RequestStateCommand{AlState::kOp});
  run(kSecond);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.state, AlState::kOp);
}

TEST_F(OperationTest, TellsASlaveThatLeavesOpByItself) {
  go_online();
  events.clear();
  link->slave(1).set<std::uint16_t>(reg::kAlStatus, 0x14);
  link->slave(1).set<std::uint16_t>(reg::kAlStatusCode, 0x001A);
  run(10 * kMillisecond);
  EXPECT_EQ(snapshot.state, AlState::kSafeop);
  EXPECT_EQ(snapshot.slaves[1].al_status_code, 0x001A);
  EXPECT_EQ(count(kind_of<events::AlStatusError>), 1U);
  run(100 * kMillisecond);
  EXPECT_EQ(count(kind_of<events::AlStatusError>), 1U);  // once
}

TEST_F(OperationTest, TellsLostSlavesAndWrongCounters) {
  go_online();
  events.clear();
  link->slave(2).present = false;
  run(50 * kMillisecond);
  EXPECT_EQ(count(kind_of<events::SlaveLost>), 1U);
  // Wrong until the lost slave is known as lost, then less is expected.
  EXPECT_EQ(count(kind_of<events::WkcError>), 2U);
  EXPECT_LE(snapshot.wkc_errors, 3U);
  EXPECT_EQ(count(kind_of<events::WkcExpected>), 1U);
  EXPECT_EQ(samples.back().wkc_expected, 3);
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected);
  EXPECT_FALSE(snapshot.slaves[2].present);
  link->slave(2).present = true;
  run(50 * kMillisecond);
  EXPECT_EQ(count(kind_of<events::SlaveFound>), 1U);
  EXPECT_EQ(count(kind_of<events::WkcExpected>), 2U);
  EXPECT_EQ(samples.back().flags & CycleSample::kWkcError, 0);
}

TEST_F(OperationTest, CountsLostFramesAndGoesOn) {
  go_online();
  link->lose(5);
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, 5U);
  EXPECT_EQ(sum<events::FramesLost>(), 5);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_EQ(snapshot.wkc_errors, 0U);
}

TEST_F(OperationTest, EachLostFrameIsInExactlyOneEvent) {
  go_online();
  samples.clear();
  const int losses[] = {1, 2, 1, 3, 2, 7, 1};
  int lost = 0;
  for (const int frames : losses) {
    link->lose(frames);
    run(30 * kMillisecond);
    lost += frames;
  }
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, static_cast<std::uint64_t>(lost));
  EXPECT_EQ(sum<events::FramesLost>(), lost);
  int in_samples = 0;
  for (const auto& sample : samples) in_samples += sample.frames_lost;
  EXPECT_EQ(in_samples, lost);
}

TEST_F(OperationTest, LossesAreToldToTheEndOfOperation) {
  go_online();
  link->lose(2);
  run(4 * kMillisecond);
  link->lose(3);
  run(4 * kMillisecond);
  service->channels().commands.push(GoOfflineCommand{});
  while (service->online() && service->step()) {
  }
  drain();
  EXPECT_EQ(snapshot.lost_frames, 5U);
  EXPECT_EQ(sum<events::FramesLost>(), 5);
}

TEST_F(OperationTest, AFrameThatComesAfterItsDeadlineIsLateAndNotLost) {
  go_online();
  samples.clear();
  link->hold_back(2, 2'500'000);
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_GE(snapshot.late_frames, 2U);
  EXPECT_EQ(count(kind_of<events::FramesLost>), 0U);
  EXPECT_EQ(sum<events::FramesLate>(), static_cast<std::int64_t>(snapshot.late_frames));
  const auto late =
      std::ranges::find_if(samples, [](const auto& s) { return (s.flags & CycleSample::kFrameLate) != 0; });
  ASSERT_NE(late, samples.end());
  EXPECT_NEAR(late->late_by_ns, 1'700'000, 20'000);
  EXPECT_GE(std::ranges::count_if(samples, [](const auto& s) { return s.frames_lost > 0; }), 1);
}

TEST_F(OperationTest, AStandstillOfTheHostIsCyclesLeftOut) {
  go_online();
  samples.clear();
  clock.advance_to(clock.now() + 20'300'000);
  run(200 * kMillisecond);
  EXPECT_NEAR(static_cast<double>(snapshot.skipped_cycles), 20, 1);
  EXPECT_EQ(snapshot.overruns, 1U);
  EXPECT_EQ(sum<events::CyclesLeftOut>(), static_cast<std::int64_t>(snapshot.skipped_cycles));
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front().skipped_cycles, snapshot.skipped_cycles);
  EXPECT_LT(samples.front().wake_lateness_ns, 500'000);
  // No two frames in one cycle afterwards.
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_GT(samples[i].send_time - samples[i - 1].send_time, 499'000);
}

TEST_F(OperationTest, GoesDownAndUpAgainOnRequest) {
  go_online();
  for (const auto state : {AlState::kPreop, AlState::kOp, AlState::kSafeop, AlState::kInit, AlState::kOp}) {
    service->channels().commands.push(RequestStateCommand{state});
    run(kSecond);
    EXPECT_FALSE(first_error()) << static_cast<int>(state);
    EXPECT_EQ(snapshot.state, state);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(link->slave(i).get<std::uint16_t>(reg::kAlStatus), static_cast<std::uint16_t>(state));
    }
  }
}

TEST_F(OperationTest, EachCommandIsAnsweredWhenItIsDone) {
  auto& commands = service->channels().commands;
  /// What it was refused for, if it was; and what was told of it as an event is the same.
  const auto ask = [&](MasterCommand command) -> std::optional<Error> {
    events.clear();
    const auto id = commands.ask(std::move(command));
    EXPECT_TRUE(id);
    EXPECT_FALSE(commands.take_answer()) << "nobody has looked at it";
    EXPECT_TRUE(service->step());
    drain();
    const auto answer = commands.take_answer();
    EXPECT_TRUE(answer && answer->id == id && answer->time == clock.now());
    if (!answer) return std::nullopt;
    EXPECT_EQ(answer->refused, first_error());
    return answer->refused;
  };
  for (const MasterCommand& command :
       {MasterCommand(RequestStateCommand{AlState::kOp}), MasterCommand(ConfigureDcmCommand{}),
        MasterCommand(CompensateDelaysCommand{}), MasterCommand(ForceOutputCommand{0, 1, 1})}) {
    const auto refused = ask(command);
    ASSERT_TRUE(refused) << command.index();
    EXPECT_THAT(describe(*refused), testing::HasSubstr("the bus is offline"));
  }
  EXPECT_FALSE(ask(GoOnlineCommand{config, AlState::kOp}));
  EXPECT_EQ(snapshot.state, AlState::kOp) << "answered when it is there";
  EXPECT_FALSE(ask(ForceOutputCommand{0, 1, 1}));
  EXPECT_TRUE(ask(ForceOutputCommand{0xFFFF, 1, 1})) << "beyond the image";
  DcmSettings wild;
  wild.gain_ppt = DcmSettings::kMaxGain + 1;
  EXPECT_TRUE(ask(ConfigureDcmCommand{wild}));
  link->slave(2).refuse = {AlState::kSafeop, 0x001D};
  EXPECT_TRUE(ask(RequestStateCommand{AlState::kSafeop}));
  link->slave(2).refuse.reset();
  for (const MasterCommand& command : {MasterCommand(ClearStatisticsCommand{}), MasterCommand(ResetDcmStatusCommand{}),
                                       MasterCommand(WatchCommand{}), MasterCommand(ReleaseOutputCommand{0, 1}),
                                       MasterCommand(ReleaseAllOutputsCommand{}), MasterCommand(GoOfflineCommand{})}) {
    EXPECT_FALSE(ask(command)) << command.index();
  }
  EXPECT_FALSE(service->online());
}

TEST_F(OperationTest, GoesOfflineInInit) {
  go_online();
  service->channels().commands.push(GoOfflineCommand{});
  while (service->online() && service->step()) {
  }
  drain();
  EXPECT_FALSE(snapshot.online);
  EXPECT_EQ(count(kind_of<events::Offline>), 1U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(link->slave(i).get<std::uint16_t>(reg::kAlStatus), 1);
}

TEST_F(OperationTest, DoesNotWaitForASlaveThatIsGone) {
  go_online();
  link->slave(2).present = false;
  run(50 * kMillisecond);
  service->channels().commands.push(GoOfflineCommand{});
  const auto before = clock.now();
  while (service->online() && service->step()) {
  }
  EXPECT_LT(clock.now() - before, kSecond);
  EXPECT_EQ(link->slave(1).get<std::uint16_t>(reg::kAlStatus), 1);
}

TEST_F(OperationTest, CancelEndsABringUpAndTakesTheBusDown) {
  // While the DCM settles: cyclic operation has begun, the slaves are in PREOP.
  link->on_frame = [this] {
    if (link->slave(1).get<std::uint16_t>(reg::kAlStatus) == 2) service->channels().cancel = true;
  };
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kCancelled);
  EXPECT_FALSE(service->online());
  EXPECT_FALSE(snapshot.online);
  EXPECT_EQ(count(kind_of<events::Offline>), 1U);
  EXPECT_EQ(link->slave(1).get<std::uint16_t>(reg::kAlStatus), 1);
  EXPECT_FALSE(service->channels().cancel);
}

TEST_F(OperationTest, AThreadOfItsOwnDoesTheSame) {
  service->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  MasterThread thread(*service);
  while (snapshot.state != AlState::kOp || count(kind_of<events::Online>) == 0) {
    drain();
    std::this_thread::yield();
  }
  service->channels().commands.push(GoOfflineCommand{});
  while (count(kind_of<events::Offline>) == 0) {
    drain();
    std::this_thread::yield();
  }
  thread.stop();
  drain();
  EXPECT_FALSE(first_error());
  EXPECT_FALSE(snapshot.online);
}

TEST_F(OperationTest, StopsAtTheRequestedState) {
  go_online(AlState::kPreop);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.state, AlState::kPreop);
  EXPECT_EQ(std::ranges::count(link->slave(1).requests, AlState::kSafeop), 0);
}

TEST_F(OperationTest, RefusesABusOfAnotherSize) {
  link->slave(2).present = false;
  go_online();
  // Who is missing, and then what that means.
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kSlaveMissing);
  EXPECT_NE(first_error()->subject.find("slave 2"), std::string::npos);
  const auto last =
      std::find_if(events.rbegin(), events.rend(), [](const Event& e) { return e.is<events::Failure>(); });
  EXPECT_EQ(last->as<events::Failure>()->error.code, ErrorCode::kSlaveCount);
  EXPECT_EQ(last->as<events::Failure>()->error.received, 2);
  EXPECT_FALSE(service->online());
  EXPECT_FALSE(snapshot.online);
}

TEST_F(OperationTest, RefusesAnotherDevice) {
  link->slave(1).sii = sii_of({0x5C17, 0xBAD, 1, 0});
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kIdentityMismatch);
  EXPECT_NE(first_error()->subject.find("slave 1"), std::string::npos);
  EXPECT_FALSE(service->online());
}

TEST_F(OperationTest, AReferenceClockWithoutSystemTimeIsReplacedByTheNextOne) {
  link->slave(1).has_system_time = false;
  go_online();
  const auto told = std::ranges::find_if(events, [](const Event& e) { return e.is<events::ReferenceClockChanged>(); });
  ASSERT_NE(told, events.end());
  EXPECT_EQ(told->slave, 1);
  EXPECT_EQ(told->as<events::ReferenceClockChanged>()->what, events::ReferenceClockChanged::What::kNoSystemTime);
  EXPECT_EQ(snapshot.dc.reference_clock, 2);
  // It is a drive that cannot do without SYNC0, and that is the error; the other one has its clock.
  ASSERT_TRUE(first_error());
  EXPECT_NE(first_error()->subject.find("slave 1"), std::string::npos);
  EXPECT_EQ(snapshot.slaves[1].al_status & 0x0F, 2);
  EXPECT_EQ(snapshot.slaves[2].al_status, 4);
}

TEST_F(OperationTest, RefusesDistributedClocksThatNobodyCanLead) {
  link->slave(1).has_system_time = link->slave(2).has_system_time = false;
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kDcSetup);
  EXPECT_NE(first_error()->subject.find("slave 1"), std::string::npos);
  EXPECT_FALSE(service->online());
}

TEST_F(OperationTest, RunsWithoutDistributedClocks) {
  project.master.dc.enabled = false;
  compile_project();
  go_online();
  EXPECT_FALSE(first_error());
  run(100 * kMillisecond);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_FALSE(snapshot.dc.enabled);
  EXPECT_EQ(samples.back().flags & CycleSample::kReferenceValid, 0);
}

TEST_F(OperationTest, IsTheSameEveryTime) {
  clock.set_wakeup_jitter(JitterProfile::desktop(), 5);
  go_online();
  run(kSecond);
  VirtualClock other_clock;
  other_clock.set_wakeup_jitter(JitterProfile::desktop(), 5);
  auto bus = std::make_unique<test::TestBus>(other_clock, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    bus->slave(i).sii = link->slave(i).sii;
    bus->slave(i).has_mailbox = link->slave(i).has_mailbox;
    bus->slave(i).has_system_time = link->slave(i).has_system_time;
    bus->slave(i).objects[0x1C320C] = {3, 0, 0, 0};
  }
  MasterService other(std::move(bus), other_clock);
  other.channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  ASSERT_TRUE(other.step());
  other.run_for(kSecond);
  std::vector<CycleSample> again;
  other.channels().samples.pop(again);
  ASSERT_EQ(again.size(), samples.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    ASSERT_EQ(again[i].send_time, samples[i].send_time);
    ASSERT_EQ(again[i].reference_time, samples[i].reference_time);
    ASSERT_EQ(again[i].dcm_error_ns, samples[i].dcm_error_ns);
  }
}

}  // namespace
}  // namespace syncline
