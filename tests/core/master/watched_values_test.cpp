// SPDX-License-Identifier: Apache-2.0
// Variables of the process image in the samples, against what went over the wire and what an application saw.
#include "master/cyclic/watched_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/cyclic_application.h"
#include "channels/master_channels.h"
#include "config/watched_variable.h"
#include "master/master_service.h"
#include "protocol/frame.h"
#include "support/byte_order.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

/// Moves the first axis along a ramp, and remembers the outputs that it set in each cycle.
class Ramp final : public CyclicApplication {
 public:
  explicit Ramp(const NetworkConfig& config)
      : control_(byte_of(config, "1.Controlword")),
        target_place_(byte_of(config, "1.Target position")),
        mode_(byte_of(config, "1.Modes of operation")),
        status_(byte_of(config, "1.Statusword")),
        position_(byte_of(config, "1.Position actual value")) {}
  void run(const Cycle& cycle, std::span<const std::uint8_t> inputs, std::span<std::uint8_t> outputs) override {
    const auto status = load_le<std::uint16_t>(inputs.subspan(status_)) & 0x6FU;
    const std::uint16_t control = status == 0x27 || status == 0x23 ? 0x0F : status == 0x21 ? 0x07 : 0x06;
    store_le(outputs.subspan(control_), control);
    outputs[mode_] = 8;
    if (status == 0x27 || always) target_ += 37;
    store_le(outputs.subspan(target_place_), static_cast<std::uint32_t>(target_));
    written[cycle.number] = static_cast<std::uint32_t>(target_);
    seen[cycle.number] = load_le<std::uint32_t>(inputs.subspan(position_));
  }
  bool always = false;                                   // whatever the drive does
  std::map<std::uint64_t, std::uint32_t> written, seen;  // by cycle: target; position of the cycle before

 private:
  static std::size_t byte_of(const NetworkConfig& config, std::string_view name) {
    const auto found = find_watchable(config, name);
    EXPECT_TRUE(found) << name;
    return found ? found->bit_offset / 8 : 0;
  }
  std::size_t control_, target_place_, mode_, status_, position_;
  std::int32_t target_ = 0;
};

/// What slaves put into the datagrams of process data that came back, by logical address.
class WireWitness final : public Link {
 public:
  WireWitness(std::unique_ptr<Link> inner, std::map<std::uint32_t, std::uint8_t>& read)
      : inner_(std::move(inner)), read_(read) {}
  Status send(std::span<const std::uint8_t> frame) override { return inner_->send(frame); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    if (received && received->length > 0) note(buffer.first(received->length));
    return received;
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    return inner_->send_corrected(frame, field);
  }

 private:
  void note(std::span<std::uint8_t> frame) {
    auto reader = FrameReader(frame);
    while (const auto datagram = reader.next()) {
      const auto command = datagram->header.command;
      if (command != Command::kLrd && command != Command::kLrw) continue;
      for (std::size_t i = 0; i < datagram->data.size(); ++i)
        read_[datagram->header.address + static_cast<std::uint32_t>(i)] = datagram->data[i];
    }
  }
  std::unique_ptr<Link> inner_;
  std::map<std::uint32_t, std::uint8_t>& read_;
};

class WatchedRun : public ::testing::Test {
 protected:
  void begin(const test::SimulatedNetwork& network) {
    config = network.compiled();
    power_on = clock.now();
    ramp = std::make_unique<Ramp>(config);
    service = std::make_unique<MasterService>(std::make_unique<WireWitness>(network.link(clock), on_wire), clock);
    service->channels().application.store(ramp.get());
  }
  WatchedPlace place(std::string_view name) {
    const auto found = find_watchable(config, name);
    EXPECT_TRUE(found) << name;
    if (!found) return {};
    return {found->output, found->bit_offset, found->bit_size, found->slave};
  }
  void watch(std::uint32_t list, std::initializer_list<WatchedPlace> places) {
    WatchCommand command{list, static_cast<std::uint8_t>(places.size()), {}};
    std::ranges::copy(places, command.places.begin());
    service->channels().commands.push(command);
  }
  void go_online() { service->channels().commands.push(GoOnlineCommand{config, AlState::kOp}); }
  std::vector<CycleSample> run(Nanoseconds duration) {
    service->run_for(duration);
    std::vector<CycleSample> samples;
    service->channels().samples.pop(samples);
    return samples;
  }
  /// Where the inputs of the image begin on the wire: one datagram reads all of them here.
  [[nodiscard]] std::uint32_t wire_address(std::uint32_t image_byte) const {
    for (const auto& frame : config.cyclic.front().frames) {
      for (const auto& command : frame.commands) {
        if (command.command != Command::kLrw && command.command != Command::kLrd) continue;
        const auto begin = command.input_offset + config.image.command_data_offset;
        if (image_byte >= begin && image_byte < begin + command.length())
          return command.logical_address + image_byte - begin;
      }
    }
    ADD_FAILURE() << "no command reads byte " << image_byte;
    return 0;
  }
  static bool known(const CycleSample& sample, std::size_t place) { return (sample.watched_known >> place & 1) != 0; }

  VirtualClock clock;
  Nanoseconds power_on = 0;
  NetworkConfig config;
  std::map<std::uint32_t, std::uint8_t> on_wire;
  std::unique_ptr<Ramp> ramp;
  std::unique_ptr<MasterService> service;  // last: it uses what stands above
};

constexpr auto kPosition = "1.Position actual value", kTarget = "1.Target position";

TEST_F(WatchedRun, HoldsWhatTheDriveSentInEachCycle) {
  begin(test::two_axes());
  const auto position = place(kPosition);
  watch(1, {position, place(kTarget), place("1.Statusword")});
  go_online();
  const auto samples = run(8 * kSecond);
  std::size_t compared = 0, moved = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const auto& sample = samples[i];
    EXPECT_EQ(sample.watch_list, 1U);
    if (!known(sample, 0) || !ramp->seen.contains(sample.cycle + 1)) continue;
    ASSERT_EQ(sample.watched[0], ramp->seen[sample.cycle + 1]) << "cycle " << sample.cycle;
    ASSERT_TRUE(known(sample, 1));
    ASSERT_EQ(sample.watched[1], ramp->written[sample.cycle]) << "cycle " << sample.cycle;
    ++compared;
    if (i > 0 && samples[i - 1].watched[0] != sample.watched[0]) ++moved;
  }
  EXPECT_GT(compared, 4'000U);
  EXPECT_GT(moved, 1'000U) << "the axis follows the ramp";
  // A cycle at a time against the bytes that the slave put into the frame.
  const auto first = wire_address(position.bit_offset / 8);
  for (int step = 0; step < 500; ++step) {
    on_wire.clear();
    ASSERT_TRUE(service->step());
    std::vector<CycleSample> one;
    service->channels().samples.pop(one);
    ASSERT_EQ(one.size(), 1U);
    std::uint32_t wire = 0;
    for (std::uint32_t byte = 0; byte < 4; ++byte) wire |= std::uint32_t{on_wire.at(first + byte)} << (8 * byte);
    ASSERT_EQ(one[0].watched[0], wire);
  }
}

TEST_F(WatchedRun, LostFramesAndASlaveThatIsAwayAreGapsAndNoZeros) {
  auto network = test::two_axes();
  network.project.master.recovery.automatic = false;
  network.sim.faults.push_back({.kind = FaultKind::kLoseFrames, .slave = -1, .at = 6 * kSecond, .count = 3});
  network.sim.faults.push_back({.kind = FaultKind::kSlaveOff, .slave = 2, .at = 7 * kSecond, .until = 100 * kSecond});
  begin(network);
  watch(1, {place("2.Statusword"), place("1.Statusword"), place(kTarget)});
  go_online();
  const auto samples = run(9 * kSecond);
  std::size_t lost = 0, away = 0, alone = 0;
  for (const auto& sample : samples) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (known(sample, i)) continue;
      EXPECT_EQ(sample.watched[i], 0U) << "nothing is left of it";
    }
    if ((sample.flags & CycleSample::kFrameLost) != 0) {
      ++lost;
      EXPECT_FALSE(known(sample, 0));
      EXPECT_FALSE(known(sample, 1));
      EXPECT_TRUE(known(sample, 2)) << "what was sent is known";
    } else if (sample.master_state == 8 && sample.send_time - power_on < 7 * kSecond) {
      EXPECT_TRUE(known(sample, 0));
      EXPECT_NE(sample.watched[0], 0U);
    }
    if (sample.send_time - power_on > 7'500 * kMillisecond) {
      EXPECT_FALSE(known(sample, 0)) << "its last word is no present one";
      ++away;
      if (known(sample, 1)) ++alone;
    }
  }
  EXPECT_GE(lost, 3U);
  EXPECT_GE(away, 1'400U);
  EXPECT_GE(alone, 1'400U) << "the other slave is known as before";
}

TEST_F(WatchedRun, NothingOfOneListIsEverTakenForAnothers) {
  begin(test::two_axes());
  watch(1, {place("1.Statusword"), place(kTarget)});
  go_online();
  auto samples = run(5 * kSecond);
  for (std::uint32_t list = 2; list < 40; ++list) {
    list % 2 == 0 ? watch(list, {place(kTarget), place("1.Statusword")}) : watch(list, {place("1.Statusword")});
    std::ranges::copy(run((list % 5 + 1) * kMillisecond), std::back_inserter(samples));
  }
  watch(40, {});
  std::ranges::copy(run(10 * kMillisecond), std::back_inserter(samples));
  std::uint32_t newest = 0;
  for (const auto& sample : samples) {
    EXPECT_GE(sample.watch_list, newest) << "in their order";
    newest = sample.watch_list;
    if (sample.master_state != 8) continue;
    const std::size_t target = sample.watch_list == 1 ? 1 : sample.watch_list % 2 == 0 ? 0 : 16;
    if (target < 16 && sample.watch_list < 40) {
      ASSERT_EQ(sample.watched[target], ramp->written[sample.cycle]) << "list " << sample.watch_list;
    }
  }
  EXPECT_EQ(newest, 40U);
  EXPECT_EQ(samples.back().watched_known, 0);
}

TEST_F(WatchedRun, WhatTheImageDoesNotHaveIsNeverKnown) {
  begin(test::two_axes());
  WatchedPlace beyond{false, config.image.input_bytes * 8 - 8, 64, -1}, none{false, 0, 0, -1}, wide{true, 0, 65, -1};
  WatchedPlace nobody = place("1.Statusword");
  nobody.slave = 77;
  watch(1, {beyond, none, wide, nobody, {true, 0xFFFF'FFFF, 64, -1}});
  go_online();
  for (const auto& sample : run(6 * kSecond)) ASSERT_EQ(sample.watched_known, 0);
}

TEST_F(WatchedRun, BitsAreTakenFromWhereverTheyBegin) {
  begin(test::two_axes());
  const auto whole = place(kPosition);
  // Pieces of the same 64 bits, at every shift, against those bits.
  for (std::uint32_t shift = 0; shift < 8; ++shift) {
    watch(shift + 1, {{false, whole.bit_offset + shift, 56, 1},
                      {false, whole.bit_offset, 64, 1},
                      {false, whole.bit_offset + shift, 1, 1},
                      {false, whole.bit_offset + shift, 8, 1}});
    if (shift == 0) go_online();
    const auto sample = run(shift == 0 ? 7 * kSecond : 5 * kMillisecond).back();
    ASSERT_EQ(sample.watch_list, shift + 1);
    ASSERT_EQ(sample.watched_known, 0b1111);
    const auto bits = sample.watched[1];
    EXPECT_EQ(sample.watched[2], bits >> shift & 1);
    EXPECT_EQ(sample.watched[3], bits >> shift & 0xFF);
    EXPECT_EQ(sample.watched[0] & ((std::uint64_t{1} << (56 - shift)) - 1),
              bits >> shift & ((std::uint64_t{1} << (56 - shift)) - 1));
  }
}

TEST_F(WatchedRun, AForcedOutputIsWatchedAsItGoesOut) {
  begin(test::two_axes());
  const auto target = place(kTarget);
  watch(1, {target});
  go_online();
  (void)run(6 * kSecond);
  service->channels().commands.push(ForceOutputCommand{target.bit_offset, 32, 0x1234'5678});
  EXPECT_EQ(run(20 * kMillisecond).back().watched[0], 0x1234'5678U);
  service->channels().commands.push(ReleaseAllOutputsCommand{});
  const auto free = run(20 * kMillisecond).back();
  EXPECT_EQ(free.watched[0], ramp->written[free.cycle]);
}

/// Each second cycle: in between a slower task's variables are those of the last time.
TEST_F(WatchedRun, OfASlowerTaskAreWhatTheyWereWhenItWasDue) {
  begin(test::two_axes());
  ASSERT_EQ(config.cyclic.size(), 1U);
  auto slow = config.cyclic.front();
  slow.cycle_time *= 2;
  // The process data alone move to it; clocks and states stay in the base task.
  for (auto& frame : config.cyclic.front().frames)
    std::erase_if(frame.commands, [](const CyclicCmd& command) { return is_logical(command.command); });
  for (auto& frame : slow.frames)
    std::erase_if(frame.commands, [](const CyclicCmd& command) { return !is_logical(command.command); });
  config.cyclic.push_back(slow);
  ramp->always = true;
  watch(1, {place("1.Statusword"), place(kTarget)});
  go_online();
  const auto samples = run(7 * kSecond);
  ASSERT_GT(samples.size(), 1'000U);
  std::size_t held = 0;
  // The even or the odd ones: those whose outputs come just in front of a SYNC0.
  const auto& first = samples[samples.size() - 1'000];
  const auto odd = first.watched[1] == ramp->written[first.cycle] ? first.cycle % 2 : (first.cycle + 1) % 2;
  for (std::size_t i = samples.size() - 1'000; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i].watched_known, 0b11) << "cycle " << samples[i].cycle;
    const auto due = samples[i].cycle - (samples[i].cycle + odd) % 2;
    ASSERT_EQ(samples[i].watched[1], ramp->written[due]);
    if (due == samples[i].cycle && (samples[i].flags & CycleSample::kReferenceValid) != 0) {
      const auto since = (samples[i].reference_time - samples[i].sync_base) % slow.cycle_time;
      EXPECT_GT(since, slow.cycle_time / 2) << "in front of the SYNC0 of every second cycle";
    }
    if (due != samples[i].cycle && ramp->written[due] != ramp->written[samples[i].cycle]) ++held;
  }
  EXPECT_GT(held, 100U);
}

}  // namespace
}  // namespace syncline
