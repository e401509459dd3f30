// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>

namespace syncline {

struct ProcessorHolder;

/// How long after one search the next one may come, ms: `period` after one that told something new; twice as long as
/// before, up to 32 periods, where the answer was the same again. A search reads some files of each thread of the host
/// (about 3 ms of another processor among a hundred threads), and a host that stands still every second would pay for
/// it every second.
[[nodiscard]] std::chrono::milliseconds next_search_after(std::chrono::milliseconds last, bool told_something_new,
                                                          std::chrono::milliseconds period);

/// Looks for whom the cyclic thread had to wait although it has real-time priority. A thread of its own without
/// priority counts when it begins and, at most once a period, after a standstill (next_search_after); a run without one
/// costs nothing more.
class StandstillSearch {
 public:
  struct Options {
    int priority = 0;  // of the cyclic thread
    std::chrono::milliseconds period{1000};
    std::filesystem::path proc = "/proc";
  };
  explicit StandstillSearch(Options options);
  ~StandstillSearch();
  StandstillSearch(const StandstillSearch&) = delete;
  StandstillSearch& operator=(const StandstillSearch&) = delete;

  /// Cyclic thread; neither waits.
  void note_standstill();
  /// True when `holder` is newer than what was read last.
  bool read(ProcessorHolder& holder);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline
