// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "channels/event.h"

namespace syncline::cli {

/// Lines of a run's events for people. What happens to many slaves at one time is one line ("slaves 1 to 99: INIT ->
/// PREOP"): for that each line waits until what belongs to it can have come.
class EventLines {
 public:
  using Out = std::function<void(const std::string& line)>;
  /// `folded` false: a line for every event, at once.
  EventLines(Out out, bool folded) : out_(std::move(out)), folded_(folded) {}

  void add(const Event& event);
  /// What nothing can be added to at `now`, by the time of the first event of each. What comes by the thousand is told
  /// together and has the time of its first one (Tally): where a later line is out already, it says "told afterwards".
  void tell_until(Nanoseconds now);
  /// All that is left.
  void tell_all();

 private:
  struct Line {
    Event first;
    std::string rest;         // behind the slave, the same for all; the whole text where it is about no slave
    std::vector<int> slaves;  // none: it is not about slaves
    Nanoseconds last = 0;
  };
  void tell(const Line& line);
  void sort();

  Out out_;
  bool folded_;
  std::vector<Line> lines_;
  Nanoseconds start_ = 0;
  bool started_ = false;
  Nanoseconds told_until_ = INT64_MIN;
};

/// "slave 3", "slaves 1 to 99", "slaves 1, 4 and 7 to 9"; `slaves` in any order.
[[nodiscard]] std::string slaves_text(std::vector<int> slaves);

}  // namespace syncline::cli
