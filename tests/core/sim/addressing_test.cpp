// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/core/sim/sim_probe.h"

/// Which slaves a datagram by station address is for, whatever was known of them before.
namespace syncline::test {
namespace {

constexpr std::uint16_t kFirstStation = 1001, kOtherStation = 2001;
constexpr std::uint8_t kAlStatusEvent = 0x08;

struct Addressed {
  std::uint16_t station = 0, alias = 0;
  bool alias_on = false;
  [[nodiscard]] bool has(std::uint16_t address) const { return address == station || (alias_on && address == alias); }
};

std::uint16_t any_station() { return *rc::gen::element<std::uint16_t>(0, 1001, 1002, 1003, kOtherStation); }

std::vector<std::uint8_t> bytes_of(std::uint16_t word) {
  const auto bytes = le_bytes(word);
  return {bytes.begin(), bytes.end()};
}

RC_GTEST_PROP(SimAddressing, EverySlaveAnswersToTheAddressesThatItHasNow, ()) {
  std::vector<SimSlaveConfig> slaves;
  std::vector<Addressed> model;
  const auto count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    slaves.push_back(sim_slave("SL-2002"));
    slaves.back().alias = any_station();
    model.push_back({0, slaves.back().alias, false});
  }
  SimProbe probe(line(std::move(slaves)));
  const auto steps = *rc::gen::inRange(5, 40);
  for (int step = 0; step < steps; ++step) {
    const auto whom = *rc::gen::inRange<std::uint16_t>(0, static_cast<std::uint16_t>(count));
    auto& slave = model[whom];
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        slave.station = any_station();
        probe.write(whom, reg::kStationAddress, bytes_of(slave.station));
        break;
      case 1:
        slave.alias_on = !slave.alias_on;
        probe.write(whom, reg::kDlControlAlias, {static_cast<std::uint8_t>(slave.alias_on ? 1 : 0)});
        break;
      default: {
        const auto address = any_station();
        const auto reply = probe.send(Command::kFprd, device_address(address, reg::kType), {0});
        RC_ASSERT(reply.wkc == std::ranges::count_if(model, [&](const auto& s) { return s.has(address); }));
      }
    }
  }
}

TEST(SimAddressing, FramesForOneSlaveCarryTheEventsOfTheOthersThatMayTellThem) {
  SimProbe probe(line({sim_slave("SL-2002"), sim_slave("SL-SV7", "servo-y")}));
  for (std::uint16_t i = 0; i < 2; ++i) {
    probe.write(i, reg::kStationAddress, bytes_of(static_cast<std::uint16_t>(kFirstStation + i)));
  }
  const auto event = [&probe] {
    return probe.send(Command::kFprd, device_address(kFirstStation, reg::kType), {0}).irq & kAlStatusEvent;
  };
  probe.request(1, 8);  // refused; reads the AL status
  probe.write(1, reg::kAlControl, {0x11, 0});
  probe.pass(kMillisecond);
  EXPECT_EQ(event(), 0) << "the mask is closed";
  probe.write(1, reg::kEcatEventMask, {kAlStatusEvent, 0});
  EXPECT_NE(event(), 0);
  EXPECT_NE(event(), 0) << "nobody has read the AL status";
  probe.send(Command::kFprd, device_address(kFirstStation + 1, reg::kAlStatus), {0, 0});
  EXPECT_EQ(event(), 0);
}

}  // namespace
}  // namespace syncline::test
