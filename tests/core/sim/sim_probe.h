// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/sim_config.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/scenario/scenario_loader.h"
#include "sim/sim_bus.h"
#include "support/byte_order.h"
#include "support/clock.h"
#include "tests/support/own_devices.h"
#include "tests/support/source_dir.h"

namespace syncline::test {

inline std::string resource(const std::string& name) { return test::source_dir() + "/resources/" + name; }

/// What a scenario of ours names: the device that the file is called by.
inline Result<sim::ScenarioDevice> scenario_device(const sim::DeviceQuery& query) {
  if (!std::filesystem::exists(query.path))
    return tl::unexpected(Error{.code = ErrorCode::kFileNotFound, .file = query.path});
  const auto type = std::filesystem::path(query.path).stem().string();
  auto device = sample::own(type);
  if (device.type.empty() || (!query.type.empty() && query.type != type))
    return fail(ErrorCode::kUnknownDevice, query.type);
  return sim::ScenarioDevice{std::move(device), {}};
}

inline SimSlaveConfig sim_slave(const std::string& type, const std::string& behaviour = "generic") {
  SimSlaveConfig slave;
  slave.name = type;
  slave.behaviour = behaviour;
  slave.device = sample::own(type);
  return slave;
}

/// Slaves in a line.
inline SimConfig line(std::vector<SimSlaveConfig> slaves) {
  SimConfig config;
  config.name = "line";
  for (std::size_t i = 1; i < slaves.size(); ++i) slaves[i].parent = static_cast<std::uint16_t>(i - 1);
  config.slaves = std::move(slaves);
  return config;
}

/// Registers that masters ask single slaves for while process data go on, and some that they do not.
struct AskedRegisters {
  std::uint16_t address;
  std::uint16_t length;
};
inline constexpr AskedRegisters kAskedRegisters[] = {{reg::kAlStatus, 6},
                                                     {reg::kRxErrorCounter, 20},
                                                     {reg::kEcatEventRequest, 2},
                                                     {reg::kAlEventRequest, 4},
                                                     {0x0440, 4},
                                                     {reg::kSyncManager, 32},
                                                     {0x0805, 1},
                                                     {0x080D, 1},
                                                     {0x081D, 1},
                                                     {reg::kSystemTime, 8},
                                                     {reg::kSystemTimeOffset, 8},
                                                     {reg::kSystemTimeDifference, 4},
                                                     {0x0932, 2},
                                                     {reg::kActivation, 16},
                                                     {0x098E, 2},
                                                     {reg::kStartTimeCyclicOperation, 8},
                                                     {reg::kLatch0Status, 2},
                                                     {reg::kLatch0PositiveEdge, 8},
                                                     {0x0FF0, 0x20},
                                                     {0x1000, 4},
                                                     {0x1100, 4},
                                                     {0x1C00, 2}};

/// Sends single datagrams into a bus, as a master would, and lets time pass.
class SimProbe {
 public:
  struct Reply {
    bool lost = false;
    std::uint16_t wkc = 0;
    std::uint16_t adp = 0;
    std::uint16_t irq = 0;
    std::vector<std::uint8_t> data;
    std::uint8_t source_mac0 = 0;
    template <std::unsigned_integral T>
    [[nodiscard]] T value() const {
      return load_le<T>(data);
    }
  };

  explicit SimProbe(const SimConfig& config, sim::SimBus::Work work = sim::SimBus::Work::kAtOnce)
      : bus(std::move(sim::SimBus::create(config, now, work).value())) {}

  Reply send(Command command, std::uint32_t address, std::vector<std::uint8_t> data) {
    FrameBuilder builder;
    const std::array<std::uint8_t, 6> mac{0, 1, 2, 3, 4, 5};
    builder.set_addresses(mac, mac);
    builder.add(command, 1, address, data);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    const auto returned = bus->execute(frame, now);
    now += 20 * kMicrosecond;
    Reply reply;
    reply.lost = returned.lost;
    if (returned.lost) return reply;
    arrival = returned.arrival_time;
    FrameReader reader(frame);
    const auto datagram = reader.next();
    reply.wkc = datagram->wkc();
    reply.adp = datagram->header.adp();
    reply.irq = datagram->header.irq;
    reply.data.assign(datagram->data.begin(), datagram->data.end());
    reply.source_mac0 = frame[6];
    return reply;
  }
  Reply read(std::uint16_t position, std::uint16_t ado, std::size_t length) {
    return send(Command::kAprd, device_address(Position{position}.auto_increment_address(), ado),
                std::vector<std::uint8_t>(length));
  }
  Reply write(std::uint16_t position, std::uint16_t ado, std::vector<std::uint8_t> data) {
    return send(Command::kApwr, device_address(Position{position}.auto_increment_address(), ado), std::move(data));
  }
  void pass(Nanoseconds duration) {
    now += duration;
    bus->advance_to(now);
  }
  /// Requests a state and waits for the firmware; AL status.
  std::uint16_t request(std::uint16_t position, std::uint16_t control) {
    write(position, reg::kAlControl, le_bytes(control));
    pass(kMillisecond);
    return read(position, reg::kAlStatus, 2).value<std::uint16_t>();
  }
  std::uint16_t al_code(std::uint16_t position) { return read(position, reg::kAlStatusCode, 2).value<std::uint16_t>(); }
  void set_sync_manager(std::uint16_t position, unsigned number, std::uint16_t start, std::uint16_t length,
                        std::uint8_t control) {
    // Enabled it keeps what it has.
    if (!enabled_.emplace(position, number).second)
      write(position, static_cast<std::uint16_t>(reg::sync_manager(number) + 6), {0});
    std::vector<std::uint8_t> bytes;
    ByteWriter(bytes).u16(start).u16(length).u8(control).u8(0).u8(1).u8(0);
    write(position, reg::sync_manager(number), bytes);
  }

  Nanoseconds now = VirtualClock::kDefaultStart;
  Nanoseconds arrival = 0;
  std::unique_ptr<sim::SimBus> bus;

 private:
  std::set<std::pair<std::uint16_t, unsigned>> enabled_;  // by position and number
};

}  // namespace syncline::test
