// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/composition/open_link.h"
#include "bench/ratio_report.h"
#include "channels/master_channels.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/sim_bus.h"
#include "support/clock.h"
#include "tests/support/simulated_network.h"

/// The simulated bus against the wire it stands for, virtual time against real time, and the sample
/// ring against reading the clock once.
namespace syncline::bench {
namespace {

constexpr std::uint16_t kSystemTime = 0x0910, kSystemTimeDifference = 0x092C, kAlStatus = 0x0130;

SimConfig line_of(std::size_t count) {
  SimConfig config;
  for (std::size_t i = 0; i < count; ++i) {
    SimSlaveConfig slave;
    slave.name = fmt::format("slave {}", i);
    slave.behaviour = "coupler";
    slave.device.identity = {1, 1, 1, 0};
    slave.device.type = "coupler";
    slave.oscillator.ppm = static_cast<double>(i % 41) - 20;
    if (i > 0) slave.parent = static_cast<std::uint16_t>(i - 1);
    config.slaves.push_back(slave);
  }
  return config;
}

/// One cycle of a bus: the time is distributed, deviation and state of every slave come back.
double cycle_ns(std::size_t slaves, std::size_t& frame_bytes) {
  auto created = sim::SimBus::create(line_of(slaves), VirtualClock::kDefaultStart);
  if (!created) return 0;
  auto& bus = **created;
  FrameBuilder builder;
  builder.add_zeros(Command::kArmw, 0, device_address(0, kSystemTime), 8);
  builder.add_zeros(Command::kBrd, 1, device_address(0, kSystemTimeDifference), 4);
  builder.add_zeros(Command::kBrd, 2, device_address(0, kAlStatus), 2);
  const auto frame = builder.finish();
  frame_bytes = frame.size();
  std::vector<std::uint8_t> buffer(frame.size());
  Nanoseconds now = VirtualClock::kDefaultStart;
  const double found = median_ns([&] {
    std::copy(frame.begin(), frame.end(), buffer.begin());
    bus.execute(buffer, now += kMillisecond);
  });
  // A figure counts only when every slave did its part.
  FrameReader reader(buffer);
  while (const auto datagram = reader.next()) {
    if (datagram->wkc() < slaves) return 0;
  }
  return found;
}

void bench_simulator(RatioReport& report) {
  double one = 0;
  for (const std::size_t slaves : {1, 10, 100, 1000}) {
    std::size_t bytes = 0;
    const double found = cycle_ns(slaves, bytes);
    if (found <= 0) {
      return report.add_failure(fmt::format("simulated cycle, {} slaves", slaves), "the bus did not answer");
    }
    const auto name = fmt::format("simulated cycle, {} slave{}", slaves, slaves == 1 ? "" : "s");
    report.add(name, found, "a cycle of 1 ms", 1e6, slaves == 100 ? 0.5 : 0);
    report.add(name, found, "the frame on the wire", static_cast<double>(wire_time_ns(bytes)), 0);
    if (slaves == 1) one = found;
    if (slaves == 100) report.add("simulated cycle, per slave of 100", found / 100, "a single slave", one, 2);
  }
}

/// What a simulated slave takes of the memory: EEPROM, registers, 64 KiB of ESC address space, objects.
void bench_memory(RatioReport& report) {
  constexpr std::size_t kSlaves = 1'000;
  for (const bool drives : {false, true}) {
    test::SimulatedNetwork network;
    for (std::size_t i = 0; i < kSlaves; ++i) {
      if (drives) {
        network.add(test::servo(), "servo-y");
      } else {
        network.add(test::io8());
      }
    }
    const auto in_use = [] {
      const auto info = mallinfo2();
      return static_cast<double>(info.uordblks + info.hblkhd);
    };
    const auto before = in_use();
    const auto bus = sim::SimBus::create(network.sim, VirtualClock::kDefaultStart);
    if (!bus) return report.add_failure("memory", describe(bus.error()));
    report.add_count(fmt::format("memory of a simulated {}", drives ? "drive" : "terminal"),
                     (in_use() - before) / kSlaves / 1024, "KiB", 256, "KiB", 1);
  }
}

/// A hundred slaves with SYNC0 in OP: every cycle with process data, time, deviation and the slaves' own work.
void bench_virtual_hundred(RatioReport& report, bool drives, double gate) {
  const std::string what = drives ? "virtual time, 100 drives" : "virtual time, 100 slaves";
  constexpr int kRounds = 11;  // the median of them, as in the other rows
  constexpr Nanoseconds kRound = kSecond, kStep = 100 * kMillisecond;
  test::SimulatedNetwork network;
  for (int i = 0; i < 100; ++i) drives ? network.add(test::servo(), "servo-y") : network.add(test::io8());
  network.project.master.dc.sync_window.enabled = true;
  VirtualClock clock;
  auto link = network.link(clock);
  if (!link) return report.add_failure(what, "no simulated bus");
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  (void)service.step();
  Snapshot snapshot;
  (void)service.channels().snapshot.read(snapshot);
  if (snapshot.state != AlState::kOp) return report.add_failure(what, "not in OP");
  std::vector<CycleSample> samples;
  std::size_t cycles = 0;
  const double took = median_ns(
      [&] {
        for (Nanoseconds done = 0; done < kRound; done += kStep) {
          service.run_for(kStep);
          samples.clear();
          service.channels().samples.pop(samples);
          cycles += samples.size();
        }
      },
      kRounds);
  (void)service.channels().snapshot.read(snapshot);
  if (snapshot.state != AlState::kOp || cycles < kRounds * 990) {
    return report.add_failure(what, fmt::format("{} cycles, then not in OP", cycles));
  }
  report.add_factor(what + " with DC, 1000 us cycle", static_cast<double>(kRound) / took, gate);
}

/// Ten virtual seconds of the demonstration machine with everything that a run does.
void bench_virtual_time(RatioReport& report) {
  const auto fail = [&report](const std::string& why) { report.add_failure("virtual time", why); };
  const auto link = demo_link(true);
  eni::EsiCatalogue catalogue;
  if (!catalogue.add_folder(resource_folder() + "/esi")) return fail("no ESI files of the demonstration");
  const auto scan = scan_bus(open_link(link));
  if (!scan) return fail(describe(scan.error()));
  auto project = eni::project_from_scan(*scan, catalogue).project;
  const auto compiled = compile(project);
  if (!compiled) return fail(describe(compiled.error()));
  RunRequest request;
  request.duration = 10 * kSecond;
  const double start = processor_seconds();
  const auto outcome = run_network(compiled->config, open_link(link), request);
  const double took = processor_seconds() - start;
  if (!outcome) return fail(describe(outcome.error()));
  if (outcome->error) return fail(describe(*outcome->error));
  // The bring-up is part of the ten seconds.
  const auto& run = outcome->report;
  if (run.state != AlState::kOp || run.cycles < 8'000) {
    return fail(fmt::format("ended with state {} after {} cycles", static_cast<int>(run.state), run.cycles));
  }
  const double cycle_us = static_cast<double>(outcome->report.cycle_time) / 1e3;
  report.add_factor(fmt::format("virtual time, {} slaves, {} us cycle", scan->slaves.size(), cycle_us), 10 / took, 10);
}

void bench_samples(RatioReport& report) {
  const RealClock clock;
  Nanoseconds sum = 0;
  const double read = median_ns([&] { sum += clock.now(); });
  SampleRing ring;
  std::vector<CycleSample> drained;
  drained.reserve(1U << 16);
  CycleSample sample;
  int pushed = 0;
  const double push = median_ns([&] {
    sample.cycle = static_cast<std::uint64_t>(sum & 0xFF);
    ring.push(sample);
    if (++pushed % 256 == 0) {
      drained.clear();
      ring.pop(drained);
    }
  });
  report.add("sample through the ring", push, "reading the clock", read, 10);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  syncline::bench::bench_simulator(report);
  syncline::bench::bench_virtual_hundred(report, false, 140);
  syncline::bench::bench_virtual_hundred(report, true, 80);
  syncline::bench::bench_memory(report);
  syncline::bench::bench_virtual_time(report);
  syncline::bench::bench_samples(report);
  return report.finish("Simulator, virtual time, samples");
}
