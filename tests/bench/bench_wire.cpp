// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>

#include "app/composition/load_scenario.h"
#include "app/composition/open_link.h"
#include "config/sim_config.h"
#include "engine/opened_link.h"
#include "engine/simulate_bus.h"
#include "findings/error_text.h"
#include "link/pcap_link.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/clock.h"
#include "support/real_time.h"
#include "tests/support/net_namespace.h"
#include "tests/support/source_dir.h"
#include "trace/histogram.h"

/// A cyclic frame over a veth pair to the simulated bus and back, both ends on this machine: round trip and the
/// processor time of the master's thread for each cycle, asleep until the deadline or awake before it.
namespace syncline::bench {
namespace {

using test::NetNamespace;

const std::string kMachine = test::source_dir() + "/resources/demo/machine.toml";

double thread_us() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  const auto us = [](const timeval& t) { return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_usec); };
  return us(usage.ru_utime) + us(usage.ru_stime);
}

/// Serves the demonstration machine on the bus's end until it is destroyed.
class ServedBus {
 public:
  ServedBus() {
    request_.adapter = NetNamespace::kBusEnd;
    request_.stop = &stop_;
    request_.on_ready = [this](const SimConfig&, const AdapterInfo&) { ready_ = true; };
    thread_ = std::thread([this] {
      if (!simulate_bus(load_network(kMachine, 0, {}), request_)) failed_ = true;
      ended_ = true;
    });
    while (!ready_ && !ended_) std::this_thread::yield();
  }
  ~ServedBus() {
    stop_ = true;
    thread_.join();
  }
  ServedBus(const ServedBus&) = delete;
  ServedBus& operator=(const ServedBus&) = delete;
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  SimulateRequest request_;
  std::atomic<bool> stop_{false}, ready_{false}, ended_{false}, failed_{false};
  std::thread thread_;
};

int measure(Nanoseconds cycle, Nanoseconds spin, int seconds) {
  auto opened = open_link(std::string("nic:") + NetNamespace::kMasterEnd);
  if (!opened) {
    fmt::print("  {}\n", describe(opened.error()));
    return 1;
  }
  auto& clock = *opened->clock;
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> broadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 1514> buffer{};
  Histogram round_trip;
  std::uint64_t lost = 0;
  const RealTimeScope scope;
  const auto begin = thread_us();
  auto next = clock.now() + 10 * cycle;
  const auto end = next + seconds * kSecond;
  std::uint8_t index = 0;
  for (; next < end; next += cycle) {
    clock.sleep_until(next - spin);
    while (clock.now() < next) {
    }
    builder.reset();
    builder.set_addresses(broadcast, opened->link->describe().mac);
    (void)builder.add_zeros(Command::kArmw, ++index, device_address(0, 0x0910), 8);
    (void)builder.add_zeros(Command::kBrd, index, device_address(0, 0x092C), 4);
    (void)builder.add_zeros(Command::kLrw, index, 0x0100'0000, 64);
    const auto sent = clock.now();
    if (!opened->link->send(builder.finish())) return 1;
    for (;;) {
      const auto received = opened->link->receive(buffer, sent + cycle);
      if (!received) {
        ++lost;
        break;
      }
      FrameReader reader{std::span(buffer).first(received->length)};
      const auto first = reader.next();
      if (!first || first->header.index != index) continue;  // one that came after its cycle
      round_trip.add(clock.now() - sent);
      break;
    }
    if (const auto now = clock.now(); now > next + cycle) next += (now - next) / cycle * cycle;
  }
  const auto cpu = (thread_us() - begin) / static_cast<double>(round_trip.count() + lost);
  const auto us = [&](double fraction) { return static_cast<double>(round_trip.percentile(fraction)) / 1000; };
  fmt::print("  {:>7.0f} {:>7.0f} {:>9} {:>6} {:>9.2f} {:>9.2f} {:>9.2f} {:>12.1f}\n",
             static_cast<double>(cycle) / 1000, static_cast<double>(spin) / 1000, round_trip.count(), lost, us(0.5),
             us(0.99), us(0.999), cpu);
  std::fflush(stdout);
  return 0;
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  using namespace syncline;
  const int seconds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
  const test::NetNamespace network;
  if (!network.ready()) {
    fmt::print("Round trip over a veth pair: skipped, no permission to create a network namespace\n");
    return 0;
  }
  const bench::ServedBus bus;
  if (bus.failed()) return 1;
  fmt::print(
      "Round trip over a veth pair to the simulated machine, {} s each (us; processor: the master's thread a cycle)\n",
      seconds);
  fmt::print("    cycle    spin    frames   lost       p50       p99     p99.9    processor\n");
  int status = 0;
  for (const auto cycle : {kMillisecond, 250 * kMicrosecond}) {
    for (const auto spin : {Nanoseconds{0}, 50 * kMicrosecond}) status |= bench::measure(cycle, spin, seconds);
  }
  return status;
}
