// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/output_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "channels/command.h"
#include "channels/cyclic_application.h"
#include "channels/event.h"
#include "channels/image_contents.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "support/byte_order.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

using Image = std::array<std::uint8_t, 4>;

TEST(OutputForces, HoldBitsAcrossBytesAndLeaveTheirNeighbours) {
  OutputForces forces(4);
  ASSERT_TRUE(forces.force({6, 5, 0b10110}));
  EXPECT_EQ(forces.count(), 5U);
  Image outputs{0xFF, 0x00, 0x12, 0x34};
  const auto before = outputs;
  forces.apply(outputs);
  EXPECT_EQ(outputs, (Image{0xBF, 0x05, 0x12, 0x34}));
  forces.restore(outputs);
  EXPECT_EQ(outputs, before) << "what the application wrote";
  ASSERT_TRUE(forces.release({6, 2}));
  EXPECT_EQ(forces.count(), 3U);
  forces.apply(outputs);
  EXPECT_EQ(outputs, (Image{0xFF, 0x05, 0x12, 0x34}));
  forces.restore(outputs);
  forces.release_all();
  EXPECT_EQ(forces.count(), 0U);
  forces.apply(outputs);
  EXPECT_EQ(outputs, before);
}

TEST(OutputForces, AnotherValueReplacesTheOneBefore) {
  OutputForces forces(4);
  ASSERT_TRUE(forces.force({8, 8, 0xA5}));
  ASSERT_TRUE(forces.force({8, 8, 0x5A}));
  EXPECT_EQ(forces.count(), 8U);
  Image outputs{};
  forces.apply(outputs);
  EXPECT_EQ(outputs, (Image{0, 0x5A, 0, 0}));
}

TEST(OutputForces, RefuseWhatIsNotThere) {
  OutputForces forces(4);
  EXPECT_FALSE(forces.force({0, 0, 0}));
  EXPECT_FALSE(forces.force({31, 2, 0}));
  EXPECT_FALSE(forces.force({0, 65, 0}));
  EXPECT_FALSE(forces.force({0xFFFF'FFFF, 64, 0})) << "no sum that wraps";
  EXPECT_FALSE(forces.release({32, 1}));
  EXPECT_TRUE(forces.force({31, 1, 1}));
  EXPECT_EQ(forces.count(), 1U);
  OutputForces none(0);
  EXPECT_FALSE(none.force({0, 1, 1}));
}

/// Sets the controlword of the first axis once, and relies on it to stay.
class Once final : public CyclicApplication {
 public:
  explicit Once(std::size_t place) : place_(place) {}
  void run(const Cycle&, std::span<const std::uint8_t>, std::span<std::uint8_t> outputs) override {
    if (!done_) store_le(outputs.subspan(place_), std::uint16_t{0x0006});
    done_ = true;
    seen = load_le<std::uint16_t>(outputs.subspan(place_));
  }
  std::uint16_t seen = 0;

 private:
  std::size_t place_;
  bool done_ = false;
};

/// On a drive of which the statusword says what controlword it got.
class ForcedDrive : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto network = test::two_axes();
    config = network.compiled();
    controlword = config.slaves[1].send->bit_start;
    statusword = config.slaves[1].receive->bit_start / 8;
    service = std::make_unique<MasterService>(network.link(clock), clock);
    service->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
    run(5 * kSecond);
    ASSERT_EQ(snapshot.state, AlState::kOp);
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    service->channels().snapshot.read(snapshot);
    service->channels().image.read(image);  // once for the one that waited,
    service->run_for(100 * kMillisecond);
    ASSERT_TRUE(service->channels().image.read(image));
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
  }
  /// 0x6041, the bits that say the state of the drive.
  [[nodiscard]] unsigned drive_state() const {
    return load_le<std::uint16_t>(image.inputs().subspan(statusword)) & 0x006FU;
  }
  [[nodiscard]] unsigned sent() const { return load_le<std::uint16_t>(image.outputs().subspan(controlword / 8)); }
  [[nodiscard]] std::vector<std::uint32_t> told() const {
    std::vector<std::uint32_t> bits;
    for (const auto& event : events) {
      if (const auto* forced = event.as<events::OutputsForced>()) bits.push_back(forced->bits);
    }
    return bits;
  }
  void force(std::uint16_t value) { service->channels().commands.push(ForceOutputCommand{controlword, 16, value}); }

  VirtualClock clock;
  NetworkConfig config;
  std::unique_ptr<MasterService> service;
  Snapshot snapshot;
  ImageContents image;
  std::vector<Event> events;
  std::uint32_t controlword = 0;  // bit
  std::size_t statusword = 0;     // byte
};

TEST_F(ForcedDrive, FollowsWhatIsForcedUntilItIsReleased) {
  EXPECT_EQ(drive_state(), 0x40U) << "switch on disabled";
  force(0x0006);
  run(50 * kMillisecond);
  EXPECT_EQ(drive_state(), 0x21U) << "ready to switch on";
  EXPECT_EQ(sent(), 0x0006U);
  EXPECT_TRUE(std::ranges::any_of(image.forced(), [](std::uint8_t bits) { return bits == 0xFF; }));
  service->channels().snapshot.read(snapshot);
  EXPECT_EQ(snapshot.forced_bits, 16U);
  service->channels().commands.push(ReleaseOutputCommand{controlword, 16});
  run(50 * kMillisecond);
  EXPECT_EQ(sent(), 0U);
  EXPECT_EQ(drive_state(), 0x40U);
  EXPECT_EQ(told(), (std::vector<std::uint32_t>{16, 0}));
}

TEST_F(ForcedDrive, GetsBackWhatTheApplicationHadWritten) {
  Once application(controlword / 8);
  service->channels().application = &application;
  run(50 * kMillisecond);
  ASSERT_EQ(drive_state(), 0x21U);
  force(0x0000);
  run(50 * kMillisecond);
  EXPECT_EQ(drive_state(), 0x40U);
  EXPECT_EQ(application.seen, 0x0006U) << "its own outputs stay its own";
  service->channels().commands.push(ReleaseAllOutputsCommand{});
  run(50 * kMillisecond);
  EXPECT_EQ(drive_state(), 0x21U);
  service->channels().application = nullptr;
}

TEST_F(ForcedDrive, IsForcedNoMoreAfterTheBusWasOffline) {
  force(0x0006);
  run(50 * kMillisecond);
  service->channels().commands.push(GoOfflineCommand{});
  service->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  run(5 * kSecond);
  EXPECT_EQ(snapshot.forced_bits, 0U);
  EXPECT_EQ(sent(), 0U);
}

TEST_F(ForcedDrive, RefusesBitsThatTheImageHasNot) {
  service->channels().commands.push(ForceOutputCommand{8 * config.image.output_bytes, 1, 1});
  run(10 * kMillisecond);
  EXPECT_TRUE(std::ranges::any_of(events, [](const Event& event) { return event.is<events::Failure>(); }));
  EXPECT_EQ(snapshot.forced_bits, 0U);
}

TEST_F(ForcedDrive, ShowsAllOfTheImage) {
  EXPECT_FALSE(config.image.inputs.empty());
  for (const auto& variable : config.image.inputs) {
    EXPECT_EQ(image.known()[variable.bit_offset / 8], 0xFF) << variable.name << " of a machine in OP";
  }
  EXPECT_EQ(image.inputs().size(), config.image.input_bytes);
  EXPECT_EQ(image.outputs().size(), config.image.output_bytes);
}

/// Frames that carry inputs are lost: what the image keeps of them is no present value.
TEST(ImageOfARun, KnowsWhichInputsAreOld) {
  auto network = test::two_axes();
  network.sim.faults.push_back(
      {.kind = FaultKind::kCableBreak, .slave = 0, .at = 6 * kSecond, .until = 6300 * kMillisecond});
  VirtualClock clock;
  MasterService service(network.link(clock), clock);
  auto& channels = service.channels();
  channels.commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const auto begin = clock.now();
  const auto known_at = [&](Nanoseconds time) {
    ImageContents image;
    service.run_for(begin + time - 110 * kMillisecond - clock.now());
    (void)channels.image.read(image);
    service.run_for(110 * kMillisecond);
    EXPECT_TRUE(channels.image.read(image));
    return std::ranges::count_if(image.known(), [](std::uint8_t bits) { return bits != 0; });
  };
  const auto all = known_at(5900 * kMillisecond);
  EXPECT_GT(all, 0);
  EXPECT_EQ(known_at(6250 * kMillisecond), 0) << "for a quarter of a second nothing came back";
  EXPECT_EQ(known_at(12 * kSecond), all);
}

}  // namespace
}  // namespace syncline
