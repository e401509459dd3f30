// SPDX-License-Identifier: Apache-2.0
#include "sim/sim_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "protocol/registers.h"
#include "sim/device.h"
#include "sim/esc.h"
#include "sim/passing_frame.h"
#include "sim/segment.h"
#include "sim/sii_from_device.h"

namespace syncline::sim {
namespace {

/// A slave: its ESC and the firmware behind it. Made anew at every power-on.
struct Node {
  std::unique_ptr<Esc> esc;
  std::unique_ptr<Device> device;
};

/// What the slave's EEPROM holds when it leaves the factory.
std::vector<std::uint8_t> factory_sii(const SimSlaveConfig& config) {
  if (config.sii_image.empty()) return sii::encode(sii_from_device(config.device, config.alias, config.serial_no));
  auto image = config.sii_image;
  constexpr std::size_t kAlias = 8, kChecksum = 14;
  if (image.size() > kChecksum && config.alias != load_le<std::uint16_t>(std::span(image).subspan(kAlias))) {
    const bool checked = sii::checksum(std::span(image).first(kChecksum)) == image[kChecksum];
    store_le<std::uint16_t>(std::span(image).subspan(kAlias, 2), config.alias);
    if (checked) image[kChecksum] = sii::checksum(std::span(image).first(kChecksum));
  }
  return image;
}

Node power_up(const SimSlaveConfig& config, std::vector<std::uint8_t> sii, Nanoseconds time, std::uint64_t seed) {
  Esc::Options options;
  options.device_emulation = config.device.device_emulation();
  options.fmmu_count = config.fmmu_count;
  options.sync_manager_count = config.sync_manager_count;
  options.ram_kbytes = config.ram_kbytes;
  options.logical_read_write = config.logical_read_write;
  options.physical_read_write = config.physical_read_write;
  Node node;
  node.esc = std::make_unique<Esc>(config, std::move(sii), options, time, seed);
  node.device = make_device(config, *node.esc);
  return node;
}

/// State of the cable to a slave's parent and of its power.
struct SlaveLink {
  bool cable = true;
  bool power = true;
};

/// Frames that do not arrive, or arrive damaged, at a port of a slave.
struct LineFault {
  std::uint16_t slave = 0;
  std::uint8_t port = 0;
  bool damaged = false;
  std::uint32_t frames = 0;
};
constexpr std::uint32_t kAllFrames = 0xFFFF'FFFF;

/// Something that a fault does at a time.
struct Action {
  Nanoseconds time = 0;
  std::function<void()> apply;
};

}  // namespace

struct SimBus::Impl {
  SimConfig config;
  Wiring wiring;
  std::vector<Node> nodes;
  std::vector<SlaveLink> links;
  SegmentPath path;
  std::vector<std::size_t> processed;   // receptions of `path` in front of processing units
  std::vector<double> true_delay;
  std::vector<Action> actions;       // by time
  std::size_t next_action = 0;
  Nanoseconds now = 0;
  std::uint32_t frames_to_lose = 0;
  std::vector<LineFault> line_faults;
  PassingFrame passing;
  std::vector<std::size_t> touched;     // those at which the passing frame left something; the others it was not for

  Impl(SimConfig c, Nanoseconds start)
      : config(std::move(c)), wiring(config.slaves), links(config.slaves.size()), now(start) {
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      nodes.push_back(power_up(config.slaves[i], factory_sii(config.slaves[i]), start, seed_of(i)));
    }
    rewire();
    true_delay.resize(nodes.size());
    for (const auto& passage : path.passages) {
      if (passage.processed) true_delay[passage.slave] = passage.time_ns - path.passages.front().time_ns;
    }
    schedule_actions(start);
  }

  [[nodiscard]] std::uint64_t seed_of(std::size_t i) const { return config.seed * 0x9E37'79B9'7F4A'7C15U + i; }
  void restart(std::size_t i, Nanoseconds time) {
    nodes[i] = power_up(config.slaves[i], nodes[i].esc->sii_content(), time, seed_of(i));
  }

  [[nodiscard]] bool linked(std::size_t i, unsigned port) const {
    const auto up = [this](std::size_t below) {
      const auto& parent = config.slaves[below].parent;
      return links[below].cable && links[below].power && (below == 0 || !parent || links[*parent].power);
    };
    if (port == 0) return up(i);
    const auto child = wiring.child(i, port);
    return child && up(*child);
  }

  /// Tells the ports which cables are alive and finds the frames' way anew.
  void rewire() {
    std::vector<PortState> ports(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      auto& esc_ports = nodes[i].esc->ports();
      for (unsigned port = 0; port < EscPorts::kCount; ++port) {
        esc_ports.set_link(port, linked(i, port));
        ports[i].link[port] = esc_ports.link(port);
        ports[i].open[port] = esc_ports.open(port);
      }
      (void)esc_ports.take_changed();
    }
    path = segment_path(config.slaves, wiring, ports);
    processed.clear();
    for (std::size_t p = 0; p < path.passages.size(); ++p) {
      if (path.passages[p].processed) processed.push_back(p);
    }
  }

  void schedule_actions(Nanoseconds start);
  void add_fault(const FaultConfig& fault, Nanoseconds start);
  void add_pulses(const LatchPulses& pulses, Nanoseconds start);
  void run_actions(Nanoseconds time) {
    while (next_action < actions.size() && actions[next_action].time <= time) actions[next_action++].apply();
  }
  void advance_to(Nanoseconds time) {
    run_actions(time);
    bool changed = false;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!links[i].power) continue;
      nodes[i].device->advance_to(time);
      changed = nodes[i].esc->ports().take_changed() || changed;
    }
    if (changed) rewire();
    now = std::max(now, time);
  }
  Returned execute(std::span<std::uint8_t> frame, Nanoseconds send_time);
  Returned execute_foreign(bool malformed, Nanoseconds send_time);
  /// How far this frame gets: receptions before the one at which it is lost, and the first one that is damaged.
  struct Reach {
    std::size_t end, damaged;
  };
  [[nodiscard]] Reach reach();
  void note_port_times(const Reach& way, Nanoseconds send_time);
  void count_errors(const Reach& way);
  void end_frame(const Reach& reach, Nanoseconds send_time, Nanoseconds length);
};

void SimBus::Impl::add_fault(const FaultConfig& fault, Nanoseconds start) {
  const auto i = static_cast<std::size_t>(std::max(fault.slave, 0));
  const auto at = [&](Nanoseconds offset, std::function<void()> what) { actions.push_back({start + offset, std::move(what)}); };
  switch (fault.kind) {
    case FaultKind::kLoseFrames:
      if (fault.slave < 0) {
        at(fault.at, [this, count = fault.count] { frames_to_lose += count; });
        break;
      }
      [[fallthrough]];
    case FaultKind::kBitErrors: {
      const bool damaged = fault.kind == FaultKind::kBitErrors;
      const auto slave = static_cast<std::uint16_t>(i);
      const bool burst = fault.until > fault.at;
      at(fault.at, [this, damaged, slave, burst, fault] {
        line_faults.push_back({slave, fault.port, damaged, burst ? kAllFrames : fault.count});
      });
      if (burst) {
        at(fault.until, [this, damaged, slave, fault] {
          std::erase_if(line_faults, [&](const LineFault& line) {
            return line.slave == slave && line.port == fault.port && line.damaged == damaged && line.frames == kAllFrames;
          });
        });
      }
      break;
    }
    case FaultKind::kCableBreak:
      at(fault.at, [this, i] { links[i].cable = false; rewire(); });
      if (fault.until > fault.at) at(fault.until, [this, i] { links[i].cable = true; rewire(); });
      break;
    case FaultKind::kSlaveOff:
      at(fault.at, [this, i] { links[i].power = false; rewire(); });
      if (fault.until > fault.at) {
        at(fault.until, [this, i, time = start + fault.until] {
          restart(i, time);
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
    case FaultKind::kSlowMailbox:
      at(fault.at, [this, i, delay = fault.value_ns] { nodes[i].device->slow_mailbox(delay); });
      if (fault.until > fault.at) at(fault.until, [this, i] { nodes[i].device->slow_mailbox(0); });
      break;
    case FaultKind::kSlowApplication:
      at(fault.at, [this, i, delay = fault.value_ns] { nodes[i].device->slow_application(delay); });
      if (fault.until > fault.at) at(fault.until, [this, i] { nodes[i].device->slow_application(0); });
      break;
    case FaultKind::kStopApplication:
      at(fault.at, [this, i, time = start + fault.at] { nodes[i].device->stop_application(time); });
      if (fault.until > fault.at) {
        at(fault.until, [this, i, time = start + fault.until] { nodes[i].device->resume_application(time); });
      }
      break;
    case FaultKind::kMailboxSilence:
      at(fault.at, [this, i] { nodes[i].device->silence_mailbox(true); });
      if (fault.until > fault.at) at(fault.until, [this, i] { nodes[i].device->silence_mailbox(false); });
      break;
  }
}

void SimBus::Impl::add_pulses(const LatchPulses& pulses, Nanoseconds start) {
  const auto edge = [&](bool level, Nanoseconds time) {
    actions.push_back({time, [this, level, time, slave = pulses.slave, input = pulses.input] {
                         auto& device = *nodes[slave].device;
                         device.advance_to(time);
                         (void)nodes[slave].esc->latch_input(input, level, time);
                       }});
  };
  for (std::uint32_t i = 0; i < pulses.count; ++i) {
    const auto rise = start + pulses.at + i * pulses.period;
    edge(true, rise);
    edge(false, rise + pulses.width);
  }
}

void SimBus::Impl::schedule_actions(Nanoseconds start) {
  for (const auto& fault : config.faults) add_fault(fault, start);
  for (const auto& pulses : config.latch_pulses) add_pulses(pulses, start);
  std::stable_sort(actions.begin(), actions.end(), [](const Action& a, const Action& b) { return a.time < b.time; });
}

SimBus::Returned SimBus::Impl::execute(std::span<std::uint8_t> frame, Nanoseconds send_time) {
  run_actions(send_time);
  if (path.swallowed) advance_to(send_time);  // slaves that no frame reaches live on: a setting for a while ends
  now = std::max(now, send_time);
  if (frames_to_lose > 0) {
    --frames_to_lose;
    return {true, 0};
  }
  const auto kind = passing.arrive(frame);
  if (kind != PassingFrame::Kind::kEtherCat) return execute_foreign(kind == PassingFrame::Kind::kMalformed, send_time);

  auto way = reach();
  bool mark_source = false;
  touched.clear();
  for (const auto p : processed) {
    if (p >= way.end) break;
    const auto& passage = path.passages[p];
    auto& node = nodes[passage.slave];
    mark_source = mark_source || node.esc->ports().destroys_foreign_frames();
    if (passing.is_for_single_slaves() && node.esc->is_untouched_by(passing)) continue;
    touched.push_back(p);
    const auto time = send_time + passage.offset;
    node.device->advance_to(time);
    if (!node.esc->process(passing, time)) way.end = p;
  }
  if (passing.takes_port_times()) note_port_times(way, send_time);
  if (way.damaged < way.end) count_errors(way);
  passing.leave();
  const auto length = wire_time_ns(frame.size()) - 12 * 80;  // without the gap behind the frame
  const bool lost = path.swallowed || way.end < path.passages.size() || way.damaged < path.passages.size();
  const auto return_time = send_time + static_cast<Nanoseconds>(path.return_ns + 0.5) + length;
  end_frame(way, send_time, length);
  if (lost) return {true, 0};
  if (mark_source) frame[6] = static_cast<std::uint8_t>(frame[6] | 0x02);  // locally administered
  return {false, return_time};
}

/// What the ESCs at the frame's way keep of when it came to their ports.
void SimBus::Impl::note_port_times(const Reach& way, Nanoseconds send_time) {
  for (std::size_t p = 0; p < way.end; ++p) {
    const auto& passage = path.passages[p];
    nodes[passage.slave].esc->frame_at_port(passage.port, send_time + passage.offset);
  }
}

void SimBus::Impl::count_errors(const Reach& way) {
  for (auto p = way.damaged; p < way.end; ++p) {
    auto& ports = nodes[path.passages[p].slave].esc->ports();
    p == way.damaged ? ports.count_invalid_frame(path.passages[p].port) : ports.count_forwarded_error(path.passages[p].port);
  }
}

SimBus::Impl::Reach SimBus::Impl::reach() {
  Reach reach{path.passages.size(), path.passages.size()};
  if (line_faults.empty()) return reach;
  for (std::size_t p = 0; p < reach.end; ++p) {
    for (auto& fault : line_faults) {
      if (fault.slave != path.passages[p].slave || fault.port != path.passages[p].port || fault.frames == 0) continue;
      if (fault.frames != kAllFrames) --fault.frames;
      (fault.damaged ? reach.damaged : reach.end) = std::min(fault.damaged ? reach.damaged : reach.end, p);
    }
  }
  std::erase_if(line_faults, [](const LineFault& fault) { return fault.frames == 0; });
  return reach;
}

/// The last byte has passed everywhere: what was written becomes effective where the frame was still good.
void SimBus::Impl::end_frame(const Reach& reach, Nanoseconds send_time, Nanoseconds length) {
  bool changed = false;
  for (const auto p : touched) {
    if (p >= reach.end) break;  // destroyed there
    const auto& passage = path.passages[p];
    auto& esc = *nodes[passage.slave].esc;
    const auto time = send_time + passage.offset + length;
    nodes[passage.slave].device->frame_received(time - length, time);
    if (p < reach.damaged) {
      esc.frame_end(time);
    } else {
      esc.frame_damaged();
    }
    if (esc.reset_requested()) {
      restart(passage.slave, time);
      changed = true;
    }
    if (nodes[passage.slave].esc->ports().take_changed()) changed = true;
  }
  if (path.closed_entry && reach.end == path.passages.size() && reach.damaged == reach.end) {
    auto& ports = nodes[*path.closed_entry].esc->ports();
    ports.frame_at_closed_port(0);
    changed = ports.take_changed() || changed;
  }
  if (changed) rewire();
}

/// No EtherCAT frame, or one whose lengths contradict each other: the first ESC notices and destroys it.
SimBus::Returned SimBus::Impl::execute_foreign(bool malformed, Nanoseconds send_time) {
  bool bad = false;
  for (const auto& passage : path.passages) {
    auto& ports = nodes[passage.slave].esc->ports();
    if (bad) {
      ports.count_forwarded_error(passage.port);
    } else if (passage.processed && (malformed || ports.destroys_foreign_frames())) {
      ports.count_processing_unit_error();
      bad = true;
    }
  }
  if (bad || path.swallowed) return {true, 0};
  return {false, send_time + static_cast<Nanoseconds>(path.return_ns + 0.5)};
}

SimBus::SimBus(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimBus::~SimBus() = default;

Result<std::unique_ptr<SimBus>> SimBus::create(const SimConfig& config, Nanoseconds start) {
  if (config.slaves.empty()) return fail(ErrorCode::kConfiguration, config.name, "the segment has no slaves");
  const Wiring wiring(config.slaves);
  const auto path = segment_path(config.slaves, wiring, all_connected(config.slaves, wiring));
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
bool SimBus::latch_input(std::size_t position, unsigned number, bool level) {
  return impl_->nodes.at(position).esc->latch_input(number, level, impl_->now);
}
std::size_t SimBus::slave_count() const { return impl_->nodes.size(); }
std::uint64_t SimBus::system_time(std::size_t position) const {
  return impl_->nodes.at(position).esc->dc().system_time(impl_->now);
}
double SimBus::true_delay_ns(std::size_t position) const { return impl_->true_delay.at(position); }
std::vector<PinEdge> SimBus::pin_edges(std::size_t position, unsigned pin) const {
  const auto* trace = impl_->nodes.at(position).device->output_pin(pin);
  return trace != nullptr ? trace->edges() : std::vector<PinEdge>{};
}
std::vector<std::uint8_t> SimBus::peek(std::size_t position, std::uint16_t address, std::size_t length) const {
  const auto bytes = std::as_const(*impl_->nodes.at(position).esc).memory().at(address, length);
  return {bytes.begin(), bytes.end()};
}

}  // namespace syncline::sim
