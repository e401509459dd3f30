// SPDX-License-Identifier: Apache-2.0
#include "sim/sim_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/device.h"
#include "sim/esc.h"
#include "sim/segment.h"
#include "sim/sii_from_device.h"

namespace syncline::sim {
namespace {

/// A slave: its ESC and the firmware behind it. Made anew at every power-on.
struct Node {
  std::unique_ptr<Esc> esc;
  std::unique_ptr<Device> device;
};

Node power_up(const SimSlaveConfig& config, Nanoseconds time, std::uint64_t seed) {
  Esc::Options options;
  options.alias = config.alias;
  options.device_emulation = config.device.device_emulation();
  Node node;
  auto sii = config.sii_image.empty() ? sii::encode(sii_from_device(config.device, config.alias, config.serial_no))
                                      : config.sii_image;
  node.esc = std::make_unique<Esc>(config, std::move(sii), options, time, seed);
  node.device = make_device(config, *node.esc);
  return node;
}

/// Something that a fault does at a time.
struct Action {
  Nanoseconds time = 0;
  std::function<void()> apply;
};

}  // namespace

struct SimBus::Impl {
  SimConfig config;
  std::vector<Node> nodes;
  std::vector<SlaveLink> links;
  SegmentPath path;
  std::vector<double> true_delay;
  std::vector<Action> actions;       // by time
  std::size_t next_action = 0;
  Nanoseconds now = 0;
  std::uint32_t frames_to_lose = 0;
  std::vector<DatagramView> datagrams;

  Impl(SimConfig c, Nanoseconds start) : config(std::move(c)), links(config.slaves.size()), now(start) {
    for (std::size_t i = 0; i < config.slaves.size(); ++i) nodes.push_back(power_up(config.slaves[i], start, seed_of(i)));
    rewire();
    true_delay.resize(nodes.size());
    for (const auto& passage : path.passages) {
      if (passage.processed) true_delay[passage.slave] = passage.time_ns - path.passages.front().time_ns;
    }
    schedule_faults(start);
  }

  [[nodiscard]] std::uint64_t seed_of(std::size_t i) const { return config.seed * 0x9E37'79B9'7F4A'7C15U + i; }

  void rewire() {
    path = segment_path(config.slaves, links);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (unsigned port = 0; port < 4; ++port) nodes[i].esc->set_port(port, port_is_open(i, port));
    }
  }

  [[nodiscard]] bool port_is_open(std::size_t i, unsigned port) const {
    if (port == 0) return links[i].cable;
    for (std::size_t child = i + 1; child < nodes.size(); ++child) {
      const auto& c = config.slaves[child];
      if (c.parent == i && c.parent_port == port) return links[child].cable && links[child].power;
    }
    return false;
  }

  void schedule_faults(Nanoseconds start);
  void add_fault(const FaultConfig& fault, Nanoseconds start);
  void run_actions(Nanoseconds time) {
    while (next_action < actions.size() && actions[next_action].time <= time) actions[next_action++].apply();
  }
  void advance_to(Nanoseconds time) {
    run_actions(time);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (links[i].power) nodes[i].device->advance_to(time);
    }
    now = std::max(now, time);
  }
  Returned execute(std::span<std::uint8_t> frame, Nanoseconds send_time);
};

void SimBus::Impl::add_fault(const FaultConfig& fault, Nanoseconds start) {
  const auto i = static_cast<std::size_t>(std::max(fault.slave, 0));
  const auto at = [&](Nanoseconds offset, std::function<void()> what) { actions.push_back({start + offset, std::move(what)}); };
  switch (fault.kind) {
    case FaultKind::kLoseFrames:
      at(fault.at, [this, count = fault.count] { frames_to_lose += count; });
      break;
    case FaultKind::kCableBreak:
      at(fault.at, [this, i] { links[i].cable = false; rewire(); });
      if (fault.until > fault.at) at(fault.until, [this, i] { links[i].cable = true; rewire(); });
      break;
    case FaultKind::kSlaveOff:
      at(fault.at, [this, i] { links[i].power = false; rewire(); });
      if (fault.until > fault.at) {
        at(fault.until, [this, i, time = start + fault.until] {
          nodes[i] = power_up(config.slaves[i], time, seed_of(i));
          links[i].power = true;
          rewire();
        });
      }
      break;
    case FaultKind::kClockStep:
      at(fault.at, [this, i, delta = fault.value_ns] { nodes[i].esc->dc().step_clock(delta); });
      break;
    case FaultKind::kRefuseState:
      at(fault.at, [this, i, fault] { nodes[i].device->refuse(fault.state, fault.code); });
      if (fault.until > fault.at) at(fault.until, [this, i] { nodes[i].device->refuse(AlState::kNone, 0); });
      break;
    case FaultKind::kMailboxSilence:
      at(fault.at, [this, i] { nodes[i].device->silence_mailbox(true); });
      if (fault.until > fault.at) at(fault.until, [this, i] { nodes[i].device->silence_mailbox(false); });
      break;
  }
}

void SimBus::Impl::schedule_faults(Nanoseconds start) {
  for (const auto& fault : config.faults) add_fault(fault, start);
  std::stable_sort(actions.begin(), actions.end(), [](const Action& a, const Action& b) { return a.time < b.time; });
}

SimBus::Returned SimBus::Impl::execute(std::span<std::uint8_t> frame, Nanoseconds send_time) {
  run_actions(send_time);
  now = std::max(now, send_time);
  if (frames_to_lose > 0) {
    --frames_to_lose;
    return {true, 0};
  }
  FrameReader reader(frame);
  datagrams.clear();
  while (auto datagram = reader.next()) datagrams.push_back(*datagram);
  // ESCs destroy what is no EtherCAT frame (0x0100.0 = 1), and nobody answers on a dead segment.
  if (!reader.is_ethercat() || reader.malformed() || path.passages.empty()) return {true, 0};

  const auto time_of = [send_time](double offset) { return send_time + static_cast<Nanoseconds>(offset + 0.5); };
  for (const auto& passage : path.passages) {
    auto& node = nodes[passage.slave];
    const auto time = time_of(passage.time_ns);
    node.esc->frame_at_port(passage.port, time);
    if (!passage.processed) continue;
    node.device->advance_to(time);
    node.esc->process(datagrams, time);
  }
  const auto length = wire_time_ns(frame.size()) - 12 * 80;  // without the gap behind the frame
  for (const auto& passage : path.passages) {
    if (passage.processed) nodes[passage.slave].esc->frame_end(time_of(passage.time_ns) + length);
  }
  frame[6] = static_cast<std::uint8_t>(frame[6] | 0x02);  // locally administered: has passed a slave
  return {false, time_of(path.return_ns) + length};
}

SimBus::SimBus(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimBus::~SimBus() = default;

Result<std::unique_ptr<SimBus>> SimBus::create(const SimConfig& config, Nanoseconds start) {
  if (config.slaves.empty()) return fail(ErrorCode::kConfiguration, config.name, "the segment has no slaves");
  const std::vector<SlaveLink> all_up(config.slaves.size());
  const auto path = segment_path(config.slaves, all_up);
  std::size_t expected = 0;
  for (const auto& passage : path.passages) {
    if (!passage.processed) continue;
    if (passage.slave != expected) {
      return fail(ErrorCode::kConfiguration, fmt::format("slave {}", expected),
                  fmt::format("the wiring puts slave {} at this place of the frame's way; list the slaves in frame "
                              "order (ports D, B, C)", passage.slave));
    }
    ++expected;
  }
  if (expected != config.slaves.size()) {
    return fail(ErrorCode::kConfiguration, fmt::format("slave {}", expected), "no frame reaches it; check parent and port");
  }
  return std::unique_ptr<SimBus>(new SimBus(std::make_unique<Impl>(config, start)));
}

SimBus::Returned SimBus::execute(std::span<std::uint8_t> frame, Nanoseconds send_time) {
  return impl_->execute(frame, send_time);
}
void SimBus::advance_to(Nanoseconds time) { impl_->advance_to(time); }
std::size_t SimBus::slave_count() const { return impl_->nodes.size(); }
std::uint64_t SimBus::system_time(std::size_t position) const {
  return impl_->nodes.at(position).esc->dc().system_time(impl_->now);
}
double SimBus::true_delay_ns(std::size_t position) const { return impl_->true_delay.at(position); }
std::vector<std::uint8_t> SimBus::peek(std::size_t position, std::uint16_t address, std::size_t length) const {
  const auto bytes = std::as_const(*impl_->nodes.at(position).esc).memory().at(address, length);
  return {bytes.begin(), bytes.end()};
}

}  // namespace syncline::sim
