// SPDX-License-Identifier: Apache-2.0
// The simulated segment on a wire: a veth pair in a network namespace of the test's own. These tests run on
// the real clock because the wire does; they ask for what must come, never for how soon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/composition/load_scenario.h"
#include "app/composition/open_link.h"
#include "channels/event.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "engine/simulate_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "findings/error_text.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/net_namespace.h"
#include "tests/scenario/served_bus.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

using test::NetNamespace;
using test::ServedBus;

const std::string kMachine = test::source_dir() + "/resources/demo/machine.toml";
const std::string kMasterLink = std::string("nic:") + NetNamespace::kMasterEnd;

class VethBus : public testing::Test {
 protected:
  void SetUp() override {
    if (!network_.ready()) GTEST_SKIP() << "no permission to create a network namespace with a veth pair";
  }
  NetNamespace network_;
};

TEST_F(VethBus, ScanOverTheWireFindsWhatTheScenarioSays) {
  ServedBus bus(kMachine);
  const auto simulated = scan_bus(open_link("sim:" + kMachine + "?virtual"));
  const auto wired = scan_bus(open_link(kMasterLink));
  ASSERT_TRUE(simulated);
  ASSERT_TRUE(wired) << wired.error().detail.text();
  ASSERT_EQ(wired->slaves.size(), simulated->slaves.size());
  for (std::size_t i = 0; i < wired->slaves.size(); ++i) {
    EXPECT_EQ(wired->slaves[i].identity, simulated->slaves[i].identity) << i;
    EXPECT_EQ(wired->slaves[i].alias, simulated->slaves[i].alias) << i;
    EXPECT_EQ(wired->slaves[i].dl_status.value, simulated->slaves[i].dl_status.value) << i;
  }
  const auto report = bus.finish();
  ASSERT_TRUE(report);
  EXPECT_GT(report->counters.frames, 20U);
  EXPECT_EQ(report->counters.lost, 0U);
  EXPECT_EQ(report->al_status.size(), wired->slaves.size());
}

TEST_F(VethBus, FramesFromTheShortestToTheLargestComeBackAsLongAsTheyWere) {
  ServedBus bus(kMachine);
  auto opened = open_link(kMasterLink);
  ASSERT_TRUE(opened);
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> broadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  builder.set_addresses(broadcast, opened->link->describe().mac);
  for (const std::size_t data : {std::size_t{1}, std::size_t{2}, std::size_t{31}, std::size_t{32}, kMaxDatagramData}) {
    builder.reset();
    ASSERT_TRUE(builder.add_zeros(Command::kBrd, 9, device_address(0, reg::kType), static_cast<std::uint16_t>(data)));
    // A veth carries the frame as it is, without the padding that a cable needs.
    const auto size = kEthernetHeaderSize + kEtherCatHeaderSize + kDatagramHeaderSize + data + kWkcSize;
    const auto frame = builder.finish().first(size);
    ASSERT_TRUE(opened->link->send(frame));
    std::array<std::uint8_t, 1514> buffer{};
    const auto received = opened->link->receive(buffer, opened->clock->now() + 10 * kSecond);
    ASSERT_TRUE(received);
    ASSERT_EQ(received->length, size);
    FrameReader reader{std::span(buffer).first(received->length)};
    const auto datagram = reader.next();
    ASSERT_TRUE(datagram);
    EXPECT_EQ(datagram->header.adp(), 9);
    EXPECT_EQ(datagram->wkc(), 9);
    EXPECT_NE(datagram->data[0], 0);
  }
}

TEST_F(VethBus, WhatIsNoGoodFrameDoesNotComeBack) {
  ServedBus bus(kMachine);
  auto opened = open_link(kMasterLink);
  ASSERT_TRUE(opened);
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> broadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  builder.set_addresses(broadcast, opened->link->describe().mac);
  ASSERT_TRUE(builder.add_zeros(Command::kBrd, 1, device_address(0, reg::kType), 2));
  const auto good = builder.finish();
  std::vector<std::uint8_t> lying(good.begin(), good.end());
  lying[22] = 0xFF;  // the datagram claims more bytes than the frame has
  ASSERT_TRUE(opened->link->send(lying));
  ASSERT_TRUE(opened->link->send(std::span(lying).first(15)));
  ASSERT_TRUE(opened->link->send(good));
  std::array<std::uint8_t, 1514> buffer{};
  const auto received = opened->link->receive(buffer, opened->clock->now() + 10 * kSecond);
  ASSERT_TRUE(received);
  FrameReader reader{std::span(buffer).first(received->length)};
  const auto datagram = reader.next();
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->wkc(), 9);
}

TEST_F(VethBus, MissingAndSleepingAdaptersAreNamedWithTheRemedy) {
  SimulateRequest request;
  request.adapter = "no-such-card";
  auto report = simulate_bus(load_network(kMachine, 0, {}), request);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kLinkNotFound);
  EXPECT_THAT(report.error().detail.text(), testing::HasSubstr(NetNamespace::kBusEnd));

  request.adapter = NetNamespace::kBusEnd;
  ASSERT_TRUE(NetNamespace::set_up(NetNamespace::kBusEnd, false));
  report = simulate_bus(load_network(kMachine, 0, {}), request);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kLinkDown);
  EXPECT_EQ(report.error().detail.text(), std::string("sudo ip link set ") + NetNamespace::kBusEnd + " up");
}

TEST_F(VethBus, AnAdapterThatGoesAwayIsWaitedFor) {
  ServedBus bus(kMachine);
  const auto set = [](const char* state) {
    return std::system((std::string("ip link set ") + NetNamespace::kBusEnd + " " + state).c_str());
  };
  ASSERT_EQ(set("down"), 0);
  EXPECT_FALSE(scan_bus(open_link(kMasterLink)));
  ASSERT_EQ(set("up"), 0);
  // The kernel tells the other end of the new carrier when it comes to it; until then opening fails at once.
  std::size_t found = 0;
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (found == 0 && std::chrono::steady_clock::now() < patience) {
    if (const auto scan = scan_bus(open_link(kMasterLink))) found = scan->slaves.size();
    std::this_thread::yield();
  }
  EXPECT_EQ(found, 9U);
  EXPECT_TRUE(bus.finish());
}

TEST_F(VethBus, MasterBringsTheMachineToOp) {
  ServedBus bus(kMachine);
  const auto scan = scan_bus(open_link(kMasterLink));
  ASSERT_TRUE(scan);
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  auto project = eni::project_from_scan(*scan, catalogue).project;
  // Patient enough for machines that are busy with other things; what is proved here is the wire, not the pace. The
  // slaves' clocks stay out of it: the master follows them.
  project.master.cycle_time = 4 * kMillisecond;
  project.master.dc.sync_window.enabled = false;
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  project.master.dc.dcm.in_sync_limit = kMillisecond;
  project.master.recovery.error_tries = 1'000;
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);

  std::atomic<bool> there{false};
  std::vector<std::string> errors;
  RunRequest request;
  request.duration = 60 * kSecond;
  request.stop = &there;
  request.on_event = [&](const Event& event) {
    const auto* change = event.as<events::StateChanged>();
    if (change != nullptr && event.slave == -1 && change->to == AlState::kOp) there = true;
    if (const auto* failure = event.as<events::Failure>()) errors.push_back(describe(failure->error));
  };
  const auto outcome = run_network(compiled->config, open_link(kMasterLink), request);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(there) << testing::PrintToString(errors);
  const auto report = bus.finish();
  ASSERT_TRUE(report);
  for (const auto status : report->al_status) EXPECT_EQ(al_state_of(status), AlState::kInit) << "left behind";
}

}  // namespace
}  // namespace syncline
