// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "bench/ratio_report.h"
#include "master/cyclic/evidence_reader.h"
#include "master/exchange/run_state.h"
#include "support/random.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

/// How soon a fault is told, what the evidence costs, and whether healthy machines are left in peace.
/// `bench_diagnosis [HOURS]`: so many virtual hours of healthy machines; default a quarter, and 24 before a release.
namespace syncline::bench {
namespace {

constexpr int kFaults = 1'000;
constexpr Nanoseconds kFaultAt = 6 * kSecond;

/// A kind of fault and the event by which it is told.
struct Told {
  const char* name;
  FaultKind kind;
  EventKind event;
  bool of_slave;  // the event names the slave
};
constexpr Told kTold[] = {
    {"lost frames", FaultKind::kLoseFrames, kind_of<events::FramesLost>, false},
    {"damaged frames", FaultKind::kBitErrors, kind_of<events::PortErrors>, true},
    {"cable break", FaultKind::kCableBreak, kind_of<events::SlaveLost>, true},
    {"power off", FaultKind::kSlaveOff, kind_of<events::SlaveLost>, true},
    {"host stall", FaultKind::kHostStall, kind_of<events::CyclesLeftOut>, false},
    {"clock step", FaultKind::kClockStep, kind_of<events::SlavesOutOfSync>, false},
    {"firmware hangs", FaultKind::kStopApplication, kind_of<events::WatchdogExpired>, true},
    {"SYNC unheard", FaultKind::kSilentSync, kind_of<events::AlStatusError>, true},
};

test::SimulatedNetwork machine(Random& random, bool drives_only) {
  test::SimulatedNetwork network;
  network.add(test::io8());
  const int drives = 2 + static_cast<int>(random.uniform(0, 4));
  for (int i = 0; i < drives; ++i) network.add(test::servo(), "servo-y");
  if (!drives_only) network.add(test::io8());
  test::give_random_clocks(network, random);
  auto& dc = network.project.master.dc;
  dc.sync_window.enabled = true;
  dc.dcm.mode = random.uniform() < 0.5 ? DcmMode::kBusShift : DcmMode::kMasterShift;
  return network;
}

FaultConfig fault_of(const Told& told, Random& random, int slave) {
  FaultConfig fault;
  fault.kind = told.kind;
  fault.at = kFaultAt + static_cast<Nanoseconds>(random.uniform(0, 1e9));
  const bool of_host = told.kind == FaultKind::kLoseFrames || told.kind == FaultKind::kHostStall;
  fault.slave = of_host ? -1 : slave;
  if (told.kind == FaultKind::kHostStall) fault.value_ns = static_cast<Nanoseconds>(random.uniform(3e6, 30e6));
  if (told.kind == FaultKind::kClockStep) fault.value_ns = static_cast<Nanoseconds>(random.uniform(1e3, 1e6));
  return fault;
}

/// From the fault (a stall's end) until the event can be read; ms. Negative: it was not told within 3 s.
double told_after(const Told& told, std::uint64_t seed) {
  Random random(seed);
  auto network = machine(random, true);
  const int slave = 1 + static_cast<int>(random.uniform(0, static_cast<double>(network.sim.slaves.size() - 1)));
  const auto fault = fault_of(told, random, slave);
  network.sim.faults.push_back(fault);
  VirtualClock clock;
  clock.set_wakeup_jitter(JitterProfile::quiet(), seed);
  const auto begin = clock.now();
  MasterService service(network.link(clock), clock);
  auto& channels = service.channels();
  channels.commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const auto at = begin + fault.at + (told.kind == FaultKind::kHostStall ? fault.value_ns : 0);
  service.run_for(begin + fault.at - 2 * kMillisecond - clock.now());
  (void)channels.events.drain();
  while (clock.now() < at + 3 * kSecond) {
    service.run_for(kMillisecond);
    if (clock.now() < begin + fault.at) continue;
    for (const auto& event : channels.events.drain()) {
      const bool names = !told.of_slave || event.slave == slave;
      if (event.kind() == told.event && names) {
        return static_cast<double>(clock.now() - at) / 1e6;
      }
    }
  }
  return -1;
}

void faults(RatioReport& report) {
  std::map<std::string, std::vector<double>> by_kind;
  std::vector<double> all;
  int missed = 0;
  for (int i = 0; i < kFaults; ++i) {
    const auto& told = kTold[static_cast<std::size_t>(i) % std::size(kTold)];
    const double after = told_after(told, static_cast<std::uint64_t>(i) + 1);
    if (after < 0) {
      ++missed;
      fmt::print("not told: {}, seed {}\n", told.name, i + 1);
      continue;
    }
    by_kind[told.name].push_back(after);
    all.push_back(after);
  }
  const auto line = [](const std::string& name, std::vector<double>& times) {
    std::ranges::sort(times);
    fmt::print("{:16} {:4} faults   p50 {:7.1f}   p99 {:7.1f}   max {:7.1f} ms\n", name, times.size(),
               times[times.size() / 2], times[times.size() * 99 / 100], times.back());
  };
  for (auto& [name, times] : by_kind) line(name, times);
  line("all", all);
  report.add_count("faults that were not told", missed, "faults", kFaults, "faults", 0);
  if (missed > 0) report.add_failure("every fault is told", fmt::format("{} of {} were not", missed, kFaults));
}

/// The reader's own work in a cycle, against the whole cycle of the master and the simulated bus.
void evidence(RatioReport& report) {
  Random random(1);
  test::SimulatedNetwork network;
  for (int i = 0; i < 100; ++i) network.add(test::servo(), "servo-y");
  network.project.master.dc.sync_window.enabled = true;
  const auto config = network.compiled();
  MasterChannels channels;
  RunState run(config, channels);
  for (auto& slave : run.snapshot.slaves) slave.present = true;
  EvidenceReader reader(config, run.snapshot, run.teller);
  PendingFrame frame;
  std::size_t bytes = 0, cycles = 0;
  const double reading = median_ns([&] {
    frame.clear();
    if (auto* datagram = reader.next(0)) frame.add(*datagram);
    bytes += frame.size();
    ++cycles;
    for (auto* datagram : frame.datagrams()) {
      datagram->answered = true;
      datagram->wkc = 1;
    }
    reader.take(kSecond);
  });
  VirtualClock clock;
  MasterService service(network.link(clock), clock);
  service.channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  service.run_for(10 * kSecond);
  const auto before = processor_seconds();
  service.run_for(5 * kSecond);
  const double cycle = (processor_seconds() - before) * 1e9 / 5'000;
  report.add("evidence of 100 drives, a cycle", reading, "the whole cycle, bus simulated", cycle, 0.05);
  const auto wire = static_cast<double>(bytes) / static_cast<double>(cycles);
  fmt::print("evidence: {:.1f} bytes a cycle on the wire at most, {:.0f} ns\n", wire, reading);
}

void healthy(RatioReport& report, double hours) {
  double left = hours * 3'600;
  int accused = 0, machines = 0;
  for (std::uint64_t seed = 1; left > 0; ++seed, ++machines) {
    Random random(seed);
    test::DiagnosedRun run;
    run.network = machine(random, false);
    run.jitter = JitterProfile::quiet();
    const double seconds = std::min(left, random.uniform(60, 1'800));
    run.run(static_cast<Nanoseconds>(seconds * 1e9));
    left -= seconds;
    if (!run.accuses()) continue;
    ++accused;
    fmt::print("accused, seed {}, {:.0f} s:\n{}", seed, seconds, run.said());
  }
  report.add_count(fmt::format("machines accused in {:.2f} healthy hours", hours), accused, "machines", machines,
                   "machines", 0);
  if (accused > 0) report.add_failure("no false finding", fmt::format("{} machines were accused", accused));
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 0.25;
  syncline::bench::RatioReport report;
  syncline::bench::faults(report);
  syncline::bench::evidence(report);
  syncline::bench::healthy(report, hours);
  return report.finish("Faults told, evidence, healthy machines");
}
