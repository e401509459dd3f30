// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <thread>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"
#include "trace/histogram.h"

/// How late the cyclic thread sends on the real clock, and what a cycle costs, idle and beside a loaded core,
/// with and without the spin before the deadline. Figures of this machine: no promise is attached, and none
/// about the largest one.
namespace syncline::bench {
namespace {

/// A process that keeps one core busy while it lives.
class Load {
 public:
  explicit Load(bool wanted) {
    if (!wanted) return;
    child_ = fork();
    if (child_ == 0) {
      volatile std::uint64_t n = 0;
      while (getppid() != 1) n = n + 1;
      _exit(0);
    }
  }
  ~Load() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  pid_t child_ = -1;
};

double process_us() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto us = [](const timeval& t) { return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_usec); };
  return us(usage.ru_utime) + us(usage.ru_stime);
}

void measure(Nanoseconds cycle, Nanoseconds spin, bool loaded, int seconds) {
  test::SimulatedNetwork network;
  network.add(test::io8());
  network.add(test::io8());
  network.project.master.cycle_time = cycle;
  network.project.master.real_time.spin = spin;
  network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  network.project.master.dc.enabled = false;  // the schedule alone
  RealClock clock;
  MasterService service(network.link(clock), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const Load load(loaded);
  Histogram histogram;
  std::uint64_t overruns = 0;
  std::vector<CycleSample> samples;
  MasterThread thread(service);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  service.channels().samples.pop(samples);
  const auto cpu = process_us();
  for (int i = 0; i < seconds * 10; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    samples.clear();
    service.channels().samples.pop(samples);
    for (const auto& sample : samples) {
      histogram.add(sample.wake_lateness_ns);
      if ((sample.flags & CycleSample::kOverrun) != 0) ++overruns;
    }
  }
  const auto us = [&](double fraction) { return static_cast<double>(histogram.percentile(fraction)) / 1000; };
  const auto cost = (process_us() - cpu) / static_cast<double>(std::max<std::uint64_t>(1, histogram.count()));
  thread.stop();
  fmt::print("  {:>7.0f} {:>7.0f}  {:<12} {:>8} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9} {:>9.1f}\n",
             static_cast<double>(cycle) / 1000, static_cast<double>(spin) / 1000, loaded ? "loaded core" : "idle",
             histogram.count(), us(0.5), us(0.9), us(0.99), us(0.999), overruns, cost);
  std::fflush(stdout);
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  using namespace syncline;
  const int seconds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 60;
  fmt::print(
      "Lateness of the cyclic thread, {} s each (us; \"processor\" is the whole process with the simulated bus)\n",
      seconds);
  fmt::print("    cycle    spin  other core     cycles       p50       p90       p99     p99.9  overruns processor\n");
  for (const bool loaded : {false, true}) {
    for (const auto cycle : {kMillisecond, 250 * kMicrosecond}) {
      for (const auto spin : {Nanoseconds{0}, 50 * kMicrosecond, 100 * kMicrosecond}) {
        if (spin <= cycle / 4) bench::measure(cycle, spin, loaded, seconds);
      }
    }
  }
  return 0;
}
