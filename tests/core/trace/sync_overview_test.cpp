// SPDX-License-Identifier: Apache-2.0
#include "trace/sync_overview.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "config/network_config.h"

namespace syncline {
namespace {

constexpr Nanoseconds kStart = 830'000'000 * kSecond;
Nanoseconds at(std::int64_t ms) { return kStart + ms * kMillisecond; }

CycleSample sample(std::int64_t ms, SyncState state, std::uint32_t deviation = 10, std::int32_t error = 5) {
  CycleSample s;
  s.cycle = static_cast<std::uint64_t>(ms);
  s.send_time = at(ms);
  s.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.master_state = static_cast<std::uint8_t>(AlState::kOp);
  s.slaves_sync = s.master_sync = state;
  s.deviation_ns = deviation;
  s.dcm_error_ns = error;
  return s;
}
void feed(OverviewRecorder& recorder, const CycleSample& one) { recorder.add(std::span(&one, 1)); }

TEST(SyncOverview, BringUpIsNoPartOfTheFigures) {
  OverviewRecorder recorder(2);
  for (int ms = 0; ms < 100; ++ms) feed(recorder, sample(ms, SyncState::kBusy, 90'000, -70'000));
  EXPECT_FALSE(recorder.overview().armed);
  EXPECT_EQ(recorder.overview().deviation.statistics.count(), 0U);
  EXPECT_EQ(recorder.overview().deviation.now->value, 90'000) << "it is shown all the same";
  for (int ms = 100; ms < 200; ++ms) feed(recorder, sample(ms, SyncState::kInSync, 20, ms % 2 == 0 ? 40 : -40));
  const auto& overview = recorder.overview();
  EXPECT_EQ(overview.armed, at(100));
  EXPECT_EQ(overview.deviation.statistics.count(), 100U);
  EXPECT_EQ(overview.deviation.statistics.mean(), 20);
  EXPECT_NEAR(overview.dcm_error.statistics.mean(), 0, 1e-9);
  EXPECT_EQ(overview.dcm_error.statistics.rms(), 40);
  EXPECT_EQ(overview.dcm_error.magnitudes.percentile(0.9999), 40);
}

TEST(SyncOverview, WhatIsOredIsAnUpperEstimate) {
  OverviewRecorder recorder(2);
  const auto feed_ored = [&](std::int64_t ms, std::uint32_t ored) {
    auto one = sample(ms, SyncState::kInSync, 12);
    one.flags |= CycleSample::kDeviationValid;
    one.deviation_ored_ns = ored;
    feed(recorder, one);
  };
  for (int ms = 0; ms < 100; ++ms) feed_ored(ms, ms % 5 == 0 ? 12 : 15);
  EXPECT_FALSE(recorder.overview().is_deviation_ored()) << "the same now and then";
  recorder.arm();
  EXPECT_FALSE(recorder.overview().is_deviation_ored()) << "nothing is known since";
  for (int ms = 100; ms < 200; ++ms) feed_ored(ms, 12);
  EXPECT_TRUE(recorder.overview().is_deviation_ored());
  recorder.arm();
  for (int ms = 200; ms < 300; ++ms) feed(recorder, sample(ms, SyncState::kInSync, 12));
  EXPECT_FALSE(recorder.overview().is_deviation_ored()) << "nobody has or-ed anything";
}

TEST(SyncOverview, ALampSaysSinceWhenAndWhenItWasLost) {
  OverviewRecorder recorder(1);
  for (int ms = 0; ms < 10; ++ms) feed(recorder, sample(ms, SyncState::kBusy));
  for (int ms = 10; ms < 20; ++ms) feed(recorder, sample(ms, SyncState::kInSync));
  EXPECT_EQ(recorder.overview().slaves.since, at(10));
  EXPECT_FALSE(recorder.overview().slaves.last_lost) << "to get in sync is no loss";
  for (int ms = 20; ms < 30; ++ms) feed(recorder, sample(ms, SyncState::kOutOfSync));
  for (int ms = 30; ms < 40; ++ms) feed(recorder, sample(ms, SyncState::kInSync));
  const auto& lamp = recorder.overview().slaves;
  EXPECT_EQ(lamp.state, SyncState::kInSync);
  EXPECT_EQ(lamp.since, at(30));
  EXPECT_EQ(lamp.last_lost, at(20));
  EXPECT_EQ(lamp.times_lost, 1U);
}

CycleSample read_of(std::int64_t ms, int slave, SyncState state = SyncState::kInSync) {
  auto one = sample(ms, state);
  one.slave_position = static_cast<std::int16_t>(slave);
  one.flags |= CycleSample::kSlaveFollows;
  return one;
}

/// The verdict speaks of those who answer; that one of them has gone is no less a loss, and what is said of all begins
/// when it is within the window again.
TEST(SyncOverview, WhoFollowsAndFallsSilentIsALoss) {
  OverviewRecorder recorder(4);
  for (int ms = 0; ms < 100; ++ms) feed(recorder, read_of(ms, 1 + ms % 2));
  const auto& lamp = recorder.overview().slaves;
  EXPECT_EQ(lamp.of_all_since(), at(0));
  recorder.add(Event{at(90), 3, events::SlaveLost{}});
  EXPECT_EQ(lamp.times_any_lost(), 0U) << "it follows no clock";
  EXPECT_FALSE(lamp.any_lost());
  recorder.add(Event{at(95), 1, events::SlaveLost{}});
  recorder.add(Event{at(95), 2, events::SlaveLost{}});
  EXPECT_EQ(lamp.times_any_lost(), 1U) << "they went together";
  EXPECT_EQ(lamp.any_lost(), at(95));
  for (int ms = 100; ms < 200; ++ms) feed(recorder, read_of(ms, 1));
  recorder.add(Event{at(160), 1, events::SlavesInSync{}});
  EXPECT_EQ(lamp.of_all_since(), at(0)) << "the other one is away";
  recorder.add(Event{at(190), 2, events::SlavesInSync{}});
  EXPECT_EQ(lamp.of_all_since(), at(190));
  for (int ms = 200; ms < 210; ++ms) feed(recorder, sample(ms, SyncState::kOutOfSync));
  EXPECT_EQ(lamp.of_all_since(), at(200)) << "of another state it is since that";
  EXPECT_EQ(lamp.any_lost(), at(200));
  EXPECT_EQ(lamp.times_any_lost(), 2U);
  recorder.arm();
  EXPECT_EQ(lamp.times_any_lost(), 0U);
}

TEST(SyncOverview, WhoMayBeAwayIsNoLoss) {
  NetworkConfig config;
  config.slaves.resize(3);
  config.slaves[1].hot_connect.emplace();
  config.slaves[1].hot_connect->member_count = 1;
  OverviewRecorder recorder(config);
  for (int ms = 0; ms < 100; ++ms) feed(recorder, read_of(ms, 1 + ms % 2));
  recorder.add(Event{at(95), 1, events::SlaveLost{}});
  EXPECT_EQ(recorder.overview().slaves.times_any_lost(), 0U);
  recorder.add(Event{at(96), 2, events::SlaveLost{}});
  EXPECT_EQ(recorder.overview().slaves.times_any_lost(), 1U);
}

/// From when its run was armed last on all is judged, in sync or not, and nothing of before; until then as the run was,
/// which had armed itself.
TEST(SyncOverview, OfARecordingItIsArmedWhenItsRunWas) {
  OverviewRecorder recorder(1);
  recorder.arm_from(at(10));
  for (int ms = 0; ms < 10; ++ms) feed(recorder, sample(ms, ms < 3 ? SyncState::kBusy : SyncState::kInSync, 900));
  EXPECT_EQ(recorder.overview().armed, at(3));
  EXPECT_EQ(recorder.overview().deviation.largest->value, 900);
  for (int ms = 10; ms < 20; ++ms) feed(recorder, sample(ms, SyncState::kOutOfSync, 20));
  EXPECT_EQ(recorder.overview().armed, at(10));
  EXPECT_EQ(recorder.overview().deviation.largest->value, 20);
  recorder.add(Event{at(15), 0, events::SlaveLost{}});
  EXPECT_EQ(recorder.overview().faults.count(), 1U);
  OverviewRecorder later(1);
  later.arm_from(at(10));
  feed(later, sample(50, SyncState::kOutOfSync));
  EXPECT_EQ(later.overview().armed, at(50)) << "of what was before nothing is known";
  OverviewRecorder never(1);
  never.arm_from(std::numeric_limits<Nanoseconds>::max());
  feed(never, sample(50, SyncState::kInSync));
  EXPECT_FALSE(never.overview().armed) << "it was held against something else at its end";
}

TEST(SyncOverview, NothingWasLostByWhatWasSetAnew) {
  OverviewRecorder recorder(1);
  for (int ms = 0; ms < 10; ++ms) feed(recorder, sample(ms, SyncState::kInSync));
  recorder.disarm(at(11));
  EXPECT_FALSE(recorder.overview().armed);
  for (int ms = 10; ms < 12; ++ms) feed(recorder, sample(ms, SyncState::kInSync));  // from before
  for (int ms = 12; ms < 20; ++ms) feed(recorder, sample(ms, SyncState::kBusy));
  for (int ms = 20; ms < 30; ++ms) feed(recorder, sample(ms, SyncState::kInSync));
  EXPECT_EQ(recorder.overview().armed, at(20));
  EXPECT_EQ(recorder.overview().master.times_lost, 0U);
  EXPECT_FALSE(recorder.overview().master.last_lost);
}

/// Single cycles far over the limit are borne, and so is what the controller has made of them until it has lasted.
TEST(SyncOverview, TheMasterHasTheMarginOfTheFilteredErrorThatLasted) {
  OverviewRecorder recorder(1);
  std::int64_t ms = 0;
  const auto go = [&](int cycles, std::int32_t filtered) {
    for (int i = 0; i < cycles; ++i) {
      auto one = sample(ms++, SyncState::kInSync, 10, 65'000);
      one.dcm_error_filtered_ns = i % 2 == 0 ? filtered : -filtered;
      feed(recorder, one);
    }
  };
  go(200, 3'000);
  EXPECT_FALSE(recorder.overview().dcm_lasting.margin(4'000)) << "too short yet";
  go(2, 3'000);
  EXPECT_EQ(*recorder.overview().dcm_lasting.margin(4'000), 0.25);
  EXPECT_LT(*recorder.overview().dcm_error.margin(4'000), 0);
  go(200, 5'000);
  EXPECT_EQ(*recorder.overview().dcm_lasting.margin(4'000), 0.25) << "a tail of 199 ms is no loss";
  go(1, 100);
  go(201, 5'000);
  EXPECT_EQ(*recorder.overview().dcm_lasting.margin(4'000), -0.25) << "the verdict has lost it by now";
  recorder.arm();
  EXPECT_FALSE(recorder.overview().dcm_lasting.margin(4'000)) << "it begins anew with the others";
}

/// A slave that is away takes the master out of OP, and the clocks of the others still count.
TEST(SyncOverview, EveryCycleCountsAlsoBelowOpOnceItWasArmed) {
  OverviewRecorder recorder(1);
  const auto below_op = [&](std::int64_t ms, SyncState state, std::uint32_t deviation) {
    auto one = sample(ms, state, deviation);
    one.master_state = static_cast<std::uint8_t>(AlState::kNone);
    feed(recorder, one);
  };
  for (int ms = 0; ms < 10; ++ms) below_op(ms, SyncState::kInSync, 70);
  EXPECT_EQ(recorder.overview().deviation.statistics.count(), 0U) << "of the bring-up";
  for (int ms = 10; ms < 20; ++ms) feed(recorder, sample(ms, SyncState::kInSync, 20));
  for (int ms = 20; ms < 30; ++ms) below_op(ms, SyncState::kInSync, 30);
  below_op(30, SyncState::kOutOfSync, 48'502);
  const auto& deviation = recorder.overview().deviation;
  EXPECT_EQ(deviation.statistics.count(), 21U);
  EXPECT_EQ(deviation.largest->value, 48'502);
  for (int ms = 31; ms < 40; ++ms) below_op(ms, SyncState::kBusy, 900'000);
  EXPECT_EQ(deviation.largest->value, 48'502) << "who is brought up again has yet to settle";
  for (int ms = 40; ms < 50; ++ms) below_op(ms, SyncState::kUnknown, 900'000);
  EXPECT_EQ(deviation.largest->value, 48'502) << "of what is unknown nothing is claimed";
}

TEST(SyncOverview, TheMarginIsWhatTheLargestHasLeft) {
  OverviewRecorder recorder(1);
  feed(recorder, sample(0, SyncState::kInSync, 100, -300));
  feed(recorder, sample(1, SyncState::kInSync, 50, 100));
  const auto& overview = recorder.overview();
  EXPECT_DOUBLE_EQ(*overview.deviation.margin(400), 0.75);
  EXPECT_DOUBLE_EQ(*overview.dcm_error.margin(200), -0.5);
  EXPECT_EQ(overview.dcm_error.largest->value, -300);
  EXPECT_EQ(overview.dcm_error.largest->time, at(0));
  EXPECT_FALSE(overview.deviation.margin(0)) << "without a limit there is none";
}

TEST(SyncOverview, MissedEventsAreCountedFromWhenItWasArmed) {
  OverviewRecorder recorder(2);
  auto read = [&](std::int64_t ms, SyncState state, std::uint32_t total) {
    auto s = sample(ms, state);
    s.sm2_position = 1;
    s.slave_sm2_missed = total;
    feed(recorder, s);
  };
  read(0, SyncState::kBusy, 100);
  read(1, SyncState::kBusy, 140);
  read(2, SyncState::kInSync, 140);
  EXPECT_EQ(recorder.overview().missed.count, 0U);
  read(3, SyncState::kInSync, 143);
  read(4, SyncState::kInSync, 2);  // somebody cleared it
  EXPECT_EQ(recorder.overview().missed.count, 5U);
  EXPECT_EQ(recorder.overview().missed.by_slave[1], 5U);
  EXPECT_EQ(recorder.overview().missed.last, at(4));
  ASSERT_EQ(recorder.overview().faults.episodes().size(), 1U);
  EXPECT_EQ(recorder.overview().faults.episodes().front().faults.front().count, 5U);
  recorder.arm();
  EXPECT_EQ(recorder.overview().missed.count, 0U);
  EXPECT_TRUE(recorder.overview().faults.episodes().empty());
}

/// However they arrive, the first is the first; what is like it is one row.
TEST(FaultLog, SaysWhatCameFirstAndWhatFollowed) {
  FaultLog log;
  log.add({at(12), -1, events::WkcError{6, 3, 1}});
  log.add({at(10), 2, events::SlaveLost{}});
  log.add({at(14), -1, events::SlavesOutOfSync{900, 1}});
  log.add({at(500), -1, events::WkcError{6, 3, 9}});
  log.add({at(700), 2, events::SlaveFound{}});  // good news
  log.add_missed(at(13), 1, 3);
  ASSERT_EQ(log.episodes().size(), 1U);
  const auto& episode = log.episodes().front();
  ASSERT_EQ(episode.faults.size(), 4U);
  EXPECT_TRUE(episode.faults[0].event->is<events::SlaveLost>());
  EXPECT_EQ(episode.faults[1].count, 2U);
  EXPECT_EQ(episode.faults[1].last, at(500));
  EXPECT_FALSE(episode.faults[2].event);
  EXPECT_EQ(episode.begin, at(10));
  EXPECT_EQ(episode.end, at(500));
}

/// What frames show first is not the cause, where the cable is found within the same moment.
TEST(FaultLog, LeadsWithTheCauseOfTheSameMoment) {
  FaultLog log;
  log.add({at(10), -1, events::WkcError{15, 12, 1}});
  log.add({at(11), 5, events::SlaveLost{}});
  log.add({at(11), 5, events::CableChanged{}});
  log.add({at(900), 2, events::CableChanged{}});
  const auto leading = [&] { return log.episodes().back().leading(); };
  ASSERT_EQ(log.episodes().size(), 1U);
  EXPECT_EQ(log.episodes().front().faults[leading()].slave, 5);
  EXPECT_TRUE(log.episodes().front().faults[leading()].event->is<events::CableChanged>());
  log.add({at(5000), -1, events::WkcError{15, 12, 1}});
  log.add({at(5100), 5, events::CableChanged{}});
  EXPECT_EQ(leading(), 0U) << "too late to be the cause of it";
  log.add({at(12'000), -1, events::DcmError{}});
  log.add({at(12'000), -1, events::MasterOutOfSync{}});
  EXPECT_EQ(leading(), 1U) << "the loss says why, the code does not";
  log.add({at(12'001), -1, events::CyclesLeftOut{}});
  EXPECT_EQ(leading(), 2U);
  log.add({at(30'000), -1, events::FramesLost{1}});
  log.add({at(30'060), 4, events::PortErrors{0, 1, 0, at(30'010)}});
  EXPECT_EQ(leading(), 0U) << "it was clean when the frame was lost";
  log.add({at(40'000), -1, events::FramesLost{1}});
  log.add({at(40'060), 3, events::PortErrors{1, 0, 1, at(39'900)}});
  log.add({at(40'061), 4, events::PortErrors{0, 1, 0, at(39'901)}});
  EXPECT_EQ(leading(), 2U) << "the frame was lost between the two readings of the port that damaged one";
  log.add({at(50'000), 3, events::AlStatusError{}});
  log.add({at(50'001), 3, events::CableChanged{}});
  EXPECT_EQ(leading(), 0U) << "a slave that says something itself came first";
}

TEST(FaultLog, KnowsWhatStillLastsAndSinceWhenItDoesNot) {
  FaultLog log;
  log.add({at(10), 5, events::CableChanged{}});
  log.add({at(11), 5, events::SlaveLost{}});
  log.add({at(11), 6, events::SlaveLost{}});
  log.add({at(12), -1, events::WkcError{15, 12, 1}});
  ASSERT_EQ(log.lasting().size(), 3U) << "a working counter is a moment";
  log.add({at(2000), 5, events::CableChanged{.healed = true}});
  log.add({at(2010), 5, events::SlaveFound{}});
  ASSERT_EQ(log.lasting().size(), 1U);
  EXPECT_EQ(log.lasting().front()->slave, 6);
  EXPECT_EQ(log.episodes().front().faults.front().over, at(2000));
  log.add({at(2020), 5, events::SlaveLost{}});
  EXPECT_EQ(log.lasting().size(), 2U) << "it went again";
}

TEST(FaultLog, WhatIsOverIsAReturnToOrder) {
  const auto meaning = [](auto what) { return meaning_of(Event{at(0), 1, std::move(what)}); };
  EXPECT_EQ(meaning(events::CableChanged{.healed = true}), EventMeaning::kReturnToOrder);
  EXPECT_EQ(meaning(events::CableChanged{.healed = false}), EventMeaning::kFault);
  EXPECT_EQ(meaning(events::MasterOutOfSync{300'000, dc::SyncObstacle::kToExternalClock}), EventMeaning::kNews);
  EXPECT_EQ(meaning(events::MasterOutOfSync{300'000, dc::SyncObstacle::kExternalClock}), EventMeaning::kFault);
  EXPECT_EQ(meaning(events::LongCycles{.begun = false}), EventMeaning::kReturnToOrder);
  EXPECT_EQ(meaning(events::RecoveryStep{events::RecoveryStep::Stage::kDone, 1}), EventMeaning::kReturnToOrder);
  EXPECT_EQ(meaning(events::SlaveFound{}), EventMeaning::kReturnToOrder);
  EXPECT_EQ(meaning(events::Online{}), EventMeaning::kNews);
}

/// Counters are read once the slave answers again: what they tell is of the episode in which it went, however long it
/// was away and whichever came first, the count or the return.
TEST(FaultLog, WhatCountersTellAfterAReturnIsOfTheEpisodeThatEnded) {
  const std::vector<Event> away{{at(10), 5, events::CableChanged{}}, {at(11), 5, events::SlaveLost{}}};
  const std::vector<Event> back{{at(60'000), 5, events::CableChanged{.healed = true}},
                                {at(60'010), 5, events::SlaveFound{}}};
  const std::vector<Event> told{{at(60'300), 5, events::PortErrors{0, 0, 1, at(5)}},
                                {at(60'900), 6, events::WatchdogExpired{}}};
  for (const bool late : {false, true}) {
    FaultLog log;
    for (const auto& event : away) log.add(event);
    log.add({at(20'000), 2, events::AlStatusError{}});
    for (const auto& event : late ? told : back) log.add(event);
    log.add_missed(at(60'500), 6, 3);
    for (const auto& event : late ? back : told) log.add(event);
    log.add({at(63'500), 2, events::AlStatusError{}});
    ASSERT_EQ(log.episodes().size(), 3U) << "what comes while it is away, or long after, is its own; late: " << late;
    EXPECT_EQ(log.count(), 3U);
    const auto& faults = log.episodes()[0].faults;
    ASSERT_EQ(faults.size(), 5U);
    EXPECT_TRUE(faults[0].event->is<events::CableChanged>());
    EXPECT_TRUE(faults[2].event->is<events::PortErrors>());
    EXPECT_EQ(faults[3].count, 3U);
    EXPECT_EQ(log.episodes()[0].end, at(60'900));
    EXPECT_EQ(log.episodes()[1].faults.size(), 1U);
    EXPECT_EQ(log.episodes()[2].begin, at(63'500));
  }
}

TEST(FaultLog, WhatComesAfterAQuietTimeIsAnotherEpisode) {
  FaultLog log;
  for (std::int64_t i = 0; i < 100; ++i) log.add({at(i * 3000), -1, events::FramesLost{1}});
  EXPECT_EQ(log.count(), 100U);
  EXPECT_EQ(log.episodes().size(), FaultLog::kMostEpisodes);
  EXPECT_EQ(log.episodes().back().begin, at(99 * 3000));
}

}  // namespace
}  // namespace syncline
