// SPDX-License-Identifier: Apache-2.0
#include "tests/scenario/interval_machine.h"

#include <algorithm>
#include <array>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "master/master_service.h"
#include "support/random.h"
#include "tests/support/simulated_network.h"
#include "trace/run_report.h"

namespace syncline::test {
namespace {

class CoverageCount {
 public:
  explicit CoverageCount(std::string what) { coverage_.what = std::move(what); }
  void add(const std::optional<Interval>& interval, double truth) {
    ++coverage_.runs;
    if (!interval) return;
    ++coverage_.stated;
    coverage_.mean_width += interval->high - interval->low;
    if (interval->holds(truth)) coverage_.held += 1;
  }
  [[nodiscard]] Coverage finish() const {
    auto result = coverage_;
    const auto stated = static_cast<double>(std::max<std::size_t>(result.stated, 1));
    result.held /= stated;
    result.mean_width /= stated;
    return result;
  }

 private:
  Coverage coverage_;
};

}  // namespace

IntervalRun run_interval_machine(std::uint64_t seed, std::int64_t duration) {
  Random random(seed);
  SimulatedNetwork network;
  for (int i = 0; i < 3; ++i) network.add(io8());
  const double reference = random.uniform(-60, 60);
  constexpr std::array kOthers{0.0, 18.0, -12.0};
  for (std::size_t i = 0; i < 3; ++i) network.sim.slaves[i].oscillator.ppm = reference + kOthers[i];
  network.sim.seed = random.next();
  auto& master = network.project.master;
  master.cycle_time = 2 * kMillisecond;
  master.dc.dcm.mode = DcmMode::kMasterShift;
  master.dc.sync_window.enabled = true;
  master.dc.burst_total = 3'000;

  VirtualClock clock;
  const auto jitter = JitterProfile::quiet();
  clock.set_wakeup_jitter(jitter, random.next());
  auto bus = sim::SimBus::create(network.sim, clock.now());
  if (!bus) return {};
  const auto config = network.compiled();
  RunRecorder recorder(config);
  MasterService service(make_simulated_link("sim", std::move(*bus), clock, SimulatedHost::with(jitter, random.next())),
                        clock);
  service.channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  (void)service.step();
  std::vector<CycleSample> samples;
  const auto drain = [&] {
    samples.clear();
    service.channels().samples.pop(samples);
    recorder.add(samples);
  };
  drain();
  for (std::int64_t done = 0; done < duration; done += kSecond) {
    service.run_for(std::min<std::int64_t>(kSecond, duration - done));
    drain();
  }
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  const auto report = recorder.finish(snapshot);

  IntervalRun run;
  run.true_drift_ppm = reference;
  run.drift_ppm = report.dcm.drift_ppm;
  if (const auto half = report.dcm.drift_half_width_ppm)
    run.drift = Interval{run.drift_ppm - *half, run.drift_ppm + *half};
  run.dcm_error = report.dcm_error;
  run.deviation = report.slaves.back().deviation;
  return run;
}

std::vector<Coverage> interval_coverage(std::size_t runs, std::int64_t duration, std::uint64_t first_seed) {
  std::vector<IntervalRun> all;
  double error = 0, deviation = 0;
  for (std::size_t i = 0; i < runs; ++i) {
    all.push_back(run_interval_machine(first_seed + i, duration));
    error += all.back().dcm_error.mean();
    deviation += all.back().deviation.mean();
  }
  error /= static_cast<double>(std::max<std::size_t>(runs, 1));
  deviation /= static_cast<double>(std::max<std::size_t>(runs, 1));
  CoverageCount drifts("drift"), errors("mean DCM error"), deviations("mean deviation of a slave");
  for (const auto& run : all) {
    drifts.add(run.drift, run.true_drift_ppm);
    errors.add(run.dcm_error.mean_interval(), error);
    deviations.add(run.deviation.mean_interval(), deviation);
  }
  return {drifts.finish(), errors.finish(), deviations.finish()};
}

}  // namespace syncline::test
