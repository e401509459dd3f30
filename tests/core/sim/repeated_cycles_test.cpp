// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "tests/core/sim/drive_bed.h"

/// A drive whose cycles are only counted while they are all alike, against one that lives through each of them.
namespace syncline::test {
namespace {

using sim::SimBus;

constexpr std::uint32_t kImage = 0x0100'0000;
constexpr std::uint16_t kStation = 1001;

bool one_in(int count) { return *rc::gen::inRange(0, count) == 0; }

struct Setting {
  std::vector<FaultConfig> faults;
  double ppm = 0;
  std::uint32_t cycle = 1'000'000;
  bool alarms = true;  // at the limit of the errors
  [[nodiscard]] bool answers() const {
    return std::ranges::find(faults, FaultKind::kStopApplication, &FaultConfig::kind) == faults.end();
  }
};

/// A drive that gets process data by a mapping, as masters send them.
class Mapped : public DriveBed {
 public:
  Mapped(const Setting& setting, SimBus::Work work) : DriveBed("SL-SV7", setting.faults, setting.ppm, work) {
    start_sync0(setting.cycle);
    probe.write(0, reg::kStationAddress, {kStation & 0xFF, kStation >> 8});
    map(0, 2, 2);
    map(1, 3, 1);
    if (!setting.alarms) no_limit_ = write(0x10F1, 2, {0, 0}) == 0;
    at_start_ = to_op();
  }
  [[nodiscard]] std::uint16_t at_start() const { return at_start_; }
  [[nodiscard]] bool no_limit() const { return no_limit_; }
  /// Everything that came back. `time_error`: of the system time that is sent first; none: no such datagram.
  std::vector<std::uint8_t> exchange(std::optional<Nanoseconds> time_error, bool process_data) {
    FrameBuilder builder;
    if (time_error) {
      const auto time = le_bytes(probe.bus->system_time(0) + static_cast<std::uint64_t>(*time_error));
      builder.add(Command::kBwr, 1, device_address(0, reg::kSystemTime), time);
    }
    builder.add_zeros(Command::kBrd, 2, device_address(0, reg::kSystemTimeDifference), 4);
    std::vector<std::uint8_t> image(length(2) + length(3));
    store_le(std::span(image).first(2), controlword);
    store_le(std::span(image).subspan(2, 4), static_cast<std::uint32_t>(target));
    image[12] = mode;
    if (process_data) builder.add(Command::kLrw, 3, kImage, image);
    if (asked) builder.add_zeros(Command::kFprd, 4, device_address(kStation, asked->address), asked->length);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    (void)probe.bus->execute(frame, probe.now);
    return frame;
  }
  /// It is asked for this in a frame of its own.
  std::vector<std::uint8_t> ask(const AskedRegisters& registers) {
    return probe
        .send(Command::kFprd, device_address(kStation, registers.address), std::vector<std::uint8_t>(registers.length))
        .data;
  }
  /// Every frame with process data or time asks it for these, too.
  std::optional<AskedRegisters> asked;
  /// What only the drive knows.
  std::vector<std::uint32_t> objects() {
    std::vector<std::uint32_t> found;
    for (const std::uint16_t index : {0x1C32, 0x1C33}) {
      for (const std::uint8_t sub : {5, 6, 9, 0x0B, 0x0C, 0x0D, 0x20}) found.push_back(read(index, sub));
    }
    return found;
  }

 private:
  void map(unsigned fmmu, unsigned manager, std::uint8_t direction) {
    const auto start = kImage + (manager == 3 ? static_cast<std::uint32_t>(length(2)) : 0);
    std::vector<std::uint8_t> bytes;
    ByteWriter writer(bytes);
    writer.u32(start).u16(static_cast<std::uint16_t>(length(manager))).u8(0).u8(7);
    writer.u16(static_cast<std::uint16_t>(device.sync_managers[manager].start_address)).u8(0).u8(direction);
    writer.u8(1).u8(0).u16(0);
    probe.write(0, reg::fmmu(fmmu), bytes);
  }
  std::uint16_t at_start_ = 0;
  bool no_limit_ = false;
};

/// The same is done to both, and the same comes back.
class Drives {
 public:
  explicit Drives(const Setting& setting)
      : counted_(setting, SimBus::Work::kAtOnce), each_(setting, SimBus::Work::kEach), setting_(setting) {}

  template <typename Do>
  auto both(Do&& what) {
    auto a = what(counted_);
    RC_ASSERT(a == what(each_));
    return a;
  }
  /// So many cycles like the last one; `phase`: of the frame, from SYNC0 on.
  void run(int cycles, Nanoseconds phase, bool time, bool two_frames) {
    both([&](Mapped& drive) {
      std::vector<std::vector<std::uint8_t>> replies;
      for (int i = 0; i < cycles; ++i) {
        drive.probe.now += 1;
        drive.probe.now = drive.next_sync() + phase;
        if (two_frames) {
          replies.push_back(drive.exchange(time ? std::optional<Nanoseconds>(20 - i % 3) : std::nullopt, false));
          drive.probe.now += 30 * kMicrosecond;
        }
        replies.push_back(drive.exchange(!two_frames && time ? std::optional<Nanoseconds>(20) : std::nullopt, true));
      }
      return replies;
    });
  }
  void end() {
    both([](Mapped& drive) {
      drive.probe.pass(0);
      return drive.probe.bus->peek(0, 0, 0x1200);
    });
    both([](Mapped& drive) {
      drive.probe.pass(100 * kMillisecond);  // behind all faults
      return drive.probe.bus->peek(0, 0, 0x1200);
    });
    both([](Mapped& drive) { return drive.objects(); });
  }
  [[nodiscard]] const Setting& setting() const { return setting_; }

 private:
  Mapped counted_, each_;
  const Setting& setting_;
};

Setting random_setting() {
  Setting setting;
  setting.ppm = *rc::gen::inRange(-100, 101);
  setting.alarms = one_in(2);
  setting.cycle = *rc::gen::element<std::uint32_t>(500'000, 1'000'000, 2'000'000);
  for (const auto kind : {FaultKind::kSlowApplication, FaultKind::kStopApplication, FaultKind::kSilentSync}) {
    if (!one_in(5)) continue;
    FaultConfig fault;
    fault.kind = kind;
    fault.slave = 0;
    fault.at = *rc::gen::inRange<Nanoseconds>(510, 600) * kMillisecond;
    fault.until = fault.at + *rc::gen::inRange<Nanoseconds>(1, 10) * kMillisecond;
    fault.value_ns = *rc::gen::inRange<Nanoseconds>(100, 3000) * kMicrosecond;
    setting.faults.push_back(fault);
  }
  return setting;
}

AskedRegisters any_registers() {
  return kAskedRegisters[*rc::gen::inRange<std::size_t>(0, std::size(kAskedRegisters))];
}

void any_move(Drives& drives, Nanoseconds& phase, bool time, bool two_frames) {
  switch (*rc::gen::inRange(0, 13)) {
    case 0:  // now and then too late for the next SYNC0
      phase = *rc::gen::inRange<Nanoseconds>(0, drives.setting().cycle);
      return;
    case 1: {
      const auto word = *rc::gen::element<std::uint16_t>(0, 6, 7, 0x80, 0x0F);
      drives.both([word](Mapped& drive) { return drive.controlword = word; });
      return;
    }
    case 2: {
      const auto target = *rc::gen::inRange(0, 1000);
      drives.both([target](Mapped& drive) { return drive.target = target; });
      return;
    }
    case 3: {  // no frames
      const auto pause = *rc::gen::inRange<Nanoseconds>(0, 4 * Nanoseconds{drives.setting().cycle});
      drives.both([pause](Mapped& drive) {
        drive.probe.pass(pause);
        return drive.probe.now;
      });
      return;
    }
    case 4:
      drives.both([](Mapped& drive) { return drive.status(); });
      return;
    case 5:
      if (!drives.setting().answers()) return;
      drives.both([](Mapped& drive) { return drive.read(0x1C32, 0x0C); });
      return;
    case 6: {
      if (!drives.setting().answers()) return;
      const auto command = static_cast<std::uint8_t>(*rc::gen::inRange(0, 2));
      drives.both([command](Mapped& drive) { return drive.write(0x1C32, 8, {command, 0}); });
      return;
    }
    case 7: {
      const auto registers = any_registers();
      drives.both([&registers](Mapped& drive) { return drive.ask(registers); });
      return;
    }
    case 8: {
      const auto asked = one_in(3) ? std::nullopt : std::optional(any_registers());
      drives.both([&asked](Mapped& drive) {
        drive.asked = asked;
        return 0;
      });
      return;
    }
    default:
      return drives.run(*rc::gen::inRange(1, 12), phase, time, two_frames);
  }
}

RC_GTEST_PROP(SimRepeatedCycles, CountingThemIsLivingThroughEach, ()) {
  const auto setting = random_setting();
  Drives drives(setting);
  Nanoseconds phase = setting.cycle / 3;
  const bool time = !one_in(3), two_frames = one_in(2);
  drives.run(10, phase, time, two_frames);
  const auto moves = *rc::gen::inRange(3, 25);
  for (int i = 0; i < moves; ++i) any_move(drives, phase, time, two_frames);
  drives.end();
}

TEST(SimRepeatedCycles, WhatIsMissedBehindThemIsCounted) {
  for (const auto work : {SimBus::Work::kAtOnce, SimBus::Work::kEach}) {
    Setting setting;
    setting.alarms = false;
    Mapped drive(setting, work);
    ASSERT_EQ(drive.at_start(), 8);
    ASSERT_TRUE(drive.no_limit());
    const auto missed_in = [&drive](int cycles, Nanoseconds pause) {
      const auto before = drive.read(0x1C32, 0x0C);
      for (int i = 0; i < cycles; ++i) {
        drive.probe.now += 1;
        drive.probe.now = drive.next_sync() + 300 * kMicrosecond;
        (void)drive.exchange(20, true);
      }
      drive.probe.pass(pause);
      return drive.read(0x1C32, 0x0C) - before;
    };
    (void)missed_in(3, 0);
    const auto by_reading = missed_in(3, 0);
    EXPECT_EQ(missed_in(200, 0), by_reading);
    EXPECT_EQ(missed_in(200, 5 * kMillisecond), by_reading + 4);
    EXPECT_EQ(drive.status(), 8);
  }
}

}  // namespace
}  // namespace syncline::test
