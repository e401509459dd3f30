// SPDX-License-Identifier: Apache-2.0
#include "bench/ratio_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace syncline::bench {
namespace {

double seconds_of(clockid_t clock) {
  timespec used{};
  clock_gettime(clock, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) / 1e9;
}

std::string duration(double ns) {
  if (ns < 1e3) return fmt::format("{:.1f} ns", ns);
  if (ns < 1e6) return fmt::format("{:.2f} us", ns / 1e3);
  return fmt::format("{:.2f} ms", ns / 1e6);
}

std::string ratio_text(double ratio) {
  if (ratio < 1e-9) return "0";
  return ratio < 0.1 ? fmt::format("1/{:.0f}", 1 / ratio) : fmt::format("{:.2f}", ratio);
}

}  // namespace

double processor_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

double all_processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

double median_ns(const std::function<void()>& call, int rounds) {
  constexpr double kLongEnough = 5e6;
  const auto time = [&call](int repeats) {
    const double start = processor_seconds();
    for (int i = 0; i < repeats; ++i) call();
    return (processor_seconds() - start) * 1e9;
  };
  const double first = std::max(time(1), 1.0);  // also warms up
  const int repeats = std::clamp(static_cast<int>(kLongEnough / first), 1, 1'000'000);
  std::vector<double> found;
  for (int i = 0; i < rounds; ++i) found.push_back(time(repeats) / repeats);
  const auto middle = found.begin() + rounds / 2;
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

void RatioReport::add(const std::string& what, double ns, const std::string& baseline, double baseline_ns,
                      double gate) {
  const double ratio = ns / baseline_ns;
  rows_.push_back({what, duration(ns), fmt::format("{} {}", baseline, duration(baseline_ns)), ratio_text(ratio),
                   gate > 0 ? "<= " + ratio_text(gate) : "", gate <= 0 || ratio <= gate});
}

void RatioReport::add_missing(const std::string& what, const std::string& baseline) {
  rows_.push_back({what, "", baseline + ": not on this machine", "", "", true});
}

void RatioReport::add_count(const std::string& what, double count, const std::string& unit, double baseline_count,
                            const std::string& baseline_unit, double gate) {
  const double ratio = count / baseline_count;
  rows_.push_back({what, fmt::format("{:.0f} {}", count, unit), fmt::format("{:.0f} {}", baseline_count, baseline_unit),
                   ratio_text(ratio), gate > 0 ? "<= " + ratio_text(gate) : "", gate <= 0 || ratio <= gate});
}

void RatioReport::add_factor(const std::string& what, double factor, double gate) {
  rows_.push_back({what, "", "", fmt::format("{:.1f}x", factor), gate > 0 ? fmt::format(">= {:.1f}x", gate) : "",
                   gate <= 0 || factor >= gate});
}

void RatioReport::add_failure(const std::string& what, const std::string& why) {
  rows_.push_back({what, "", why, "", "", false});
}

int RatioReport::finish(const std::string& title) const {
  bool kept = true;
  fmt::print("{}\n  {:<46} {:>10}  {:<42} {:>8}  {:>9}\n", title, "what", "time", "baseline in this run", "ratio",
             "promise");
  for (const auto& row : rows_) {
    fmt::print("  {:<46} {:>10}  {:<42} {:>8}  {:>9}{}\n", row.what, row.figure, row.baseline, row.ratio, row.gate,
               row.kept ? "" : "  MISSED");
    kept = kept && row.kept;
  }
  fmt::print("\n");
  return kept ? 0 : 1;
}

}  // namespace syncline::bench
