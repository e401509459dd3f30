// SPDX-License-Identifier: Apache-2.0
// The master's mailbox clients against the simulated devices' servers, with frames lost on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <numeric>

#include "app/composition/load_scenario.h"
#include "config/sim_config.h"
#include "findings/error_text.h"
#include "link/fault_link.h"
#include "link/simulated_link.h"
#include "master/exchange/frame_exchange.h"
#include "master/mailbox/coe_client.h"
#include "master/mailbox/foe_client.h"
#include "master/mailbox/mailbox_client.h"
#include "master/mailbox/sdo_info_client.h"
#include "protocol/coe.h"
#include "protocol/emergency.h"
#include "protocol/registers.h"
#include "sim/sim_bus.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

constexpr std::uint16_t kStation = 1001;

/// A servo of the demonstration machine alone on a line that loses frames, in PREOP.
class Servo {
 public:
  explicit Servo(double loss, std::uint64_t seed) {
    auto config = load_scenario_file(test::source_dir() + "/resources/demo/machine.toml").value();
    config.slaves = {config.slaves[3]};
    config.slaves[0].parent.reset();
    auto segment = sim::SimBus::create(config, clock.now());
    LinkFaults faults;
    faults.lose_request = faults.lose_reply = loss / 2;
    faults.seed = seed;
    link = std::make_unique<FaultLink>(make_simulated_link("sim", std::move(*segment), clock), clock, faults);
    exchange.emplace(*link, clock);
    bus.emplace(*exchange, clock);
    EXPECT_TRUE(bus->write(Command::kApwr, 0, reg::kStationAddress, kStation));
    set_sync_manager(0, {0x26, 0x00, 0x01, 0x00});
    set_sync_manager(1, {0x22, 0x00, 0x01, 0x00});
    EXPECT_TRUE(bus->write<std::uint16_t>(Command::kFpwr, kStation, reg::kAlControl, 0x02));
    EXPECT_TRUE(bus->wait(2 * kMillisecond));
    EXPECT_EQ(bus->read<std::uint16_t>(kStation, reg::kAlStatus, "servo").value(), 0x02);
    shared.port = MailboxPort{"servo", kStation, {0x1000, 128}, {0x1080, 128}};
    shared.on_emergency = [this](const coe::Emergency& emergency, Nanoseconds) { emergencies.push_back(emergency); };
    mailbox.emplace(*bus, shared);
  }
  void set_sync_manager(unsigned number, const std::array<std::uint8_t, 4>& control) {
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(number == 0 ? 0x00 : 0x80), 0x10, 0x80, 0x00};
    bytes.insert(bytes.end(), control.begin(), control.end());
    EXPECT_TRUE(bus->exchange(Command::kFpwr, kStation, reg::sync_manager(number), bytes));
  }

  VirtualClock clock;
  std::unique_ptr<FaultLink> link;
  std::optional<FrameExchange> exchange;
  std::optional<Bus> bus;
  SlaveMailbox shared;
  std::optional<MailboxClient> mailbox;
  std::vector<coe::Emergency> emergencies;
};

class MailboxOnBus : public testing::TestWithParam<double> {};

TEST_P(MailboxOnBus, EveryTransferEndsWithTheRightBytes) {
  std::uint64_t lost = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Servo servo(GetParam(), seed);
    CoeClient coe(*servo.mailbox);
    for (int round = 0; round < 20; ++round) {
      const auto vendor = coe.upload({0x1018, 1});
      ASSERT_TRUE(vendor) << describe(vendor.error());
      EXPECT_EQ(load_le<std::uint32_t>(*vendor), 0x5C17U);
      const std::uint8_t limit[] = {static_cast<std::uint8_t>(round % 15 + 1), 0};
      const auto written = coe.download({0x10F1, 2}, limit);
      ASSERT_TRUE(written) << describe(written.error());
      EXPECT_EQ(coe.upload({0x10F1, 2}).value()[0], limit[0]);
    }
    FoeClient foe(*servo.mailbox);
    std::vector<std::uint8_t> file(1'500);
    std::iota(file.begin(), file.end(), std::uint8_t{0});
    const auto stored = foe.write("settings.bin", file);
    ASSERT_TRUE(stored) << describe(stored.error());
    const auto back = foe.read("settings.bin");
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(*back, file);
    lost += servo.link->injected().lost;
  }
  // A test without a lost frame proves nothing.
  EXPECT_EQ(lost > 0, GetParam() > 0);
}

TEST_P(MailboxOnBus, DictionaryIsReadThroughSdoInformation) {
  Servo servo(GetParam(), 7);
  SdoInfoClient information(*servo.mailbox);
  const auto list = information.object_list();
  ASSERT_TRUE(list) << describe(list.error());
  EXPECT_THAT(*list, testing::IsSupersetOf({0x1000, 0x1018, 0x10F1, 0x10F3, 0x1C12, 0x1C32, 0x6040, 0x607A}));
  const auto missed = information.entry(0x1C32, 0x0C);
  ASSERT_TRUE(missed) << describe(missed.error());
  EXPECT_EQ(missed->name, "SM event missed counter");
  EXPECT_EQ(missed->bit_length, 16);
  const auto target = information.entry(0x607A, 0);
  ASSERT_TRUE(target) << describe(target.error());
  EXPECT_EQ(target->data_type, 0x04) << "a DINT, as its ESI says";
  EXPECT_NE(target->access & coe::access::kRxPdo, 0);
}

TEST_P(MailboxOnBus, EmergencyOfARefusedStateComesOnce) {
  Servo servo(GetParam(), 3);
  EXPECT_TRUE(servo.bus->write<std::uint16_t>(Command::kFpwr, kStation, reg::kAlControl, 0x04));  // without SM2 and SM3
  EXPECT_TRUE(servo.bus->wait(3 * kMillisecond));
  CoeClient coe(*servo.mailbox);
  ASSERT_TRUE(coe.upload({0x1000, 0}));
  ASSERT_EQ(servo.emergencies.size(), 1U);
  EXPECT_EQ(servo.emergencies[0].error_code, 0xA000);
}

INSTANTIATE_TEST_SUITE_P(Loss, MailboxOnBus, testing::Values(0.0, 0.01, 0.05));

}  // namespace
}  // namespace syncline
