// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace syncline::bench {

/// Processor time of the calling thread so far. What others do on the machine at the same time does not count.
[[nodiscard]] double processor_seconds();
/// The same of all threads of the process together.
[[nodiscard]] double all_processor_seconds();

/// Median processor time of one call in nanoseconds: `rounds` rounds, each repeated until it is long enough for
/// the clock.
[[nodiscard]] double median_ns(const std::function<void()>& call, int rounds = 7);

/// Figures against a baseline of the same run, and whether they keep what is promised.
class RatioReport {
 public:
  /// `gate`: the ratio must not be above it; 0 = told only.
  void add(const std::string& what, double ns, const std::string& baseline, double baseline_ns, double gate);
  /// A figure that is a ratio by nature ("times real time"); must not be below `gate`.
  void add_factor(const std::string& what, double factor, double gate);
  /// Things counted against things counted ("183 frames" of "100 slaves").
  void add_count(const std::string& what, double count, const std::string& unit, double baseline_count,
                 const std::string& baseline_unit, double gate);
  /// A figure that could not be taken is a promise not kept.
  void add_failure(const std::string& what, const std::string& why);
  /// A baseline that is not on this machine: told, and nothing is promised.
  void add_missing(const std::string& what, const std::string& baseline);
  /// Prints the table; 0 when every gate is kept.
  [[nodiscard]] int finish(const std::string& title) const;

 private:
  struct Row {
    std::string what, figure, baseline, ratio, gate;
    bool kept = true;
  };
  std::vector<Row> rows_;
};

}  // namespace syncline::bench
