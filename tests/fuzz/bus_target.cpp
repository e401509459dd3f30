// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <memory>

#include "config/sim_config.h"
#include "fuzz/bus_targets.h"
#include "fuzz/script.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/sim_bus.h"
#include "support/byte_order.h"
#include "support/clock.h"
#include "tests/support/own_devices.h"

namespace syncline::fuzz {
namespace {

constexpr std::size_t kSlaves = 3;
constexpr int kMostFrames = 48;
constexpr std::array<Nanoseconds, 8> kPauses{0,
                                             200,
                                             10 * kMicrosecond,
                                             125 * kMicrosecond,
                                             500 * kMicrosecond,
                                             kMillisecond,
                                             4 * kMillisecond,
                                             30 * kMillisecond};
constexpr std::array<std::uint16_t, 8> kAddresses{0, 0xFFFF, 0xFFFE, 0xFFFD, 1001, 1002, 0, 0x1234};

SimConfig segment(const std::array<std::pair<const char*, const char*>, kSlaves>& devices) {
  SimConfig config;
  for (const auto& [file, behaviour] : devices) {
    SimSlaveConfig slave;
    slave.device = sample::own(file);
    slave.behaviour = behaviour;
    if (!config.slaves.empty()) slave.parent = static_cast<std::uint16_t>(config.slaves.size() - 1);
    slave.oscillator.ppm = static_cast<double>(config.slaves.size()) * 20 - 20;
    config.slaves.push_back(std::move(slave));
  }
  return config;
}

/// Two segments of three: every behaviour, clocks of 64 and 32 bits and none, slow EEPROMs.
const std::array<SimConfig, 2>& segments() {
  static const auto made = [] {
    std::array<SimConfig, 2> configs{
        segment({{{"SL-1100", "generic"}, {"SL-SV7", "servo-y"}, {"SL-2002", "generic"}}}),
        segment({{{"SL-3002", "analog-input"}, {"SL-XE2", "drive-c"}, {"SL-6751", "can-gateway"}}})};
    configs[0].slaves[2].dc = {false, true, true};
    configs[0].slaves[1].sii = {kMillisecond, 3 * kMillisecond, false};
    configs[1].slaves[1].dc = {true, true, false};
    return configs;
  }();
  return made;
}

/// One datagram of the script: command, whom, where, how long, and its data.
void add_datagram(FrameBuilder& builder, Script& script, std::uint8_t index) {
  const auto command = static_cast<Command>(script.byte() % 15);
  const auto adp = kAddresses[script.byte() % kAddresses.size()];
  const auto ado = script.word();
  const std::size_t length = script.byte();
  if (auto data = builder.add_zeros(command, index, device_address(adp, ado), static_cast<std::uint16_t>(length))) {
    const auto taken = script.take(length);
    std::ranges::copy(taken, data->begin());
  }
}

/// Writes scripts: a frame of one datagram after a pause.
class Scribe {
 public:
  explicit Scribe(std::uint8_t which) { out_.push_back(which); }
  Scribe& write(std::uint16_t ado, Bytes data, std::uint8_t whom = 1, std::uint8_t pause = 5) {
    return datagram(Command::kApwr, ado, std::move(data), whom, pause);
  }
  Scribe& read(std::uint16_t ado, std::uint8_t length, std::uint8_t whom = 1, std::uint8_t pause = 5) {
    return datagram(Command::kAprd, ado, Bytes(length), whom, pause);
  }
  Scribe& datagram(Command command, std::uint16_t ado, Bytes data, std::uint8_t whom, std::uint8_t pause) {
    const auto low = static_cast<std::uint8_t>(ado), high = static_cast<std::uint8_t>(ado >> 8);
    out_.insert(out_.end(), {pause, 0, static_cast<std::uint8_t>(command), whom, low, high});
    out_.push_back(static_cast<std::uint8_t>(data.size()));
    out_.insert(out_.end(), data.begin(), data.end());
    return *this;
  }
  [[nodiscard]] Bytes bytes() const { return out_; }

 private:
  Bytes out_;
};

}  // namespace

void run_bus(std::span<const std::uint8_t> bytes) {
  Script script(bytes);
  const auto& config = segments()[script.byte() % segments().size()];
  auto now = VirtualClock::kDefaultStart;
  auto made = sim::SimBus::create(config, now);
  promise(made.has_value());
  auto& bus = **made;
  for (int frames = 0; frames < kMostFrames && !script.over(); ++frames) {
    now += kPauses[script.byte() % kPauses.size()];
    bus.advance_to(now);
    FrameBuilder builder;
    const auto more = script.byte() % 4;
    for (std::uint8_t index = 0; index <= more; ++index) add_datagram(builder, script, index);
    const auto sent = builder.finish();
    Bytes frame(sent.begin(), sent.end());
    const auto returned = bus.execute(frame, now);
    promise(frame.size() == sent.size());
    promise(returned.lost || (returned.arrival_time > now && returned.arrival_time < now + kMillisecond));
    FrameReader reader(frame);
    while (const auto datagram = reader.next()) promise(datagram->wkc() <= 3 * kSlaves);
    now = std::max(now, returned.arrival_time);
  }
  for (std::size_t i = 0; i < bus.slave_count(); ++i) (void)bus.system_time(i);
}

std::vector<Bytes> bus_scripts() {
  const Bytes far(8, 0x70);
  Scribe clock(0), mailbox(1), eeprom(0), process_data(1);
  clock.datagram(Command::kBwr, reg::kReceiveTimePort0, Bytes(4), 0, 1)
      .read(reg::kReceiveTimePort0, 64)
      .write(reg::kSystemTimeOffset, far)
      .datagram(Command::kArmw, reg::kSystemTime, Bytes(4), 0, 5)
      .write(0x09A0, {0x40, 0x42, 0x0F, 0})
      .write(0x0990, far)
      .write(0x0980, {0, 3})
      .read(0x0980, 32);
  mailbox.write(0x0800, {0, 0x10, 0x80, 0, 0x26, 0, 1, 0, 0x80, 0x10, 0x80, 0, 0x22, 0, 1, 0})
      .write(reg::kAlControl, {2, 0})
      .write(0x1000, {10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0, 0x10, 0, 0, 0, 0, 0}, 1, 7)
      .read(0x080D, 1)
      .read(0x1080, 128);
  eeprom.write(0x0500, {0, 0})
      .write(0x0502, {0, 1, 8, 0, 0, 0})
      .read(0x0502, 14)
      .write(0x0508, {1, 2})
      .write(0x0502, {1, 2, 4, 0, 0, 0}, 1, 6);
  process_data.write(0x0600, {0, 0, 0, 0, 4, 0, 0, 7, 0, 0x11, 0, 2, 1, 0, 0, 0})
      .write(0x0810, {0, 0x11, 4, 0, 0x64, 0, 1, 0})
      .write(reg::kAlControl, {4, 0}, 1, 6)
      .write(reg::kAlControl, {8, 0}, 1, 6)
      .datagram(Command::kLrw, 0, Bytes(8, 1), 0, 5);
  return {clock.bytes(), mailbox.bytes(), eeprom.bytes(), process_data.bytes()};
}

}  // namespace syncline::fuzz
