// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/core/sim/sim_probe.h"

/// Slaves that remember what the frames of every cycle do to them, against slaves that execute each datagram.
namespace syncline::test {
namespace {

constexpr std::uint32_t kPlanImage = 0x0100'0000;

struct Move {
  std::vector<std::uint8_t> frame;
  Nanoseconds later = 0;
  bool alone = false;  // time passes without a frame first
};

template <typename T>
T one_of(std::initializer_list<T> values) {
  return *rc::gen::elementOf(std::vector<T>(values));
}
bool one_in(int in) { return *rc::gen::inRange(0, in) == 0; }

std::vector<std::uint8_t> bytes(std::size_t count) {
  return *rc::gen::container<std::vector<std::uint8_t>>(count, rc::gen::arbitrary<std::uint8_t>());
}

SimConfig random_segment() {
  std::vector<SimSlaveConfig> slaves;
  const auto count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < count; ++i) {
    const auto kind = *rc::gen::inRange(0, 5);
    const char* const types[] = {"SL-2002", "SL-1002", "SL-SV7", "SL-XE2", "SL-6751"};
    const char* const behaviours[] = {"generic", "generic", "servo-y", "drive-c", "can-gateway"};
    slaves.push_back(sim_slave(types[kind], behaviours[kind]));
    auto& slave = slaves.back();
    slave.oscillator.ppm = *rc::gen::inRange(-100, 100);
    slave.oscillator.wander_ppm = one_in(2) ? 0.1 : 0;
    if (kind < 2) slave.dc = {one_in(2), true, !one_in(4)};
    slave.logical_read_write = !one_in(6);
  }
  auto config = line(std::move(slaves));
  if (one_in(4)) config.bus.loss = 0.02;
  return config;
}

/// SyncManagers and FMMUs as a master sets them up, most of them; the others map parts and bits.
void set_up(const SimConfig& config, std::vector<Move>& moves, std::uint32_t& end) {
  const auto write = [&](Command command, std::uint16_t adp, std::uint16_t ado, const std::vector<std::uint8_t>& data) {
    FrameBuilder builder;
    builder.add(command, 1, device_address(adp, ado), data);
    const auto frame = builder.finish();
    moves.push_back({{frame.begin(), frame.end()}, 50 * kMicrosecond});
  };
  for (std::uint16_t i = 0; i < config.slaves.size(); ++i) {
    const auto station = static_cast<std::uint16_t>(1001 + i);
    const auto start = le_bytes(station);
    write(Command::kApwr, static_cast<std::uint16_t>(0 - i), reg::kStationAddress, {start.begin(), start.end()});
    // Events that the slave tells in every datagram's IRQ.
    const auto events = le_bytes(one_of<std::uint16_t>({0, 0, 0x0004, 0x0008, 0x0FFF}));
    write(Command::kFpwr, station, reg::kEcatEventMask, {events.begin(), events.end()});
    unsigned fmmu = 0;
    const auto& managers = config.slaves[i].device.sync_managers;
    for (unsigned m = 0; m < managers.size(); ++m) {
      const auto& sm = managers[m];
      const auto length = std::max<std::uint16_t>(1, sm.default_size.value_or(4));
      std::vector<std::uint8_t> setting;
      ByteWriter(setting).u16(sm.start_address).u16(length).u8(sm.control_byte).u8(0).u8(1).u8(0);
      write(Command::kFpwr, station, reg::sync_manager(m), setting);
      const bool outputs = sm.type == SyncManagerType::kOutputs;
      if (!outputs && sm.type != SyncManagerType::kInputs) continue;
      const auto bit = one_in(4) ? *rc::gen::inRange(0, 8) : 0;
      std::vector<std::uint8_t> mapping;
      ByteWriter(mapping).u32(end).u16(length).u8(static_cast<std::uint8_t>(bit)).u8(7).u16(sm.start_address).u8(0);
      ByteWriter(mapping).u8(one_in(8) ? 3 : outputs ? 2 : 1).u8(1).u8(0).u16(0);
      write(Command::kFpwr, station, reg::fmmu(fmmu++), mapping);
      if (!one_in(4)) end += length;
    }
    std::vector<std::uint8_t> mailbox_state;  // and a bit of a register
    const auto place = static_cast<std::uint8_t>(*rc::gen::inRange(0, 8));
    ByteWriter(mailbox_state).u32(end).u16(1).u8(place).u8(place).u16(0x080D).u8(3).u8(1).u8(1).u8(0).u16(0);
    write(Command::kFpwr, station, reg::fmmu(fmmu), mailbox_state);
    end += one_in(2) ? 1 : 0;
    if (one_in(3)) continue;  // no SYNC signals
    auto cycles = le_bytes(one_of<std::uint32_t>({1'000'000, 250'000, 999'990}));
    std::vector<std::uint8_t> timing(cycles.begin(), cycles.end());
    cycles = le_bytes(one_of<std::uint32_t>({0, 100'000}));
    timing.insert(timing.end(), cycles.begin(), cycles.end());
    write(Command::kFpwr, station, reg::kSync0CycleTime, timing);
    const auto first = le_bytes(static_cast<std::uint64_t>(VirtualClock::kDefaultStart + 20 * kMillisecond));
    const auto offset = le_bytes(static_cast<std::uint64_t>(VirtualClock::kDefaultStart));
    write(Command::kFpwr, station, reg::kSystemTimeOffset, {offset.begin(), offset.end()});
    write(Command::kFpwr, station, reg::kStartTimeCyclicOperation, {first.begin(), first.end()});
    write(Command::kFpwr, station, reg::kActivation, {one_of<std::uint8_t>({3, 3, 7})});
  }
  for (const std::uint8_t state : {2, 4, 8}) {
    write(Command::kBwr, 0, reg::kAlControl, {state, 0});
    moves.push_back({moves.back().frame, 2 * kMillisecond, true});
  }
}

/// The frames of a cycle, a few shapes of them again and again.
std::vector<FrameBuilder> cyclic_frames(std::uint32_t end) {
  std::vector<FrameBuilder> frames(3);
  for (auto& builder : frames) {
    const auto size = static_cast<std::uint16_t>(one_of<unsigned>({4, 8}));
    if (!one_in(4))
      builder.add_zeros(one_in(2) ? Command::kArmw : Command::kFrmw, 1,
                        device_address(one_in(2) ? 0 : 1001, reg::kSystemTime), size);
    if (one_in(4)) builder.add_zeros(Command::kBwr, 1, device_address(0, reg::kSystemTime), size);
    const auto logical = one_of({Command::kLrw, Command::kLrw, Command::kLrd, Command::kLwr});
    const auto cut = one_in(3) ? *rc::gen::inRange(0U, 5U) : 0U;
    const auto length = std::max<std::uint32_t>(1, end - kPlanImage + *rc::gen::inRange(0U, 3U));
    builder.add_zeros(logical, 1, kPlanImage + cut, static_cast<std::uint16_t>(length));
    if (!one_in(3))
      builder.add_zeros(Command::kBrd, 1, device_address(0, one_of({reg::kAlStatus, reg::kDlStatus, reg::kType})), 2);
    if (!one_in(3)) builder.add_zeros(Command::kBrd, 1, device_address(0, reg::kSystemTimeDifference), 4);
    if (one_in(4)) builder.add_zeros(Command::kAprd, 1, device_address(0xFFFF, reg::kAlStatus), 2);
  }
  return frames;
}

std::vector<std::uint8_t> any_frame() {
  FrameBuilder builder;
  const auto adp = one_of<std::uint16_t>({0, 0xFFFF, 0xFFFE, 1001, 1002});
  const auto base = one_of<std::uint16_t>(
      {0x0000, 0x0100, 0x0200, 0x0300, 0x0400, 0x0600, 0x0800, 0x0900, 0x0980, 0x0FF0, 0x1000, 0x1100});
  builder.add(static_cast<Command>(*rc::gen::inRange(1, 15)), 1,
              device_address(adp, static_cast<std::uint16_t>(base + *rc::gen::inRange(0, 0x40))),
              bytes(*rc::gen::inRange<std::size_t>(0, 20)));
  const auto frame = builder.finish();
  return {frame.begin(), frame.end()};
}

/// Datagrams for single slaves behind all others.
void ask(FrameBuilder& builder) {
  const auto count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    const auto& asked = kAskedRegisters[*rc::gen::inRange<std::size_t>(0, std::size(kAskedRegisters))];
    const auto station = one_of<std::uint16_t>({1001, 1001, 1002, 1002, 1003, 1004, 1009});
    const auto command = one_in(12) ? one_of({Command::kFpwr, Command::kFprw}) : Command::kFprd;
    builder.add_zeros(command, 1, device_address(station, asked.address), asked.length);
  }
}

std::vector<Move> random_moves(const SimConfig& config) {
  std::vector<Move> moves;
  std::uint32_t end = kPlanImage;
  set_up(config, moves, end);
  const auto frames = cyclic_frames(end);
  const auto count = *rc::gen::inRange(5, 60);
  for (int i = 0; i < count; ++i) {
    const auto later = *rc::gen::inRange<Nanoseconds>(200 * kMicrosecond, kMillisecond);
    if (one_in(12)) {
      moves.push_back({any_frame(), later, one_in(3)});
      continue;
    }
    auto builder = frames[*rc::gen::inRange<std::size_t>(0, frames.size())];
    if (one_in(8)) builder = {};
    if (builder.empty() || one_in(3)) ask(builder);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    FrameReader reader(frame);
    while (const auto datagram = reader.next()) {
      std::ranges::copy(bytes(std::min<std::size_t>(datagram->data.size(), 8)), datagram->data.begin());
    }
    moves.push_back({std::move(frame), later, one_in(10)});
  }
  return moves;
}

/// All that came back, and what is in the slaves in the end.
std::vector<std::uint8_t> outcome(const SimConfig& config, const std::vector<Move>& moves, sim::SimBus::Work work) {
  auto now = VirtualClock::kDefaultStart;
  const auto bus = std::move(sim::SimBus::create(config, now, work).value());
  std::vector<std::uint8_t> all;
  for (const auto& move : moves) {
    now += move.later;
    if (move.alone) bus->advance_to(now);
    auto frame = move.frame;
    const auto returned = bus->execute(frame, now);
    all.push_back(returned.lost ? 1 : 0);
    const auto arrival = le_bytes(static_cast<std::uint64_t>(returned.arrival_time));
    all.insert(all.end(), arrival.begin(), arrival.end());
    if (!returned.lost) all.insert(all.end(), frame.begin(), frame.end());
  }
  // A SYNC signal in the middle of the last frame: whether it has been noted yet no frame can tell.
  bus->advance_to(now + kMillisecond);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto memory = bus->peek(i, 0, 0x2000);
    all.insert(all.end(), memory.begin(), memory.end());
  }
  return all;
}

RC_GTEST_PROP(SimFramePlan, FollowingAPlanIsExecutingTheDatagrams, ()) {
  const auto config = random_segment();
  const auto moves = random_moves(config);
  RC_ASSERT(outcome(config, moves, sim::SimBus::Work::kAtOnce) == outcome(config, moves, sim::SimBus::Work::kEach));
}

/// A frame of another shape in between, and settings that change: what was remembered does not stay.
TEST(SimFramePlan, SettingsThatChangeAreHeeded) {
  SimProbe probe(line({sim_slave("SL-2002"), sim_slave("SL-2002")}));
  const auto type = [&probe] { return probe.send(Command::kBrd, device_address(0, reg::kAlStatus), {0, 0}); };
  for (int i = 0; i < 3; ++i) EXPECT_EQ(type().wkc, 2);
  const auto read = [&probe] { return probe.send(Command::kLrd, kPlanImage, {0, 0}); };
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read().wkc, 0);
  std::vector<std::uint8_t> mapping;
  ByteWriter(mapping).u32(kPlanImage).u16(1).u8(0).u8(7).u16(reg::kType).u8(0).u8(1).u8(1).u8(0).u16(0);
  probe.write(1, reg::fmmu(0), mapping);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read().wkc, 1);
  EXPECT_EQ(read().data[0], probe.read(1, reg::kType, 1).data[0]);
  mapping[12] = 0;
  probe.write(1, reg::fmmu(0), mapping);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read().wkc, 0);
}

}  // namespace
}  // namespace syncline::test
