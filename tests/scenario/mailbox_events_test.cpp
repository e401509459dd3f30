// SPDX-License-Identifier: Apache-2.0
// What slaves say without being asked reaches the user while the bus runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/cli/cli.h"
#include "app/cli/event_text.h"
#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/events/slave_events.h"
#include "channels/master_channels.h"
#include "link/fault_link.h"
#include "master/cyclic/mailbox_bits.h"
#include "master/exchange/mailbox_handshake.h"
#include "master/master_service.h"
#include "protocol/diagnosis_message.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSm1Status = 0x080D;

constexpr std::uint32_t kTerminal = 1002;  // its SyncManager 1 has inputs

/// Counts the datagrams that ask a SyncManager for the state of its mailbox.
class PollCounter final : public Link {
 public:
  PollCounter(std::unique_ptr<Link> inner, std::size_t& polls) : inner_(std::move(inner)), polls_(polls) {}
  Status send(std::span<const std::uint8_t> frame) override {
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    FrameReader reader(bytes);
    while (auto datagram = reader.next()) {
      const auto& header = datagram->header;
      const bool of_terminal = (header.address & 0xFFFFU) == kTerminal;
      if (header.command == Command::kFprd && header.ado() == kSm1Status && !of_terminal) ++polls_;
    }
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return inner_->receive(buffer, deadline);
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  std::size_t& polls_;
};

/// Two drives and a terminal, in OP.
class MailboxEvents : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::SimulatedNetwork network;
  std::unique_ptr<MasterService> service;
  std::vector<Event> events;
  std::vector<CycleSample> samples;
  Nanoseconds start = 0;
  std::size_t polls = 0;
  LinkFaults line;

  void add_drives(bool with_bit = true) {
    auto drive = test::servo();
    if (!with_bit) std::erase(drive.fmmus, FmmuUse::kMailboxState);
    network.add(drive, "servo-y");
    network.add(test::io8());
    network.add(drive, "servo-y");
  }
  /// The drives give up with 0x001A.
  void lose_frames_at(Nanoseconds at) {
    FaultConfig fault;
    fault.kind = FaultKind::kLoseFrames;
    fault.at = at;
    fault.count = 40;
    network.sim.faults.push_back(fault);
  }
  void run(Nanoseconds time) {
    if (!service) {
      start = clock.now();
      auto lossy = std::make_unique<FaultLink>(network.link(clock), clock, line);
      service = std::make_unique<MasterService>(std::make_unique<PollCounter>(std::move(lossy), polls), clock);
      service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
      (void)service->step();
      polls = 0;
    }
    const auto end = clock.now() + time;
    while (clock.now() < end) {
      service->run_for(100 * kMillisecond);
      for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
      service->channels().samples.pop(samples);
    }
  }
  [[nodiscard]] std::vector<Event> of(EventKind kind, int slave) const {
    std::vector<Event> found;
    std::ranges::copy_if(events, std::back_inserter(found),
                         [&](const Event& e) { return e.kind() == kind && e.slave == slave; });
    return found;
  }
  [[nodiscard]] std::string log() const {
    std::string text;
    for (const auto& event : events) text += cli::event_text(event, start) + "\n";
    return text;
  }
  void expect_everything_is_told() {
    for (const int slave : {0, 2}) {
      const auto emergencies = of(kind_of<events::Emergency>, slave);
      ASSERT_EQ(emergencies.size(), 1U) << log();
      const auto& emergency = *emergencies[0].as<events::Emergency>();
      EXPECT_EQ(emergency.error_code, 0x0A12);
      EXPECT_EQ(emergency.error_register, 0x11);
      EXPECT_EQ(emergency.data, (std::array<std::uint8_t, 5>{0x1A, 0, 0, 0, 0}))
          << "its first two bytes name the AL status code";
      const auto messages = of(kind_of<events::DiagnosisTold>, slave);
      ASSERT_EQ(messages.size(), 1U) << log();
      const auto& message = *messages[0].as<events::DiagnosisTold>();
      EXPECT_EQ(message.code, 0x0A12E000U);
      EXPECT_EQ(message.type, DiagnosisMessage::Type::kError);
      EXPECT_EQ(message.text_id, 0x001A);
      EXPECT_GT(message.time_stamp, 0U);
      EXPECT_LT(messages[0].time - emergencies[0].time, 500 * kMillisecond) << "an emergency hurries it";
    }
    EXPECT_THAT(log(),
                testing::HasSubstr("slave 2: emergency 0x0a12 (A.A12, EtherCAT Outputs Data Synchronization Error), "
                                   "error register 0x11, data 1a 00 00 00 00"));
    EXPECT_THAT(log(), testing::HasSubstr("slave 2: diagnosis error 0x0a12e000, text 0x001a, time stamp "));
  }
  void expect_steady_cycle() const {
    for (std::size_t i = 1; i < samples.size(); ++i)
      ASSERT_LT(samples[i].send_time - samples[i - 1].send_time, 1'200'000);
  }
};

TEST_F(MailboxEvents, EmergencyAndHistoryAreToldByTheBitInTheProcessImage) {
  add_drives();
  lose_frames_at(6 * kSecond);
  ASSERT_TRUE(mailbox_state_bit(network.compiled().slaves[0]));
  run(9 * kSecond);
  expect_everything_is_told();
  expect_steady_cycle();
  EXPECT_LT(polls, 9 * 50U) << "the SyncManagers are hardly asked";
}

TEST_F(MailboxEvents, WithoutTheBitTheSyncManagersAreAskedAtThePollTime) {
  add_drives(false);
  lose_frames_at(6 * kSecond);
  const auto config = network.compiled();
  ASSERT_FALSE(mailbox_state_bit(config.slaves[0]));
  ASSERT_TRUE(config.slaves[0].mailbox->poll_time_ms);
  run(9 * kSecond);
  expect_everything_is_told();
  expect_steady_cycle();
  EXPECT_GT(polls, 2 * 9'000U / *config.slaves[0].mailbox->poll_time_ms);
}

TEST_F(MailboxEvents, MessagesAreToldOnceHoweverLongTheyStayUnacknowledged) {
  add_drives();
  lose_frames_at(6 * kSecond);
  run(30 * kSecond);
  EXPECT_EQ(of(kind_of<events::DiagnosisTold>, 0).size(), 1U) << log();
  EXPECT_EQ(of(kind_of<events::Emergency>, 0).size(), 1U) << log();
}

TEST_F(MailboxEvents, CountersAreReadOnThoughFramesAreLost) {
  add_drives();
  const auto readings = [&] {
    return std::ranges::count_if(samples, [](const auto& s) { return s.sm2_position >= 0; });
  };
  run(5 * kSecond);
  const auto undisturbed = readings();
  ASSERT_GT(undisturbed, 100);
  service.reset();
  samples.clear();
  line.lose_request = line.lose_reply = 0.01;
  run(5 * kSecond);
  EXPECT_GT(readings(), undisturbed * 6 / 10) << "a lost frame costs a few cycles, not the turn's time-out";
}

}  // namespace
}  // namespace syncline
