// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "sim/esc/three_buffers.h"
#include "tests/core/sim/sim_probe.h"

/// What slaves in OP count when somebody looks, against slaves that do it each time.
namespace syncline::test {
namespace {

using sim::SimBus;

constexpr std::uint32_t kImage = 0x0100'0000;
constexpr std::uint16_t kOutputArea = 0x1000, kInputArea = 0x1100, kSize = 4;

bool perhaps(int in) { return *rc::gen::inRange(0, in) == 0; }

RC_GTEST_PROP(SimThreeBuffers, WritingManyTimesAtOnceIsWritingOneByOne, ()) {
  sim::EscMemory each_memory(1), once_memory(1);
  sim::ThreeBuffers each(each_memory, 2), once(once_memory, 2);
  const auto moves = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-3, 12));
  for (const int times : moves) {
    const unsigned number = times % 2 == 0 ? 1 : 0;
    if (times < 0) {
      each.read(number);
      once.read(number);
      continue;
    }
    for (int i = 0; i < times; ++i) each.write(number);
    once.write(number, static_cast<std::uint64_t>(times));
    if (perhaps(2)) continue;  // nobody looks
    each.show();
    once.show();
    for (unsigned i = 0; i < 2; ++i) {
      const auto status = static_cast<std::uint16_t>(reg::sync_manager(i) + 5);
      RC_ASSERT(each_memory.u8(status) == once_memory.u8(status));
    }
  }
}

TEST(SimThreeBuffers, NeverWritesIntoTheOneThatIsRead) {
  sim::EscMemory memory(1);
  sim::ThreeBuffers buffers(memory, 1);
  const auto shown = [&] {
    buffers.show();
    return memory.u8(reg::kSyncManager + 5) >> 4 & 3;
  };
  buffers.write(0);
  buffers.read(0);
  const auto reading = shown();
  for (int i = 0; i < 5; ++i) {
    const auto before = shown();
    buffers.write(0);
    EXPECT_NE(shown(), reading);
    EXPECT_NE(shown(), before);
  }
}

DeviceDescription terminal(bool outputs, bool inputs) {
  DeviceDescription device;
  device.identity = {0x5C17, 0x0108, 1, 0};
  device.type = device.name = "terminal";
  device.physics = "KK";
  device.fmmus = {FmmuUse::kOutputs, FmmuUse::kInputs};
  device.sync_managers = {{SyncManagerType::kOutputs, kOutputArea, {}, {}, kSize, 0x64, true, false, false},
                          {SyncManagerType::kInputs, kInputArea, {}, {}, kSize, 0x20, true, false, false}};
  if (outputs) device.rx_pdos = {{0x1600, "Outputs", 0, true, true, {}, {{0x7000, 1, 32, "Out", "UDINT"}}}};
  if (inputs) device.tx_pdos = {{0x1A00, "Inputs", 1, true, true, {}, {{0x6000, 1, 32, "In", "UDINT"}}}};
  device.dc.emplace();
  for (const std::uint16_t activate : {0x0300, 0x0700}) {
    device.dc->op_modes.push_back({});
    device.dc->op_modes.back().assign_activate = activate;
  }
  return device;
}

/// Terminals of every kind that rest, and what may wake them up.
struct Machine {
  SimConfig config;
  std::vector<bool> outputs, inputs;
  std::vector<std::uint8_t> activation;  // of the SYNC signals; 0: none
};

Machine random_machine() {
  Machine machine;
  std::vector<SimSlaveConfig> slaves;
  const auto count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    machine.outputs.push_back(!perhaps(4));
    machine.inputs.push_back(!machine.outputs.back() || !perhaps(4));
    machine.activation.push_back(*rc::gen::element<std::uint8_t>(0, 3, 3, 3, 7));
    SimSlaveConfig slave;
    slave.name = "terminal";
    slave.device = terminal(machine.outputs.back(), machine.inputs.back());
    if (perhaps(2))
      slave.device.eeprom.config_data = {0x08, 0, 0, 0, 10, 0};  // pulses; otherwise they are acknowledged
    slave.oscillator.ppm = *rc::gen::inRange(-100, 100);
    slave.oscillator.wander_ppm = perhaps(3) ? 0.1 : 0;
    slaves.push_back(slave);
  }
  machine.config = line(std::move(slaves));
  for (const auto kind : {FaultKind::kSlowApplication, FaultKind::kStopApplication, FaultKind::kSilentSync}) {
    if (!perhaps(3)) continue;
    FaultConfig fault;
    fault.kind = kind;
    fault.slave = *rc::gen::inRange(0, count);
    fault.at = *rc::gen::inRange<Nanoseconds>(40, 90) * kMillisecond;
    fault.until = fault.at + *rc::gen::inRange<Nanoseconds>(1, 40) * kMillisecond;
    fault.value_ns = *rc::gen::inRange<Nanoseconds>(100, 3000) * kMicrosecond;
    machine.config.faults.push_back(fault);
  }
  return machine;
}

/// A master's work with the same machine in two ways; whatever comes back is compared.
class Pair {
 public:
  explicit Pair(const Machine& machine)
      : machine_(machine),
        at_once_(machine.config, SimBus::Work::kAtOnce),
        each_(machine.config, SimBus::Work::kEach) {}

  void start() {
    for (std::uint16_t i = 0; i < machine_.config.slaves.size(); ++i) set_up(i);
    for (const std::uint8_t state : {2, 4}) request(state);
    exchange(kMillisecond);
    for (int i = 0; i < 30; ++i) exchange(kMillisecond);
    request(8);
    for (int i = 0; i < 5; ++i) exchange(kMillisecond);
  }
  /// Process data there and back.
  void exchange(Nanoseconds later) {
    send(Command::kLrw, kImage, std::vector<std::uint8_t>(2 * kSize * machine_.config.slaves.size(), next_++), later);
  }
  void read_status(std::uint16_t slave, Nanoseconds later) {
    send(Command::kFprd, device_address(static_cast<std::uint16_t>(1001 + slave), reg::sync_manager(1) + 5), {0},
         later);
  }
  void send(Command command, std::uint32_t address, const std::vector<std::uint8_t>& data, Nanoseconds later = 0) {
    at_once_.now += later;
    each_.now += later;
    const auto a = at_once_.send(command, address, data), b = each_.send(command, address, data);
    RC_ASSERT(a.lost == b.lost);
    RC_ASSERT(a.wkc == b.wkc);
    RC_ASSERT(a.irq == b.irq);
    RC_ASSERT(a.data == b.data);
  }
  void pass(Nanoseconds time) {
    at_once_.pass(time);
    each_.pass(time);
  }
  [[nodiscard]] bool in_op() {
    return (at_once_.send(Command::kBrd, device_address(0, reg::kAlStatus), {0, 0}).data[0] & 0x0F) == 8 &&
           (each_.send(Command::kBrd, device_address(0, reg::kAlStatus), {0, 0}).data[0] & 0x0F) == 8;
  }
  /// Where their memories differ first; -1: nowhere.
  [[nodiscard]] int difference() {
    for (std::size_t i = 0; i < machine_.config.slaves.size(); ++i) {
      const auto a = at_once_.bus->peek(i, 0, 0x1200), b = each_.bus->peek(i, 0, 0x1200);
      const auto found = std::ranges::mismatch(a, b).in1;
      if (found != a.end()) return static_cast<int>(found - a.begin());
    }
    return -1;
  }

 private:
  void request(std::uint8_t state) {
    send(Command::kBwr, device_address(0, reg::kAlControl), {state, 0});
    pass(2 * kMillisecond);
  }
  void write(std::uint16_t slave, std::uint16_t ado, const std::vector<std::uint8_t>& data) {
    send(Command::kApwr, device_address(Position{slave}.auto_increment_address(), ado), data);
  }
  void set_up(std::uint16_t slave) {
    const auto station = le_bytes(static_cast<std::uint16_t>(1001 + slave));
    write(slave, reg::kStationAddress, {station.begin(), station.end()});
    const auto image = kImage + 2U * kSize * slave;
    unsigned fmmu = 0;
    const auto map = [&](unsigned manager, std::uint16_t area, std::uint8_t control, std::uint8_t direction) {
      std::vector<std::uint8_t> setting, mapping;
      ByteWriter(setting).u16(area).u16(kSize).u8(control).u8(0).u8(1).u8(0);
      write(slave, reg::sync_manager(manager), setting);
      ByteWriter(mapping)
          .u32(image + kSize * manager)
          .u16(kSize)
          .u8(0)
          .u8(7)
          .u16(area)
          .u8(0)
          .u8(direction)
          .u8(1)
          .u8(0)
          .u16(0);
      write(slave, reg::fmmu(fmmu++), mapping);
    };
    if (machine_.outputs[slave]) map(0, kOutputArea, 0x64, 2);
    if (machine_.inputs[slave]) map(1, kInputArea, 0x20, 1);
    if (machine_.activation[slave] == 0) return;
    std::vector<std::uint8_t> cycles, first, offset;
    ByteWriter(cycles).u32(static_cast<std::uint32_t>(kMillisecond)).u32(100'000);
    write(slave, reg::kSync0CycleTime, cycles);
    ByteWriter(offset).u64(static_cast<std::uint64_t>(VirtualClock::kDefaultStart));
    write(slave, reg::kSystemTimeOffset, offset);
    ByteWriter(first).u64(static_cast<std::uint64_t>(VirtualClock::kDefaultStart + 20 * kMillisecond));
    write(slave, reg::kStartTimeCyclicOperation, first);
    write(slave, reg::kActivation, {machine_.activation[slave]});
  }

  const Machine& machine_;
  SimProbe at_once_, each_;
  std::uint8_t next_ = 1;
};

void any_move(Pair& pair, int slaves, bool faults) {
  // From two frames in a cycle to none in several.
  const auto later = *rc::gen::inRange<Nanoseconds>(0, perhaps(4) ? 5000 : 1200) * kMicrosecond;
  const auto slave = static_cast<std::uint16_t>(*rc::gen::inRange(0, slaves));
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return pair.pass(later);
    case 1:
      // Which signals a fault finds delivered depends on whether a frame leaves something in the slave.
      if (faults) return pair.exchange(later);
      return pair.send(Command::kBrd, device_address(0, reg::kSyncManager + 13), {0}, later);
    case 2:
      return pair.send(Command::kFprd, device_address(static_cast<std::uint16_t>(1001 + slave), kInputArea),
                       std::vector<std::uint8_t>(static_cast<std::size_t>(*rc::gen::inRange(1, 5))), later);
    case 3:
      return pair.send(Command::kBwr, device_address(0, reg::kRxErrorCounter), {0}, later);  // wakes up
    case 4:
      return pair.read_status(slave, later);
    default:
      return pair.exchange(later);
  }
}

RC_GTEST_PROP(SimAtOnce, CountingWhenSomebodyLooksIsDoingItEachTime, ()) {
  const auto machine = random_machine();
  Pair pair(machine);
  pair.start();
  if (machine.config.faults.empty()) RC_ASSERT(pair.in_op());
  const auto moves = *rc::gen::inRange(10, 60);
  for (int i = 0; i < moves; ++i)
    any_move(pair, static_cast<int>(machine.config.slaves.size()), !machine.config.faults.empty());
  pair.pass(0);  // a frame that left nothing in a slave has not been told its end
  RC_ASSERT(pair.difference() == -1);
}

}  // namespace
}  // namespace syncline::test
