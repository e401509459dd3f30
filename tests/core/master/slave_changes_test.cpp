// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/event_finding.h"
#include "channels/master_channels.h"
#include "config/cyclic_frame.h"
#include "config/process_image.h"
#include "master/clocks/dc_setup.h"
#include "master/clocks/ored_deviation.h"
#include "master/clocks/slaves_sync.h"
#include "master/clocks/sync_watch.h"
#include "master/cyclic/cyclic_frame_set.h"
#include "master/cyclic/sync_event_watch.h"
#include "master/exchange/run_state.h"
#include "support/random.h"

/// What is made of all slaves in each cycle is looked at again only after a change (SlaveStates::note_slave_change()).
/// The same history, once as it is and once with a change told in each cycle, must come out the same.
namespace syncline {
namespace {

constexpr Nanoseconds kCycle = kMillisecond;

NetworkConfig clocked_line(std::size_t slaves) {
  NetworkConfig config;
  config.dc.enabled = true;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.settle_time_ms = 20;
  for (std::size_t i = 0; i < slaves; ++i) {
    SlaveConfig slave;
    slave.dc = SlaveDcConfig{true, i == 0, kCycle, 0, 300 * kMicrosecond, 0x0300};
    slave.send = ImageRange{static_cast<std::uint32_t>(8 * i), 8};
    config.slaves.push_back(slave);
  }
  CyclicCmd process_data;
  process_data.states = {AlState::kSafeop, AlState::kOp};
  process_data.command = Command::kLrw;
  process_data.data_length = static_cast<std::uint16_t>(slaves);
  process_data.expected_wkc = static_cast<std::uint16_t>(2 * slaves);
  config.cyclic.resize(1);
  config.cyclic[0].cycle_time = kCycle;
  config.cyclic[0].frames.push_back({{process_data}});
  return config;
}

DcNetwork clocks_of(std::size_t slaves) {
  DcNetwork network;
  network.slaves.resize(slaves);
  for (auto& slave : network.slaves) slave.synchronised = true;
  return network;
}

/// One of the two masters that live through the same.
struct WatchedLine {
  WatchedLine(const NetworkConfig& config, bool looks_always)
      : always(looks_always),
        run(config, channels),
        sync(config, run.snapshot, run.states, run.teller, channels.timer_adjust_permil),
        slaves_sync(config, run.snapshot, run.states, run.teller) {
    const auto network = clocks_of(config.slaves.size());
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      auto& slave = run.snapshot.slaves[i];
      slave.present = slave.dc_enabled = true;
      slave.al_status = static_cast<std::uint16_t>(AlState::kOp);
      slave.propagation_delay_ns = static_cast<std::uint32_t>(400 * i);
    }
    sync.start(network, 0);
    slaves_sync.start(network, 0, false);
    run.states.note_slave_change();
    events = std::make_unique<SyncEventWatch>(run.config(), run.snapshot, run.states, sync);
    frames = std::make_unique<CyclicFrameSet>(run.config());
    frames->select(AlState::kOp);
    limits.resize(config.slaves.size());
  }
  /// What an event says, with its moment.
  void take_events() {
    for (const auto& event : channels.events.drain()) {
      const auto finding = event_finding(event);
      told.push_back(std::to_string(event.time) + " " + std::to_string(event.slave) + " " +
                     (finding ? facts_text(*finding) : std::string()));
    }
  }
  void follow(Nanoseconds now, bool led, bool distributed, const std::optional<OredDeviation>& ored,
              CycleSample& sample) {
    if (always) run.states.note_slave_change();
    slaves_sync.observe(now, led, distributed, read, ored, sample);
    read.clear();
    take_events();
  }
  void send(bool back, CycleSample& sample) {
    if (always) {
      run.states.note_slave_change();
      for (std::size_t i = 0; i < limits.size(); ++i) events->set_limit(i, limits[i]);  // ends the closed form
    }
    frames->prepare(slot++, false);
    for (auto* frame : frames->frames()) {
      for (auto* datagram : frame->datagrams()) datagram->answered = back;
    }
    events->observe(sample, {*frames, back, 0});
    take_events();
  }

  bool always;
  MasterChannels channels;
  RunState run;
  std::vector<std::uint16_t> read;  // whose deviation comes with the next cycle
  SyncWatch sync;
  SlavesSync slaves_sync;
  std::unique_ptr<SyncEventWatch> events;
  std::unique_ptr<CyclicFrameSet> frames;
  std::int64_t slot = 0;
  std::vector<std::uint32_t> limits;
  std::vector<std::string> told;
};

/// Both masters, and what happens to both.
struct Twins {
  explicit Twins(std::size_t slaves) : config(clocked_line(slaves)) {}
  template <class What>
  void both(const What& what) {
    for (auto& line : lines) what(line);
  }
  /// Mostly nothing: long histories between changes are what the shortcuts are for.
  void change_slaves(Random& random, Nanoseconds now) {
    const auto slave = random.next() % config.slaves.size();
    const auto dice = random.next() % 400;
    constexpr std::array kStates{0x01, 0x02, 0x04, 0x08, 0x08, 0x08, 0x14};
    const auto state = static_cast<std::uint16_t>(kStates[random.next() % kStates.size()]);
    both([&](WatchedLine& line) {
      auto& status = line.run.snapshot.slaves[slave];
      if (dice < 4) line.run.states.set_present(slave, !status.present, now);
      if (dice >= 4 && dice < 9 && status.present) line.run.states.set_al_status(slave, state, 0, now);
      if (dice == 9) {
        status.dc_enabled = !status.dc_enabled;
        line.run.states.note_slave_change();
      }
      if (dice == 10) line.run.snapshot.dc.reference_clock = static_cast<int>(slave);
    });
  }
  void read_deviation(Random& random, Nanoseconds now) {
    const auto slave = static_cast<std::uint16_t>(random.next() % config.slaves.size());
    const auto size = random.next() % 50 == 0 ? 400 : 120;
    const auto deviation = static_cast<std::int32_t>(random.next() % (2 * size + 1)) - size;
    both([&](WatchedLine& line) {
      auto& status = line.run.snapshot.slaves[slave];
      if (!status.present) return;
      status.deviation_valid = true;
      status.deviation_ns = deviation;
      status.deviation_time = now;
      line.read.push_back(slave);
    });
  }
  [[nodiscard]] bool agree() const {
    return lines[0].run.snapshot.dc == lines[1].run.snapshot.dc &&
           lines[0].run.snapshot.slaves == lines[1].run.snapshot.slaves && lines[0].told == lines[1].told;
  }

  NetworkConfig config;
  std::array<WatchedLine, 2> lines{WatchedLine{config, false}, WatchedLine{config, true}};
};

bool same_verdict(const CycleSample& a, const CycleSample& b) {
  return a.flags == b.flags && a.deviation_ns == b.deviation_ns && a.slaves_sync == b.slaves_sync;
}

bool same_misses(const CycleSample& a, const CycleSample& b) {
  return a.sm2_position == b.sm2_position && a.slave_sm2_missed == b.slave_sm2_missed &&
         a.slave_sm2_integrator == b.slave_sm2_integrator;
}

TEST(SlaveChanges, WhoFollowsIsTheSameAsIfAllWereLookedAtInEachCycle) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Twins twins(1 + random.next() % 5);
    for (Nanoseconds now = kCycle; now < 2 * kSecond; now += kCycle) {
      twins.change_slaves(random, now);
      if (random.next() % 3 != 0) twins.read_deviation(random, now);
      const bool led = random.next() % 200 != 0, distributed = random.next() % 50 != 0;
      std::optional<OredDeviation> ored;
      if (random.next() % 4 != 0) {
        ored = OredDeviation{static_cast<std::uint32_t>(random.next() % 140),
                             static_cast<std::uint16_t>(random.next() % 6)};
      }
      std::array<CycleSample, 2> samples;
      for (int i = 0; i < 2; ++i) twins.lines[i].follow(now, led, distributed, ored, samples[i]);
      RC_ASSERT(same_verdict(samples[0], samples[1]));
      RC_ASSERT(twins.agree());
    }
  }));
}

/// Only who may follow catches up: the time without a clock of its own is none in which its loop learned.
TEST(SlaveChanges, ASlaveThatIsBackWithoutItsClockHasNotCaughtUpWhenItHasIt) {
  Twins twins(2);
  Nanoseconds now = 0;
  const auto live = [&](Nanoseconds span) {
    for (const auto end = now + span; now < end;) {
      now += kCycle;
      std::array<CycleSample, 2> samples;
      for (std::size_t i = 0; i < 2; ++i) twins.lines[i].follow(now, true, true, {}, samples[i]);
      ASSERT_TRUE(twins.agree()) << now;
    }
  };
  const auto change = [&](const auto& what) { twins.both([&](WatchedLine& line) { what(line.run); }); };
  const auto clock = [](bool on) {
    return [on](RunState& run) {
      run.snapshot.slaves[1].dc_enabled = on;
      run.states.note_slave_change();
    };
  };
  live(20 * kMillisecond);
  change([&](RunState& run) { run.states.set_present(1, false, now); });
  live(20 * kMillisecond);
  change(clock(false));
  change([&](RunState& run) { run.states.set_present(1, true, now); });
  live(kSecond);
  change([&](RunState& run) { run.states.set_al_status(1, static_cast<std::uint16_t>(AlState::kPreop), 0, now); });
  change(clock(true));
  live(kSecond);
  EXPECT_FALSE(twins.lines[0].run.snapshot.slaves[1].follows);
  change([&](RunState& run) { run.states.set_al_status(1, static_cast<std::uint16_t>(AlState::kOp), 0, now); });
  live(kSecond);
  EXPECT_TRUE(twins.lines[0].run.snapshot.slaves[1].follows);
}

TEST(SlaveChanges, MissedEventsAreTheSameAsIfEachSlaveWereLookedAtInEachCycle) {
  std::uint64_t missed = 0;
  EXPECT_TRUE(rc::check([&missed] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Twins twins(1 + random.next() % 4);
    std::uint32_t counter = 0;
    Nanoseconds now = 0;
    for (int cycle = 0; cycle < 2'000; ++cycle) {
      now += kCycle;
      twins.change_slaves(random, now);
      CycleSample sample;
      if (random.next() % 100 == 0) {
        sample.skipped_cycles = static_cast<std::uint16_t>(1 + random.next() % 4);
        now += sample.skipped_cycles * kCycle;
      }
      sample.send_time = now;
      const auto late = random.next() % 60 == 0 ? static_cast<Nanoseconds>(random.next() % (2 * kCycle)) : 0;
      sample.reference_time = now + late;
      if (random.next() % 20 != 0) sample.flags |= CycleSample::kReferenceValid;
      const bool back = random.next() % 60 != 0;
      const auto slave = random.next() % twins.config.slaves.size();
      const auto news = random.next() % 200;
      counter += random.next() % 100 == 0 ? 1 : 0;
      const auto limit = static_cast<std::uint32_t>(random.next() % 30);
      std::array<CycleSample, 2> samples{sample, sample};
      for (int i = 0; i < 2; ++i) {
        auto& line = twins.lines[i];
        if (news < 4) line.events->read(slave, counter);
        if (news == 4) line.events->set_limit(slave, line.limits[slave] = limit);
        if (news == 5) {
          line.run.snapshot.slaves[slave].propagation_delay_ns = 100 * limit;
          line.run.states.note_slave_change();
        }
        line.send(back, samples[i]);
      }
      RC_ASSERT(same_misses(samples[0], samples[1]));
      RC_ASSERT(twins.agree());
    }
    for (const auto& slave : twins.lines[0].run.snapshot.slaves) missed += slave.sm2_missed.missed;
  }));
  EXPECT_GT(missed, 0U) << "nothing was compared";
}

class OneIsAway : public ::testing::Test {
 protected:
  void cycles(int count, std::optional<std::uint16_t> read = {}, std::uint16_t left_out = 0) {
    for (int i = 0; i < count; ++i) {
      now += (1 + left_out) * kCycle;
      CycleSample sample;
      sample.skipped_cycles = left_out;
      sample.send_time = sample.reference_time = now;
      sample.flags = CycleSample::kReferenceValid;
      if (read) {
        auto& status = line.run.snapshot.slaves[*read];
        status.deviation_valid = true;
        status.deviation_time = now;
        line.read.push_back(*read);
      }
      line.send(true, sample);
      line.follow(now, true, true, {}, sample);
    }
  }

  void slave_2_comes_back_in(AlState state) {
    cycles(200);
    line.run.states.set_present(2, false, now);
    cycles(3);
    line.run.states.set_present(2, true, now);
    line.run.states.set_al_status(2, static_cast<std::uint16_t>(state), 0, now);
    cycles(3);
  }

  NetworkConfig config = clocked_line(4);
  WatchedLine line{config, false};
  Nanoseconds now = 0;
};

TEST_F(OneIsAway, WithoutAReadingNothingHasAnAge) {
  cycles(3);
  EXPECT_EQ(line.run.snapshot.dc.newest_age_ns, -1);
  cycles(1, 2);
  cycles(5);
  EXPECT_EQ(line.run.snapshot.dc.newest_age_ns, 5 * kCycle);
}

TEST_F(OneIsAway, TheOthersAreNotLookedAtInEachCycleForIt) {
  cycles(200);
  EXPECT_TRUE(line.slaves_sync.settled());
  EXPECT_TRUE(line.events->together());
  line.run.states.set_present(2, false, now);
  cycles(3);
  EXPECT_TRUE(line.slaves_sync.settled());
  EXPECT_TRUE(line.events->together());
  EXPECT_FALSE(line.run.snapshot.slaves[2].follows);
  EXPECT_EQ(line.run.snapshot.dc.followers, 2);
}

TEST_F(OneIsAway, WhoComesBackIsAwaitedUntilItHasCaughtUp) {
  slave_2_comes_back_in(AlState::kPreop);
  EXPECT_FALSE(line.slaves_sync.settled());
  EXPECT_TRUE(line.events->together());
  cycles(1, 2);
  EXPECT_FALSE(line.slaves_sync.settled()) << "one small reading of a clock that was just set says nothing";
  cycles(static_cast<int>(300 * kMillisecond / kCycle), 2);
  EXPECT_TRUE(line.slaves_sync.settled());
  EXPECT_TRUE(line.run.snapshot.slaves[2].follows);
}

TEST_F(OneIsAway, WhoWorksAgainCountsAtItsFirstSmallReading) {
  slave_2_comes_back_in(AlState::kSafeop);
  EXPECT_FALSE(line.run.snapshot.slaves[2].follows);
  cycles(1, 2);
  EXPECT_TRUE(line.run.snapshot.slaves[2].follows);
}

TEST_F(OneIsAway, WhoWorksAgainAndNeverCatchesUpCountsAllTheSame) {
  slave_2_comes_back_in(AlState::kOp);
  EXPECT_FALSE(line.run.snapshot.slaves[2].follows);
  cycles(static_cast<int>(500 * kMillisecond / kCycle));
  EXPECT_TRUE(line.run.snapshot.slaves[2].follows);
}

/// A code that stays behind without an error is that of an older fall.
TEST_F(OneIsAway, OnlyWhoFallsWithAnErrorHasMissedItsEvents) {
  const auto falls = [this](std::uint16_t status) {
    constexpr std::uint16_t kSynchronizationError = 0x001A;
    line.run.states.set_al_status(2, static_cast<std::uint16_t>(AlState::kOp), 0, now);
    cycles(200);
    line.run.states.set_al_status(2, status, kSynchronizationError, now);
    cycles(3);
    return line.run.snapshot.slaves[2].sm2_missed.missed;
  };
  line.events->set_limit(2, 10);
  line.events->set_calc_and_copy(2, kCycle - 1);
  EXPECT_EQ(falls(static_cast<std::uint16_t>(AlState::kSafeop)), 0U);
  EXPECT_EQ(falls(static_cast<std::uint16_t>(AlState::kSafeop) | kAlErrorFlag), 4U)
      << "three each, and ten is the limit";
}

/// What it misses while it finds into OP may make it fall again, and until the next sweep nobody has seen that.
TEST_F(OneIsAway, WhatIsMissedOnTheWayToOpIsForgottenWhenItStays) {
  line.events->set_limit(2, 6);
  line.run.states.set_al_status(2, static_cast<std::uint16_t>(AlState::kPreop), 0, now);
  cycles(200);
  line.run.states.set_al_status(2, static_cast<std::uint16_t>(AlState::kOp), 0, now);
  cycles(2);
  cycles(1, {}, 3);
  const auto& status = line.run.snapshot.slaves[2].sm2_missed;
  EXPECT_TRUE(status.settling);
  cycles(500);
  EXPECT_TRUE(status.settling) << "it may have fallen";
  cycles(300);
  EXPECT_FALSE(status.settling);
  EXPECT_EQ(status.missed, 0U);
}

TEST_F(OneIsAway, WhoHasNoClockIsNotAwaited) {
  line.run.snapshot.slaves[2].dc_enabled = false;
  line.run.states.note_slave_change();
  cycles(200);
  line.run.states.set_present(2, false, now);
  cycles(3);
  line.run.states.set_present(2, true, now);
  cycles(3);
  EXPECT_TRUE(line.slaves_sync.settled());
}

/// SM2's event comes at the end of the frame: one that begins in front of SYNC0 and ends behind it is too late.
TEST(LongFrame, IsMissedWhereItEndsBehindSync0) {
  auto config = clocked_line(2);
  CyclicCmd command;
  command.command = Command::kLrw;
  command.data_length = 1'000;
  config.cyclic.resize(1);
  config.cyclic[0].frames.resize(1);
  config.cyclic[0].frames[0].commands = {command};
  config.slaves[1].send = ImageRange{0, 64};
  WatchedLine line{config, false};
  Nanoseconds now = 0;
  const auto send = [&](Nanoseconds before_sync0) {
    now += kCycle;
    CycleSample sample;
    sample.send_time = now;
    sample.reference_time = now + line.sync.base() + 300 * kMicrosecond - before_sync0;
    sample.flags = CycleSample::kReferenceValid;
    line.send(true, sample);
  };
  const auto missed = [&] {
    for (int i = 0; i < 4; ++i) send(120 * kMicrosecond);
    return line.run.snapshot.slaves[1].sm2_missed.missed;
  };
  for (int i = 0; i < 3'000; ++i) send(120 * kMicrosecond);
  const auto before = missed();
  send(100 * kMicrosecond);
  EXPECT_EQ(missed(), before) << "it takes 84 us";
  send(60 * kMicrosecond);
  EXPECT_EQ(missed(), before + 1);
}

TEST_F(OneIsAway, NobodyInOpIsNobodyToLookAt) {
  for (std::size_t i = 0; i < 4; ++i) line.run.states.set_present(i, false, now);
  cycles(1'000);
  EXPECT_TRUE(line.slaves_sync.settled());
  EXPECT_TRUE(line.events->together());
}

}  // namespace
}  // namespace syncline
