// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "bench/ratio_report.h"
#include "trace/distribution.h"
#include "trace/even_samples.h"
#include "trace/signal_study.h"
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
  constexpr std::size_t kPortion = 1'000'000;
  SampleGathering gathering;
  gathering.aim(series, kStart, kEnd, 0);
  const double gathered = seconds([&] {
    while (!gathering.work(kPortion)) {
    }
  });
  report.add("stability: copy a portion of 1 M", gathered * 1e9 / 10, "a tick of 33 ms", 33e6, 0.5);
  static_cast<void>(gathering.take());
  EvenSamples samples;
  const double copy = seconds([&] { samples = EvenSamples(series, kStart, kEnd, 0); });
  report.add("even samples: copy 10 M", copy * 1e9, "a second", 1e9, 0.3);
  const double octaves = seconds([&] { (void)stability_octaves(samples.stretches(), 125e-6, 1e-9); });
  report.add("stability: octaves of 10 M samples", octaves * 1e9, "a second", 1e9, 1);
  const double spectrum = seconds([&] { (void)spectrum_of(samples.stretches(), 125e-6); });
  report.add("spectrum: 10 M samples", spectrum * 1e9, "a second", 1e9, 2);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  const auto series = syncline::bench::deviations();
  syncline::bench::bench_distribution(report, series);
  syncline::bench::bench_stability(report, series);
  return report.finish("Distributions, stability, spectrum");
}
