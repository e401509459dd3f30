// SPDX-License-Identifier: Apache-2.0
#include "sim/sim_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "protocol/frame.h"
#include "protocol/registers.h"
#include "reasons/because.h"
#include "sim/dc/rate_changes.h"
#include "sim/device/device.h"
#include "sim/device/sii_from_device.h"
#include "sim/esc/esc.h"
#include "sim/esc/passing_frame.h"
#include "sim/faults/fault_schedule.h"
#include "sim/faults/line_faults.h"
#include "sim/segment/address_table.h"
#include "sim/segment/pin_trace.h"
#include "sim/segment/segment.h"

namespace syncline::sim {
namespace {

/// A slave: its ESC and the firmware behind it. Made anew at every power-on.
struct Node {
  std::unique_ptr<Esc> esc;
  std::unique_ptr<Device> device;
};

Node power_up(const SimSlaveConfig& config, std::vector<std::uint8_t> sii, Nanoseconds time, std::uint64_t seed,
              SimBus::Work work) {
  Esc::Options options;
  options.device_emulation = config.device.device_emulation();
  options.fmmu_count = config.fmmu_count;
  options.sync_manager_count = config.sync_manager_count;
  options.ram_kbytes = config.ram_kbytes;
  options.logical_read_write = config.logical_read_write;
  options.physical_read_write = config.physical_read_write;
  options.counts_at_once = work == SimBus::Work::kAtOnce;
  Node node;
  node.esc = std::make_unique<Esc>(config, std::move(sii), options, time, seed);
  node.device = make_device(config, *node.esc);
  return node;
}

/// From its first bit to its last one, without the gap behind it.
Nanoseconds length_of_frame(std::size_t bytes) { return wire_time_ns(bytes) - 12 * 80; }

/// A processing unit on the way of the frames.
struct Stop {
  std::size_t passage = 0;  // the reception in front of it
  std::uint16_t slave = 0;
  Nanoseconds offset = 0;  // since the frame's start left the master
  Esc* esc = nullptr;
  Device* device = nullptr;
};

/// State of the cable to a slave's parent and of its power.
struct SlaveLink {
  bool cable = true;
  bool power = true;
};

}  // namespace

struct SimBus::Impl final : FaultTarget {
  SimConfig config;
  Work work;
  Wiring wiring;
  std::uint64_t setting_changes = 1, event_changes = 1;  // of all ESCs
  std::vector<Node> nodes;
  std::vector<SlaveLink> links;
  SegmentPath path;
  std::vector<Stop> stops;  // processing units of `path`
  std::vector<double> true_delay;
  LineFaults line_faults;
  std::optional<FaultSchedule> schedule;
  Nanoseconds now = 0;
  Nanoseconds wire_free = INT64_MIN;  // a frame of somebody else is on its way to the first slave until then
  PassingFrame passing;
  AddressTable addresses;
  bool source_marked = false;        // as far as the same settings say: an ESC on the way marks the source address
  std::vector<const Stop*> touched;  // those at which the passing frame left something; the others it was not for

  Impl(SimConfig c, Nanoseconds start, Work how)
      : config(std::move(c)),
        work(how),
        wiring(config.slaves),
        links(config.slaves.size()),
        line_faults(config.bus.loss, config.seed ^ 0x6C69'6E65U),
        now(start),
        passing(how == Work::kAtOnce ? PassingFrame::Execution::kPlanned : PassingFrame::Execution::kEach) {
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      auto& slave = config.slaves[i];
      slave.oscillator.changes = rate_changes(config, i, start);
      if (config.bus.latch_noise_ns > 0) slave.dc.latch_noise_ns = config.bus.latch_noise_ns;
      nodes.push_back(switch_on(i, factory_sii(config.slaves[i]), start));
    }
    rewire();
    true_delay.resize(nodes.size());
    for (const auto& passage : path.passages) {
      if (passage.processed) true_delay[passage.slave] = passage.time_ns - path.passages.front().time_ns;
    }
    schedule.emplace(config, start, *this);
  }

  [[nodiscard]] std::uint64_t seed_of(std::size_t i) const { return config.seed * 0x9E37'79B9'7F4A'7C15U + i; }
  Node switch_on(std::size_t i, std::vector<std::uint8_t> sii, Nanoseconds time) {
    auto node = power_up(config.slaves[i], std::move(sii), time, seed_of(i), work);
    node.esc->count_changes_in(setting_changes, event_changes);
    return node;
  }
  void restart(std::size_t i, Nanoseconds time) {
    nodes[i] = switch_on(i, nodes[i].esc->sii_content(), time);
    schedule->started_anew(i);
  }

  [[nodiscard]] bool linked(std::size_t i, unsigned port) const {
    const auto up = [this](std::size_t below) {
      const auto& parent = config.slaves[below].parent;
      return links[below].cable && links[below].power && (!parent || links[*parent].power);
    };
    if (port == wiring.entry(i)) return up(i);
    if (wiring.ring_at(i, port) != nullptr) return links[i].power;
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
      nodes[i].esc->forget_plans();
    }
    path = segment_path(config.slaves, wiring, ports);
    stops.clear();
    for (std::size_t p = 0; p < path.passages.size(); ++p) {
      const auto& passage = path.passages[p];
      const auto& node = nodes[passage.slave];
      if (passage.processed) stops.push_back({p, passage.slave, passage.offset, node.esc.get(), node.device.get()});
    }
    addresses.forget();
  }

  // ---- what faults do ----
  LineFaults& lines() override { return line_faults; }
  Esc& esc(std::size_t slave) override { return *nodes[slave].esc; }
  Device& device(std::size_t slave) override { return *nodes[slave].device; }
  void set_cable(std::size_t slave, bool plugged) override {
    links[slave].cable = plugged;
    rewire();
  }
  void reverse_cable(std::size_t slave, std::uint8_t port) override {
    const auto child = wiring.child(slave, port);
    const auto plug = [&](bool plugged) {
      links[slave].cable = plugged;
      if (child) links[*child].cable = plugged;
      rewire();
    };
    plug(false);
    wiring.reverse(slave, port);
    plug(true);
  }
  void close_ring(const std::optional<Wiring::Ring>& ring) override {
    wiring.close_ring(ring);
    rewire();
  }
  void foreign_frame(Nanoseconds time) override;
  void set_power(std::size_t slave, bool on, Nanoseconds time) override {
    if (on) restart(slave, time);
    links[slave].power = on;
    rewire();
  }

  void advance_to(Nanoseconds time) {
    schedule->run(time);
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
  Returned execute_foreign(std::size_t size, bool malformed, Nanoseconds send_time);
  /// When the last bit of a frame is back at the master.
  [[nodiscard]] Nanoseconds return_time(Nanoseconds send_time, Nanoseconds length) const {
    return send_time + static_cast<Nanoseconds>(path.return_ns + 0.5) + length;
  }
  using Reach = LineFaults::Reach;
  void note_addresses();
  /// A frame on its way.
  struct Flight {
    Reach& way;
    Nanoseconds send_time = 0, length = 0;
    bool at_once = false;  // slaves may pass it so
  };
  bool meet(const Stop& stop, Nanoseconds time);
  bool come_to(const Stop& stop, const Flight& flight, bool called);
  bool pass_uncalled(std::size_t from, std::size_t to, const Flight& flight);
  void pass_slaves(Reach& way, Nanoseconds send_time, Nanoseconds length);
  void note_port_times(const Reach& way, Nanoseconds send_time);
  void count_errors(const Reach& way);
  void end_frame(const Reach& reach, Nanoseconds send_time, Nanoseconds length);
};

SimBus::Returned SimBus::Impl::execute(std::span<std::uint8_t> frame, Nanoseconds send_time) {
  schedule->run(send_time);
  if (wire_free > send_time) {  // behind a frame of somebody else
    send_time = wire_free;
    wire_free += wire_time_ns(frame.size());
  }
  if (path.swallowed) advance_to(send_time);  // slaves that no frame reaches live on: a setting for a while ends
  now = std::max(now, send_time);
  if (line_faults.takes_frame()) return {true, 0};
  const auto kind = passing.arrive(frame);
  if (kind != PassingFrame::Kind::kEtherCat)
    return execute_foreign(frame.size(), kind == PassingFrame::Kind::kMalformed, send_time);

  auto way = line_faults.next_frame(path.passages);
  const auto length = length_of_frame(frame.size());
  if (!addresses.holds(setting_changes)) note_addresses();
  const bool mark_source = source_marked;
  pass_slaves(way, send_time, length);
  if (passing.takes_port_times()) note_port_times(way, send_time);
  if (way.damaged < way.end) count_errors(way);
  passing.leave();
  const bool lost = path.swallowed || way.end < path.passages.size() || way.damaged < path.passages.size();
  const auto back = return_time(send_time, length);
  end_frame(way, send_time, length);
  if (lost) return {true, 0};
  if (mark_source) frame[6] = static_cast<std::uint8_t>(frame[6] | 0x02);  // locally administered
  return {false, back};
}

void SimBus::Impl::note_addresses() {
  addresses.begin(setting_changes);
  source_marked = false;
  for (const auto& stop : stops) {
    addresses.add(*stop.esc);
    source_marked = source_marked || stop.esc->ports().destroys_foreign_frames();
  }
}

/// The frame comes to a slave. False: it is destroyed there.
bool SimBus::Impl::meet(const Stop& stop, Nanoseconds time) {
  const bool passed = stop.esc->process(passing, time);
  if (stop.esc->touched() || stop.device->sees_frames()) touched.push_back(&stop);
  return passed;
}

/// The same, with all that is due at the slave before it. `called`: something in it is for this slave alone. False: it
/// does not come, or is destroyed.
[[gnu::noinline]] bool SimBus::Impl::come_to(const Stop& stop, const Flight& flight, bool called) {
  if (stop.passage >= flight.way.end) return false;
  const auto begin = flight.send_time + stop.offset;
  stop.device->advance_to(begin);
  if (flight.at_once && (!called || stop.esc->is_only_asked_by(passing))) {
    const auto end = begin + flight.length;
    const bool passed = passing.is_for_single_slaves() ? stop.esc->answer_at_once(passing, begin, end)
                                                       : stop.esc->pass_at_once(passing, called, begin, end);
    if (passed) return true;
  }
  if (meet(stop, begin)) return true;
  flight.way.end = stop.passage;
  return false;
}

/// Through slaves for whom nothing in it is alone, from one place to before another one.
bool SimBus::Impl::pass_uncalled(std::size_t from, std::size_t to, const Flight& flight) {
  for (const auto& stop : std::span(stops).subspan(from, to - from)) {
    const auto begin = flight.send_time + stop.offset;
    if (flight.at_once && stop.esc->pass_at_once(passing, false, begin, begin + flight.length)) continue;
    if (!come_to(stop, flight, false)) return false;
  }
  return true;
}

/// Through the slaves up to the end of its way, which may come earlier than was thought.
void SimBus::Impl::pass_slaves(Reach& way, Nanoseconds send_time, Nanoseconds length) {
  touched.clear();
  const auto& called = addresses.called_by(passing, event_changes);
  const bool single = passing.is_for_single_slaves();
  const bool whole = std::min(way.end, way.damaged) == path.passages.size();
  const bool planned = single ? work == Work::kAtOnce : passing.shape() != nullptr;
  const Flight flight{way, send_time, length, whole && planned};
  std::size_t next = 0;
  for (const std::size_t place : called) {
    if (!single && !pass_uncalled(next, place, flight)) return;
    if (!come_to(stops[place], flight, true)) return;
    next = place + 1;
  }
  if (!single) (void)pass_uncalled(next, stops.size(), flight);
}

/// What the ESCs at the frame's way keep of when it came to their ports.
void SimBus::Impl::note_port_times(const Reach& way, Nanoseconds send_time) {
  for (std::size_t p = 0; p < way.end; ++p) {
    const auto& passage = path.passages[p];
    if (passage.looped) continue;
    nodes[passage.slave].esc->frame_at_port(passage.port, send_time + passage.offset, passage.first);
  }
}

void SimBus::Impl::count_errors(const Reach& way) {
  for (auto p = way.damaged; p < way.end; ++p) {
    if (path.passages[p].looped) continue;
    auto& ports = nodes[path.passages[p].slave].esc->ports();
    p == way.damaged ? ports.count_invalid_frame(path.passages[p].port)
                     : ports.count_forwarded_error(path.passages[p].port);
  }
}

/// The last byte has passed everywhere: what was written becomes effective where the frame was still good.
void SimBus::Impl::end_frame(const Reach& reach, Nanoseconds send_time, Nanoseconds length) {
  bool changed = false;
  for (const auto* stop : touched) {
    if (stop->passage >= reach.end) break;  // destroyed there
    const auto time = send_time + stop->offset + length;
    if (stop->device->sees_frames()) stop->device->frame_received(time - length, time);
    if (stop->passage < reach.damaged) {
      stop->esc->frame_end(time);
    } else {
      stop->esc->frame_damaged();
    }
    changed = stop->esc->ports().take_changed() || changed;
    if (!stop->esc->reset_requested()) continue;
    restart(stop->slave, time);
    changed = true;
  }
  if (path.closed_entry && reach.end == path.passages.size() && reach.damaged == reach.end) {
    auto& ports = nodes[*path.closed_entry].esc->ports();
    ports.frame_at_closed_port(wiring.entry(*path.closed_entry));
    changed = ports.take_changed() || changed;
  }
  if (changed) rewire();
}

/// No EtherCAT frame, or one whose lengths contradict each other: the first ESC notices and destroys it.
SimBus::Returned SimBus::Impl::execute_foreign(std::size_t size, bool malformed, Nanoseconds send_time) {
  bool bad = false;
  for (const auto& passage : path.passages) {
    auto& ports = nodes[passage.slave].esc->ports();
    if (bad && !passage.looped) {
      ports.count_forwarded_error(passage.port);
    } else if (passage.processed && (malformed || ports.destroys_foreign_frames())) {
      ports.count_processing_unit_error();
      bad = true;
    }
  }
  if (bad || path.swallowed) return {true, 0};
  return {false, return_time(send_time, length_of_frame(size))};
}

/// Of another program on the host: shortest frames, which the first ESC destroys.
void SimBus::Impl::foreign_frame(Nanoseconds time) {
  constexpr std::size_t kShortest = 60;
  const auto begin = std::max(time, wire_free);
  wire_free = begin + wire_time_ns(kShortest);
  (void)execute_foreign(kShortest, false, begin);
}

SimBus::SimBus(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimBus::~SimBus() = default;

Result<std::unique_ptr<SimBus>> SimBus::create(const SimConfig& config, Nanoseconds start, Work work) {
  if (config.slaves.empty()) return fail(ErrorCode::kConfiguration, config.name, because("the segment has no slaves"));
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (config.slaves[i].parent.value_or(0) < config.slaves.size()) continue;
    return fail(ErrorCode::kConfiguration, fmt::format("slave {}", i),
                because("no slave is where it hangs; check parent"));
  }
  // Where none hangs at the master the wiring has a circle, and the frame's way no end.
  if (std::ranges::all_of(config.slaves, [](const auto& slave) { return slave.parent.has_value(); }))
    return fail(ErrorCode::kConfiguration, "slave 0", because("no frame reaches it; check parent and port"));
  const Wiring wiring(config.slaves);
  const auto path = segment_path(config.slaves, wiring, all_connected(config.slaves, wiring));
  std::size_t expected = 0;
  for (const auto& passage : path.passages) {
    if (!passage.processed) continue;
    if (passage.slave != expected) {
      return fail(ErrorCode::kConfiguration, fmt::format("slave {}", expected),
                  because("the wiring puts slave {slave} at this place of the frame's way; list the slaves in frame "
                          "order (ports D, B, C; what hangs between another entry than A and port A comes first)",
                          passage.slave));
    }
    ++expected;
  }
  if (expected != config.slaves.size()) {
    return fail(ErrorCode::kConfiguration, fmt::format("slave {}", expected),
                because("no frame reaches it; check parent and port"));
  }
  return std::unique_ptr<SimBus>(new SimBus(std::make_unique<Impl>(config, start, work)));
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
  return std::as_const(*impl_->nodes.at(position).esc).dc().system_time(impl_->now);  // wakes up nobody
}
double SimBus::true_delay_ns(std::size_t position) const { return impl_->true_delay.at(position); }
std::vector<PinEdge> SimBus::pin_edges(std::size_t position, unsigned pin) const {
  const auto* trace = impl_->nodes.at(position).device->output_pin(pin);
  return trace != nullptr ? trace->edges() : std::vector<PinEdge>{};
}
std::vector<std::uint8_t> SimBus::peek(std::size_t position, std::uint16_t address, std::size_t length) const {
  auto& esc = *impl_->nodes.at(position).esc;
  esc.dc().start_of_frame(impl_->now);
  esc.refresh_registers();
  const auto bytes = std::as_const(esc).memory().at(address, length);
  return {bytes.begin(), bytes.end()};
}

}  // namespace syncline::sim
