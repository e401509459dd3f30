// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/ratio_report.h"
#include "channels/cycle_sample.h"
#include "trace/distribution.h"
#include "trace/even_samples.h"
#include "trace/sample_store.h"
#include "trace/signal_study.h"
#include "trace/slave_cells.h"
#include "trace/slave_figures.h"
#include "trace/spectrum.h"
#include "trace/stability.h"

/// What the views of the monitor make of 10 million samples.
namespace syncline::bench {
namespace {

constexpr std::size_t kSamples = 10'000'000;
constexpr Nanoseconds kStart = 830'000'000 * kSecond, kCycle = 125 * kMicrosecond;
constexpr Nanoseconds kEnd = kStart + static_cast<Nanoseconds>(kSamples) * kCycle;

MinMaxSeries deviations() {
  MinMaxSeries series(kSamples);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const auto value = static_cast<float>(static_cast<int>(random() % 201) - 100);
    series.append(kStart + static_cast<Nanoseconds>(i) * kCycle, random() % 5000 == 0 ? value * 8 : value);
  }
  return series;
}

double seconds(const std::function<void()>& call) {
  const double start = processor_seconds();
  call();
  return processor_seconds() - start;
}

void bench_distribution(RatioReport& report, const MinMaxSeries& series) {
  constexpr std::size_t kPortion = 1'000'000;
  const BinGrid grid{-800, 800, 64};
  Distribution distribution;
  const double whole = seconds([&] {
    distribution.aim(&series, kStart, kEnd, grid);
    while (!distribution.work(kPortion)) {
    }
  });
  report.add("distribution: 10 M samples", whole * 1e9, "a second", 1e9, 0.33);
  report.add("distribution: a portion of 1 M", whole * 1e9 / 10, "a tick of 33 ms", 33e6, 0.5);
  Nanoseconds moved = 0;
  const double tick = median_ns([&] {
    moved = (moved + 267 * kCycle) % (100 * kSecond);
    distribution.aim(&series, kStart + moved, kEnd - 200 * kSecond + moved, grid);
    while (!distribution.work(kPortion)) {
    }
  });
  report.add("distribution: move by a tick, quantiles", tick + median_ns([&] {
                                                          for (const double fraction : {0.5, 0.99, 0.999, 0.9999})
                                                            (void)distribution.quantile(fraction);
                                                        }),
             "a tick of 33 ms", 33e6, 0.1);
  report.add("distribution: samples of a bin", seconds([&] { (void)distribution.hits(40, 500); }) * 1e9,
             "a tick of 33 ms", 33e6, 2);
}

void bench_stability(RatioReport& report, const MinMaxSeries& series) {
  constexpr std::size_t kPortion = 500'000;  // a tick of StabilityView
  SampleGathering gathering;
  gathering.aim(series, kStart, kEnd, 0);
  const double gathered = seconds([&] {
    while (!gathering.work(kPortion)) {
    }
  });
  report.add("stability: copy a portion of 0.5 M", gathered * 1e9 / 20, "a tick of 33 ms", 33e6, 0.5);
  static_cast<void>(gathering.take());
  EvenSamples samples;
  const double copy = seconds([&] { samples = EvenSamples(series, kStart, kEnd, 0); });
  report.add("even samples: copy 10 M", copy * 1e9, "a second", 1e9, 0.3);
  const double octaves = seconds([&] { (void)stability_octaves(samples.stretches(), 125e-6, 1e-9); });
  report.add("stability: octaves of 10 M samples", octaves * 1e9, "a second", 1e9, 1);
  const double spectrum = seconds([&] { (void)spectrum_of(samples.stretches(), 125e-6); });
  report.add("spectrum: 10 M samples", spectrum * 1e9, "a second", 1e9, 2);
}

/// A run of 300 slaves, one of which is read a cycle.
class SlavesRun {
 public:
  static constexpr std::size_t kSlaves = 300;
  void go_on(std::size_t cycles) {
    for (std::size_t done = 0; done < cycles; done += samples_.size()) {
      samples_.resize(std::min<std::size_t>(cycles - done, 8192));
      for (auto& sample : samples_) {
        sample.cycle = cycle_;
        sample.send_time = kStart + static_cast<Nanoseconds>(cycle_) * kCycle;
        sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows;
        sample.slave_position = static_cast<std::int16_t>(cycle_ % kSlaves);
        sample.slave_deviation_ns = static_cast<std::int32_t>(random_() % 201) - 100;
        ++cycle_;
      }
      store.append(samples_);
    }
  }
  /// The last `cycles` in 1000 columns.
  [[nodiscard]] SlaveCells::Grid grid(std::size_t cycles) const {
    constexpr Nanoseconds kColumns = 1000;
    const auto width = static_cast<Nanoseconds>(cycles) * kCycle / kColumns;
    return {(store.last_time() / width - kColumns + 1) * width, width, kColumns};
  }
  SampleStore store{{.slaves = kSlaves, .cycle_time = kCycle, .cycle_capacity = kSamples}};

 private:
  std::vector<CycleSample> samples_;
  std::uint64_t cycle_ = 0;
  std::mt19937 random_{1};
};

void bench_slaves(RatioReport& report) {
  SlavesRun run;
  run.go_on(kSamples);
  struct Range {
    std::size_t cycles;
    const char* name;
  };
  for (const auto& range : {Range{kSamples, "10 M cycles"}, Range{480'000, "a minute"}, Range{8'000, "a second"}}) {
    const std::string what = std::string("slaves: 300 x 1000 cells of ") + range.name;
    SlaveCells cells;
    const double anew = median_ns([&] {
      cells.forget();
      cells.show(run.store, run.grid(range.cycles));
    });
    report.add(what + ", anew", anew, "a tick of 33 ms", 33e6, 1);
    const double frame = median_ns([&] {
      run.go_on(267);
      cells.show(run.store, run.grid(range.cycles));
    });
    report.add(what + ", 267 cycles more", frame, "8 ms", 8e6, 1);
  }
  SlaveFigureRound round;
  const double portion = seconds([&] {
    round.aim(run.store, kStart, run.store.last_time(), 90);
    static_cast<void>(round.work(300'000));
  });
  report.add("slaves: figures, a portion of 300 k readings", portion * 1e9, "a tick of 33 ms", 33e6, 0.5);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  const auto series = syncline::bench::deviations();
  syncline::bench::bench_distribution(report, series);
  syncline::bench::bench_stability(report, series);
  syncline::bench::bench_slaves(report);
  return report.finish("Distributions, stability, spectrum, slaves");
}
