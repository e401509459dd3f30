// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "bench/ratio_report.h"
#include "bench/sequential_scan.h"
#include "findings/error_text.h"
#include "link/bus_responder.h"
#include "link/pcap_link.h"
#include "link/raw_port.h"
#include "master/exchange/bus.h"
#include "master/scan/bus_scanner.h"
#include "sim/sim_bus.h"
#include "support/net_namespace.h"
#include "support/scan_bed.h"

/// What a scan costs: frames, and time against a scan that asks one slave after the other.
namespace syncline::bench {
namespace {

using test::CountingLink;
using test::SimulatedNetwork;

/// Every slave with its SII, or why not.
std::string shortcoming(const Result<BusScan>& scan, std::size_t expected) {
  if (!scan) return describe(scan.error());
  if (scan->slaves.size() != expected) return fmt::format("{} slaves", scan->slaves.size());
  for (const auto& slave : scan->slaves) {
    if (!slave.sii) return slave.sii_error ? describe(*slave.sii_error) : "a slave without SII";
  }
  return {};
}

void bench_frames(RatioReport& report, const std::string& name, const SimulatedNetwork& network, double limit) {
  VirtualClock clock;
  CountingLink link(network.link(clock));
  FrameExchange exchange(link, clock);
  Bus bus(exchange, clock);
  const auto begin = std::chrono::steady_clock::now();
  const auto virtual_begin = clock.now();
  const auto scan = scan_slaves(bus);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto slaves = network.sim.slaves.size();
  if (const auto why = shortcoming(scan, slaves); !why.empty()) return report.add_failure(name, why);
  report.add_count(name, static_cast<double>(link.frames), "frames", static_cast<double>(slaves), "slaves", limit);
  fmt::print("{}: {} frames, {} bytes, {:.1f} ms on the bus, {:.0f} ms of processor with the simulation\n", name,
             link.frames, link.bytes, static_cast<double>(clock.now() - virtual_begin) / 1e6, took * 1e3);
}

struct Took {
  double seconds = 0;
  std::size_t frames = 0;
  std::string error;
};

template <class Scan>
Took measure(Link& inner, Clock& clock, Scan scan) {
  struct Borrowed final : Link {
    explicit Borrowed(Link& own) : link(own) {}
    Status send(std::span<const std::uint8_t> frame) override { return link.send(frame); }
    Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
      return link.receive(buffer, deadline);
    }
    [[nodiscard]] LinkDescription describe() const override { return link.describe(); }
    Link& link;
  };
  CountingLink counting(std::make_unique<Borrowed>(inner));
  FrameExchange exchange(counting, clock);
  exchange.set_addresses({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, inner.describe().mac);
  Bus bus(exchange, clock);
  const auto begin = clock.now();
  auto error = scan(bus);
  return {static_cast<double>(clock.now() - begin) / 1e9, counting.frames, std::move(error)};
}

void compare(RatioReport& report, const std::string& name, const SimulatedNetwork& network, Link& link, Clock& clock,
             double promised) {
  const auto slaves = network.sim.slaves.size();
  const auto slow = measure(link, clock, [&](Bus& bus) {
    const auto found = sequential_scan(bus);
    if (!found) return describe(found.error());
    return found->size() == slaves ? std::string() : fmt::format("{} slaves", found->size());
  });
  const auto fast = measure(link, clock, [&](Bus& bus) { return shortcoming(scan_slaves(bus), slaves); });
  if (!slow.error.empty() || !fast.error.empty()) return report.add_failure(name, slow.error + fast.error);
  fmt::print("{}: {} slaves in {:.1f} ms with {} frames, one after the other {:.1f} ms with {} frames\n", name, slaves,
             fast.seconds * 1e3, fast.frames, slow.seconds * 1e3, slow.frames);
  report.add_factor(name, slow.seconds / fast.seconds, promised);
}

void bench_simulated(RatioReport& report, const SimulatedNetwork& network) {
  VirtualClock clock;
  const auto link = network.link(clock);
  compare(report, "scan_speedup, simulated segment", network, *link, clock, 5);
}

/// The same bus on the far end of a veth pair, in real time.
void bench_veth(RatioReport& report, const SimulatedNetwork& network) {
  const char* name = "scan_speedup, veth";
  const test::NetNamespace space;
  if (!space.ready()) {
    fmt::print("{}: skipped, no permission to create a network namespace with a veth pair\n", name);
    return;
  }
  RealClock clock;
  auto port = RawPort::open(test::NetNamespace::kBusEnd, clock);
  auto link = open_pcap_link(test::NetNamespace::kMasterEnd, clock);
  auto bus = sim::SimBus::create(network.sim, clock.now());
  if (!port || !link || !bus) return report.add_failure(name, "the veth pair cannot be used");
  std::atomic<bool> stop{false};
  BusResponder responder(**bus, *port, clock, {});
  std::thread server([&] { (void)responder.serve(0, stop); });
  compare(report, name, network, **link, clock, 5);
  stop = true;
  server.join();
}

}  // namespace
}  // namespace syncline::bench

int main() {
  using namespace syncline;
  bench::RatioReport report;
  const auto different = test::different_slaves(100);
  bench::bench_frames(report, "scan_frames_100_different", different, 3);
  bench::bench_frames(report, "scan_frames_100_identical", test::identical_slaves(100), 0.4);
  bench::bench_frames(report, "scan_1000, of one kind", test::identical_slaves(1000), 0);
  bench::bench_frames(report, "scan_1000, all different", test::different_slaves(1000), 3);
  bench::bench_simulated(report, different);
  bench::bench_veth(report, test::different_slaves(50));
  return report.finish("Scan");
}
