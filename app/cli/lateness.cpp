// SPDX-License-Identifier: Apache-2.0
#include "app/cli/lateness.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>

#include "channels/cycle_sample.h"
#include "support/counted.h"
#include "trace/sending_time.h"

namespace syncline::cli {
namespace {

Json or_null(Nanoseconds value) { return value == 0 ? Json(nullptr) : Json(value); }

double process_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Json holder_json(const ProcessorHolder& holder) {
  if (!holder.known()) return nullptr;
  return {{"thread", holder.name_text()},
          {"kernel", holder.kernel},
          {"at_a_time_ns", holder.at_a_time},
          {"times", holder.times}};
}

}  // namespace

LatenessReport::LatenessReport() : cpu_at_start_(process_seconds()) {}

void LatenessReport::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) {
    ++cycles_;
    if ((sample.flags & CycleSample::kOverrun) != 0) ++overruns_;
    if (!sending_time_matters(sample)) continue;
    histogram_.add(sample.wake_lateness_ns);
  }
}

double LatenessReport::cpu_us_per_cycle() const {
  return cycles_ == 0 ? 0 : (process_seconds() - cpu_at_start_) * 1e6 / static_cast<double>(cycles_);
}

Json LatenessReport::json() const {
  const auto measured = [this](std::int64_t value) { return histogram_.count() == 0 ? Json(nullptr) : Json(value); };
  return {{"cycles", histogram_.count()},
          {"p50_ns", measured(histogram_.percentile(0.5))},
          {"p90_ns", measured(histogram_.percentile(0.9))},
          {"p99_ns", measured(histogram_.percentile(0.99))},
          {"p99_9_ns", measured(histogram_.percentile(0.999))},
          {"max_ns", measured(histogram_.max())},
          {"sleep_alone_p50_ns", or_null(host_.wake_p50)},
          {"sleep_alone_p99_ns", or_null(host_.wake_p99)},
          {"spin_ns", host_.spin},
          {"spin_ns_per_cycle", host_.spin_mean},
          {"held_ns", host_.held},
          {"held_by_others_ns", host_.held_by_others ? Json(*host_.held_by_others) : Json(nullptr)},
          {"longest_holder", holder_json(host_.holder)},
          {"overruns", overruns_},
          {"cpu_us_per_cycle", static_cast<double>(static_cast<std::int64_t>(cpu_us_per_cycle() * 1000)) / 1000}};
}

std::string LatenessReport::text() const {
  std::string text;
  const auto out = std::back_inserter(text);
  const auto us = [this](double fraction) {
    return histogram_.count() == 0 ? "-"
                                   : fmt::format("{:.3f}", static_cast<double>(histogram_.percentile(fraction)) / 1000);
  };
  fmt::format_to(
      out,
      "lateness of {} with clock control or process data: p50 {}  p90 {}  p99 {}  p99.9 {} us   overruns {}   "
      "processor {:.1f} us a cycle (whole process)\n",
      counted(histogram_.count(), "cycle"), us(0.5), us(0.9), us(0.99), us(0.999), overruns_, cpu_us_per_cycle());
  if (host_.wake_p50 > 0) {
    const auto in_us = [](Nanoseconds value) { return static_cast<double>(value) / 1000; };
    fmt::format_to(
        out,
        "sleeping alone wakes up p50 {:.1f}  p99 {:.1f} us late; asking the clock for the last {:.1f} us of each "
        "wait costs {:.1f} us of processor a cycle and takes that off all but the latest\n",
        in_us(host_.wake_p50), in_us(host_.wake_p99), in_us(host_.spin), in_us(host_.spin_mean));
  }
  std::map<int, std::uint64_t> octaves;  // exponent: below 2^exponent ns
  for (const auto& bin : histogram_.bins()) {
    octaves[static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(bin.low, 0))))] +=
        bin.count;
  }
  for (const auto& [exponent, count] : octaves) {
    const auto share = static_cast<double>(count) / static_cast<double>(histogram_.count());
    fmt::format_to(out, "  below {:>12.3f} us {:>10} {:>9.4f} % {}\n",
                   static_cast<double>(std::uint64_t{1} << exponent) / 1000, count, share * 100,
                   std::string(static_cast<std::size_t>(share * 50), '#'));
  }
  return text;
}

}  // namespace syncline::cli
