// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "channels/master_channels.h"
#include "findings/error_text.h"
#include "link/fault_link.h"
#include "master/operation.h"
#include "master/scan/bus_scanner.h"
#include "protocol/registers.h"
#include "sim/device/sii_from_device.h"
#include "tests/support/scan_bed.h"
#include "tests/support/swapped_network.h"

/// The scan against the simulated bus, which executes every byte.
namespace syncline {
namespace {

using test::CountingLink;
using test::SimulatedNetwork;

sii::Image truth(const SimSlaveConfig& slave) {
  const auto image = sim::sii_from_device(slave.device, slave.alias, slave.serial_no);
  auto decoded = sii::decode(sii::encode(image));
  return decoded ? *decoded : sii::Image{};
}

void expect_true(const BusScan& scan, const SimulatedNetwork& network) {
  ASSERT_EQ(scan.slaves.size(), network.sim.slaves.size());
  for (std::size_t i = 0; i < scan.slaves.size(); ++i) {
    const auto& slave = scan.slaves[i];
    const auto& expected = network.sim.slaves[i];
    ASSERT_TRUE(slave.sii) << i << ": " << (slave.sii_error ? slave.sii_error->detail.text() : "");
    EXPECT_EQ(*slave.sii, truth(expected)) << i;
    EXPECT_EQ(slave.identity.product_code, expected.device.identity.product_code);
    EXPECT_EQ(slave.identity.serial_no, expected.serial_no);
    EXPECT_EQ(slave.alias, expected.alias);
    if (i > 0) {
      EXPECT_EQ(slave.previous, (PreviousPort{static_cast<std::uint16_t>(i - 1), 1})) << i;
    }
    EXPECT_EQ(slave.entry_port, 0);
  }
}

struct Bed {
  VirtualClock clock;
  std::unique_ptr<CountingLink> link;
  std::unique_ptr<FrameExchange> exchange;
  std::unique_ptr<Bus> bus;

  explicit Bed(const SimulatedNetwork& network, const LinkFaults& faults = {}) {
    link = std::make_unique<CountingLink>(std::make_unique<FaultLink>(network.link(clock), clock, faults));
    exchange = std::make_unique<FrameExchange>(*link, clock);
    bus = std::make_unique<Bus>(*exchange, clock);
  }
};

TEST(ScanSimulated, EveryWiringIsFound) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const auto network = test::swapped_network(30, seed);
    Bed bed(network);
    const auto scan = scan_slaves(*bed.bus);
    RC_ASSERT(scan.has_value());
    RC_ASSERT(scan->slaves.size() == network.sim.slaves.size());
    for (std::size_t i = 0; i < scan->slaves.size(); ++i) {
      RC_ASSERT(scan->slaves[i].previous == network.project.slaves[i].previous);
      RC_ASSERT(scan->slaves[i].entry_port == network.sim.slaves[i].entry_port);
    }
  }));
}

TEST(ScanSimulated, AHundredDifferentSlavesNeedThreeFramesEach) {
  const auto network = test::different_slaves(100);
  Bed bed(network);
  const auto scan = scan_slaves(*bed.bus);
  ASSERT_TRUE(scan);
  expect_true(*scan, network);
  RecordProperty("frames", static_cast<int>(bed.link->frames));
  EXPECT_LE(bed.link->frames, 300U);
}

TEST(ScanSimulated, AHundredIdenticalSlavesNeedFortyFramesInAll) {
  const auto network = test::identical_slaves(100);
  Bed bed(network);
  const auto scan = scan_slaves(*bed.bus);
  ASSERT_TRUE(scan);
  expect_true(*scan, network);
  EXPECT_EQ(scan->slaves[99].sii_shared_with, 0);
  RecordProperty("frames", static_cast<int>(bed.link->frames));
  EXPECT_LE(bed.link->frames, 40U);
}

TEST(ScanSimulated, SharingCanBeSwitchedOff) {
  const auto network = test::identical_slaves(8);
  Bed bed(network);
  const auto scan = scan_slaves(*bed.bus, {.share_kinds = false});
  ASSERT_TRUE(scan);
  expect_true(*scan, network);
  for (const auto& slave : scan->slaves) EXPECT_FALSE(slave.sii_shared_with);
}

TEST(ScanSimulated, AThousandSlavesAreNoLimit) {
  const auto network = test::identical_slaves(1000);
  Bed bed(network);
  const auto scan = scan_slaves(*bed.bus);
  ASSERT_TRUE(scan);
  expect_true(*scan, network);
  EXPECT_EQ(scan->slaves[999].station_address, 2000);
}

TEST(ScanSimulated, LossesAndSwapsChangeNothing) {
  const auto network = test::different_slaves(20);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Bed bed(network,
            {.lose_request = 0.01, .lose_reply = 0.01, .duplicate = 0.02, .reorder = 0.02, .late = 0.01, .seed = seed});
    const auto scan = scan_slaves(*bed.bus);
    ASSERT_TRUE(scan) << seed;
    expect_true(*scan, network);
    EXPECT_TRUE(scan->findings.empty()) << seed << " " << describe(scan->findings[0]);
  }
}

TEST(ScanSimulated, ARunningBusGivesTheSameResultAndIsToldBefore) {
  auto network = test::different_slaves(3);
  VirtualClock clock;
  const auto link = network.link(clock);
  FrameExchange exchange(*link, clock);
  MasterChannels channels;
  Bus bus(exchange, clock);
  const auto before = scan_slaves(bus);
  ASSERT_TRUE(before);
  Operation operation(network.compiled(), exchange, clock, channels);
  const auto started = operation.start(AlState::kSafeop);
  ASSERT_TRUE(started) << describe(started.error());
  std::size_t warned = 0;
  const auto scan = scan_slaves(bus, {}, {.touching = [&](std::size_t running, std::size_t) { warned = running; }});
  ASSERT_TRUE(scan);
  EXPECT_EQ(warned, 3U);
  EXPECT_EQ(scan->running, 3U);
  expect_true(*scan, network);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(al_state_of(scan->slaves[i].al_status), AlState::kSafeop);
    EXPECT_EQ(scan->slaves[i].station_address, 1001 + i);
    EXPECT_EQ(scan->slaves[i].dc, before->slaves[i].dc);
  }
}

using Registers = std::vector<std::vector<std::uint8_t>>;

/// "slave 3 0x0500: 01 -> 00" for every register that is not what it was, but for the system time, which
/// runs by itself, and the event request, which reading DL and AL status acknowledges (0x0210).
std::vector<std::string> changes(const Registers& before, const Registers& after) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t n = 0; n < before[i].size(); ++n) {
      const bool runs = n >= reg::kSystemTime && n < reg::kReceiveTimeProcessingUnit;
      const bool acknowledged = n == reg::kEcatEventRequest;
      if (runs || acknowledged || before[i][n] == after[i][n]) continue;
      found.push_back(fmt::format("slave {} 0x{:04x}: {:02x} -> {:02x}", i, n, before[i][n], after[i][n]));
    }
  }
  return found;
}

class LookOnly : public ::testing::Test {
 protected:
  SimulatedNetwork network = test::different_slaves(6);
  VirtualClock clock;
  sim::SimBus* watched = nullptr;
  std::unique_ptr<Link> link;
  std::unique_ptr<FrameExchange> exchange;
  std::unique_ptr<Bus> bus;

  void SetUp() override {
    auto created = sim::SimBus::create(network.sim, clock.now());
    ASSERT_TRUE(created);
    watched = created->get();
    link = make_simulated_link("sim", std::move(*created), clock);
    exchange = std::make_unique<FrameExchange>(*link, clock);
    bus = std::make_unique<Bus>(*exchange, clock);
  }
  void assign_eeproms_to_pdi(bool to_pdi) {
    ASSERT_TRUE(bus->write(Command::kBwr, 0, reg::kSiiConfiguration, std::uint8_t{to_pdi}));
  }
  Registers all_registers() const {
    Registers all;
    for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) all.push_back(watched->peek(i, 0x0000, 0x1000));
    return all;
  }
};

TEST_F(LookOnly, ChangesNoRegisterOfASlaveWhosePdiHasTheEeprom) {
  assign_eeproms_to_pdi(true);
  const auto before = all_registers();
  const auto scan = scan_slaves(*bus, {.look_only = true});
  ASSERT_TRUE(scan);
  EXPECT_EQ(changes(before, all_registers()), std::vector<std::string>{});
  ASSERT_EQ(scan->slaves.size(), 6U);
  for (const auto& slave : scan->slaves) {
    EXPECT_FALSE(slave.sii);
    ASSERT_TRUE(slave.sii_error);
    EXPECT_NE(slave.sii_error->detail.text().find("PDI"), std::string::npos);
    EXPECT_EQ(slave.station_address, 0);
  }
  EXPECT_EQ(scan->slaves[5].previous, (PreviousPort{4, 1}));
}

TEST_F(LookOnly, ReadsEepromsThatBelongToEtherCatAndChangesNothingElse) {
  const auto before = all_registers();
  const auto scan = scan_slaves(*bus, {.look_only = true});
  ASSERT_TRUE(scan);
  expect_true(*scan, network);
  auto found = changes(before, all_registers());
  // Command, address and data of the EEPROM interface: 0x0502 to 0x050F.
  std::erase_if(found, [](const std::string& change) {
    const auto at = std::stoi(change.substr(change.find("0x")), nullptr, 16);
    return at >= reg::kSiiControl && at < 0x0510;
  });
  EXPECT_EQ(found, std::vector<std::string>{});
}

TEST_F(LookOnly, AFullScanDoesChangeRegisters) {
  // The watcher sees what it is there for.
  const auto before = all_registers();
  ASSERT_TRUE(scan_slaves(*bus));
  EXPECT_FALSE(changes(before, all_registers()).empty());
}

TEST_F(LookOnly, EepromsGoBackToThePdiAfterAFullScan) {
  assign_eeproms_to_pdi(true);
  ASSERT_TRUE(scan_slaves(*bus));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(watched->peek(i, reg::kSiiConfiguration, 1)[0] & 1, 1) << i;
}

TEST_F(LookOnly, EepromsGoBackToThePdiWhenTheScanIsCancelled) {
  assign_eeproms_to_pdi(true);
  std::atomic<bool> cancel{false};
  Bus cancellable(*exchange, clock, &cancel);
  const auto scan =
      scan_slaves(cancellable, {}, {.progress = [&](std::size_t done, std::size_t) { cancel = done > 0; }});
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().code, ErrorCode::kCancelled);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(watched->peek(i, reg::kSiiConfiguration, 1)[0] & 1, 1) << i;
}

}  // namespace
}  // namespace syncline
