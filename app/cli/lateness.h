// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/cli/json.h"
#include "channels/host_status.h"
#include "trace/histogram.h"

namespace syncline {
struct CycleSample;
}  // namespace syncline

namespace syncline::cli {

/// How late the cyclic thread sent, over all cycles where sending_time_matters(), and what the process cost.
class LatenessReport {
 public:
  LatenessReport();
  void add(std::span<const CycleSample> samples);
  /// What waiting costs on this host, and what it brings.
  void note(const HostStatus& host) { host_ = host; }
  [[nodiscard]] Json json() const;
  /// Percentiles and one line a power of two.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] double cpu_us_per_cycle() const;

  Histogram histogram_;
  HostStatus host_;
  std::uint64_t cycles_ = 0, overruns_ = 0;
  double cpu_at_start_ = 0;  // seconds of the process
};

}  // namespace syncline::cli
