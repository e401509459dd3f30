// SPDX-License-Identifier: Apache-2.0
#include "tests/core/master/operation_bed.h"

#include <gmock/gmock.h>

#include <thread>

#include "findings/error_text.h"
#include "support/jitter_profile.h"

/// A bus that is led up and down: states, clocks, refusals.
namespace syncline {
namespace {

class OperationTest : public test::OperationBed {};

TEST_F(OperationTest, ReachesOpAndStaysThere) {
  make_service();
  link->record = true;
  go_online();
  EXPECT_FALSE(first_error()) << describe(first_error().value_or(Error{}));
  run(kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_TRUE(snapshot.online);
  EXPECT_EQ(snapshot.wkc_errors, 0U);
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_EQ(count(kind_of<events::Online>), 1U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(al_status(i), 8);
  // Every slave was led through all states once.
  const auto requests = requests_to(1);
  EXPECT_EQ(requests.back(), AlState::kOp);
  EXPECT_EQ(std::ranges::count(requests, AlState::kSafeop), 1);
}

TEST_F(OperationTest, TheFirstSlaveMayLead) {
  network.sim.slaves[0].dc.system_time = true;
  network.project.slaves[0].dc.op_mode.clear();
  network.project.master.dc.reference_clock = 0;
  go_online();
  ASSERT_EQ(snapshot.state, AlState::kOp);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(snapshot.slaves[i].is_reference_clock, i == 0) << i;
  EXPECT_TRUE(snapshot.slaves[0].dc_enabled);
}

TEST_F(OperationTest, TellsTheStartUpInTheOrderOfTheDocument) {
  network.project.master.dc.sync_window.enabled = true;
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
  EXPECT_EQ(link->get<std::uint32_t>(1, reg::kSystemTimeDelay), 0U);
  const auto hop = link->get<std::uint32_t>(2, reg::kSystemTimeDelay);
  EXPECT_NEAR(hop, link->bus().true_delay_ns(2) - link->bus().true_delay_ns(1), 40);
  const auto first = link->get<std::uint64_t>(1, reg::kStartTimeCyclicOperation);
  const auto second = link->get<std::uint64_t>(2, reg::kStartTimeCyclicOperation);
  EXPECT_GT(first, 0U);
  EXPECT_EQ(first % 1'000'000, second % 1'000'000);
  EXPECT_EQ(link->get<std::uint16_t>(1, reg::kCyclicUnitControl), 0x0300);
  EXPECT_EQ(snapshot.slaves[2].propagation_delay_ns, hop);
  EXPECT_TRUE(snapshot.slaves[1].is_reference_clock);
  EXPECT_FALSE(snapshot.slaves[0].dc_enabled);
}

TEST_F(OperationTest, AClockInFrontOfTheReferenceDoesNotSpoilTheSyncWindow) {
  network.project.master.dc.sync_window.enabled = true;
  network.sim.slaves[0].dc.system_time = true;
  go_online();
  ASSERT_EQ(config.dc.reference_clock, 1);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
}

TEST_F(OperationTest, PutsTheFrameWhereTheSetValueSays) {
  network.project.master.dc.dcm.set_value = 400'000;
  go_online();
  run(kSecond);
  const auto sync0 = static_cast<Nanoseconds>(link->get<std::uint64_t>(1, reg::kStartTimeCyclicOperation));
  const auto& last = samples.back();
  ASSERT_NE(last.flags & CycleSample::kReferenceValid, 0);
  const auto distance = ((sync0 - last.reference_time) % 1'000'000 + 1'000'000) % 1'000'000;
  EXPECT_NEAR(static_cast<double>(distance), 400'000, 4'000);
}

TEST_F(OperationTest, MasterShiftFollowsAFastReferenceClock) {
  network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  network.sim.slaves[1].oscillator.ppm = network.sim.slaves[2].oscillator.ppm = 80;
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
  EXPECT_FALSE(snapshot.slaves[0].sm2_missed.valid);
  const auto before = snapshot.slaves[2].sm2_missed.value;
  samples.clear();
  link->lose(3);
  run(500 * kMillisecond);
  EXPECT_EQ(snapshot.slaves[2].sm2_missed.value, before + 3);
  const auto told = std::find_if(samples.rbegin(), samples.rend(), [](const auto& s) { return s.sm2_position == 2; });
  ASSERT_NE(told, samples.rend());
  EXPECT_EQ(told->slave_sm2_missed, 3U) << "those from before OP are no misses of this run";
}

/// It is told so before it is asked for SAFEOP.
TEST_F(OperationTest, RunsTheCoeStartUpCommandsBeforeSafeop) {
  network.project.slaves[1].startup.push_back({{Transition::kPS}, 0x6060, 0, {8}, false, false, true, 0, "CSP"});
  make_service();
  link->record = true;
  go_online();
  EXPECT_FALSE(first_error());
  std::optional<std::size_t> written, asked;
  for (std::size_t i = 0; i < link->sent.size(); ++i) {
    FrameReader reader(link->sent[i]);
    while (const auto datagram = reader.next()) {
      const auto& header = datagram->header;
      if (header.command != Command::kFpwr || header.adp() != config.slaves[1].station_address) continue;
      // Behind the mailbox and CoE headers: a download of one byte, its object and value.
      const std::vector<std::uint8_t> wanted{0x2F, 0x60, 0x60, 0x00, 8};
      if (header.ado() == network.project.slaves[1].device.sync_managers[0].start_address &&
          std::ranges::equal(datagram->data.subspan(8, wanted.size()), wanted))
        written = i;
      if (header.ado() == reg::kAlControl && al_state_of(datagram->data[0]) == AlState::kSafeop) asked = i;
    }
  }
  ASSERT_TRUE(written && asked);
  EXPECT_LT(*written, *asked);
}

TEST_F(OperationTest, SaysWhichCodeASlaveRefusesWith) {
  auto& refusal = fault(FaultKind::kRefuseState, 2, 0);
  refusal.state = AlState::kSafeop;
  refusal.code = 0x001D;
  refusal.until = kLater;
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kAlState);
  EXPECT_EQ(first_error()->extra, 0x001D);
  const auto event = std::ranges::find_if(events, [](const Event& e) { return e.is<events::AlStatusError>(); });
  ASSERT_NE(event, events.end());
  EXPECT_EQ(event->slave, 2);
  EXPECT_EQ(event->as<events::AlStatusError>()->al_status_code, 0x001D);
  // The others finished the step; the bus stays online to be looked at, and goes on when it is cured.
  EXPECT_EQ(al_status(1), 4);
  EXPECT_TRUE(service->online());
  EXPECT_EQ(snapshot.state, AlState::kPreop);
  run_until(kLater + kMillisecond);
  events.clear();
  service->channels().commands.push(RequestStateCommand{AlState::kOp});
  run_to(AlState::kOp);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.state, AlState::kOp);
}

TEST_F(OperationTest, GoesDownAndUpAgainOnRequest) {
  go_online();
  for (const auto state : {AlState::kPreop, AlState::kOp, AlState::kSafeop, AlState::kInit, AlState::kOp}) {
    service->channels().commands.push(RequestStateCommand{state});
    run_to(state);
    EXPECT_FALSE(first_error()) << static_cast<int>(state);
    EXPECT_EQ(snapshot.state, state);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(al_status(i), static_cast<std::uint16_t>(state));
  }
}

TEST_F(OperationTest, EachCommandIsAnsweredWhenItIsDone) {
  auto& refusal = fault(FaultKind::kRefuseState, 2);
  refusal.state = AlState::kSafeop;
  refusal.code = 0x001D;
  refusal.until = kLater + 10 * kSecond;
  make_service();
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
  run_until(kLater + kMillisecond);
  EXPECT_FALSE(ask(RequestStateCommand{AlState::kPreop}));
  EXPECT_TRUE(ask(RequestStateCommand{AlState::kSafeop}));
  for (const MasterCommand& command : {MasterCommand(ClearStatisticsCommand{}), MasterCommand(ResetDcmStatusCommand{}),
                                       MasterCommand(WatchCommand{}), MasterCommand(ReleaseOutputCommand{0, 1}),
                                       MasterCommand(ReleaseAllOutputsCommand{}), MasterCommand(GoOfflineCommand{})}) {
    EXPECT_FALSE(ask(command)) << command.index();
  }
  EXPECT_FALSE(service->online());
}

TEST_F(OperationTest, GoesOfflineInInit) {
  go_online();
  go_offline();
  EXPECT_FALSE(snapshot.online);
  EXPECT_EQ(count(kind_of<events::Offline>), 1U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(al_status(i), 1);
}

TEST_F(OperationTest, WhoDoesNotComeToInitIsNamedWithItsState) {
  fault(FaultKind::kStopApplication, 2).until = kLater + 60 * kSecond;
  go_online();
  run_until(kLater + kMillisecond);
  events.clear();
  go_offline();
  std::vector<Error> told;
  for (const auto& event : events) {
    if (const auto* failure = event.as<events::Failure>()) told.push_back(failure->error);
  }
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().code, ErrorCode::kAlTimeout);
  EXPECT_THAT(told.back().subject, testing::HasSubstr("slave 2"));
  EXPECT_EQ(told.back().expected, static_cast<std::int64_t>(AlState::kInit));
  EXPECT_EQ(told.back().received, al_status(2));
  EXPECT_NE(al_state_of(al_status(2)), AlState::kInit);
}

TEST_F(OperationTest, CancelEndsABringUpAndTakesTheBusDown) {
  make_service();
  // While the DCM settles: cyclic operation has begun, the slaves are in PREOP.
  link->on_frame = [this] {
    if (al_status(1) == 2) service->channels().cancel = true;
  };
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kCancelled);
  EXPECT_FALSE(service->online());
  EXPECT_FALSE(snapshot.online);
  EXPECT_EQ(count(kind_of<events::Offline>), 1U);
  EXPECT_EQ(al_status(1), 1);
  EXPECT_FALSE(service->channels().cancel);
}

TEST_F(OperationTest, AThreadOfItsOwnDoesTheSame) {
  make_service();
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
  make_service();
  link->record = true;
  go_online(AlState::kPreop);
  EXPECT_FALSE(first_error());
  EXPECT_EQ(snapshot.state, AlState::kPreop);
  EXPECT_EQ(std::ranges::count(requests_to(1), AlState::kSafeop), 0);
}

TEST_F(OperationTest, RefusesABusOfAnotherSize) {
  network.sim.slaves.pop_back();
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

/// Where to look for who is missing: at the port of the one before it.
TEST_F(OperationTest, SaysWhereAMissingSlaveShouldHang) {
  network.sim.slaves.resize(1);
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_THAT(describe(*first_error()), testing::HasSubstr("should hang at port C of slave 0"));
  std::string all;
  for (const auto& event : events) {
    if (const auto* failure = event.as<events::Failure>()) all += describe(failure->error) + "\n";
  }
  EXPECT_THAT(all, testing::HasSubstr("should hang at port B of slave 1"));
}

TEST_F(OperationTest, RefusesAnotherDevice) {
  network.sim.slaves[1].device.identity = {0x5C17, 0xBAD, 1, 0};
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kIdentityMismatch);
  EXPECT_NE(first_error()->subject.find("slave 1"), std::string::npos);
  EXPECT_FALSE(service->online());
}

TEST_F(OperationTest, AReferenceClockWithoutSystemTimeIsReplacedByTheNextOne) {
  network.sim.slaves[1].dc.system_time = false;
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
  network.sim.slaves[1].dc.system_time = network.sim.slaves[2].dc.system_time = false;
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kDcSetup);
  EXPECT_NE(first_error()->subject.find("slave 1"), std::string::npos);
  EXPECT_FALSE(service->online());
}

/// Each of the writes counts, not only the first.
TEST_F(OperationTest, NamesTheClockThatDoesNotTakeItsOffset) {
  make_service();
  link->on_reply = [this](DatagramView& reply) {
    const bool offset = reply.header.command == Command::kFpwr && reply.header.ado() == reg::kSystemTimeOffset;
    if (offset && reply.header.adp() == config.slaves[2].station_address) reply.set_wkc(0);
  };
  go_online();
  ASSERT_TRUE(first_error());
  EXPECT_EQ(first_error()->code, ErrorCode::kDcSetup);
  EXPECT_NE(first_error()->subject.find("slave 2"), std::string::npos);
  EXPECT_THAT(describe(*first_error()), testing::HasSubstr("does not take its system time offset"));
}

/// Terminals: the drives' modes of operation need SYNC0.
TEST_F(OperationTest, RunsWithoutDistributedClocks) {
  network = {};
  for (int i = 0; i < 3; ++i) network.add(test::io8());
  network.project.master.dc.enabled = false;
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
  MasterService other(std::make_unique<test::SimulatedSegment>(other_clock, network.sim), other_clock);
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
