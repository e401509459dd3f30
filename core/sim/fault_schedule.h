// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "config/sim_config.h"
#include "sim/device.h"
#include "sim/esc.h"
#include "sim/line_faults.h"

namespace syncline::sim {

/// What faults and pulses act upon. A slave that is switched on is a new one: nobody keeps its ESC or its device.
class FaultTarget {
 public:
  virtual ~FaultTarget() = default;
  virtual LineFaults& lines() = 0;
  virtual Esc& esc(std::size_t slave) = 0;
  virtual Device& device(std::size_t slave) = 0;
  virtual void set_cable(std::size_t slave, bool plugged) = 0;
  virtual void set_power(std::size_t slave, bool on, Nanoseconds time) = 0;
};

/// What a scenario does to a segment: its faults, and the pulses at latch inputs, in order of time.
class FaultSchedule {
 public:
  /// Times of the scenario count from `start`. The target must outlive it.
  FaultSchedule(const SimConfig& config, Nanoseconds start, FaultTarget& target);
  /// Does what is due up to `time`.
  void run(Nanoseconds time) {
    while (next_ < actions_.size() && actions_[next_].time <= time) actions_[next_++].apply();
  }

 private:
  struct Action {
    Nanoseconds time = 0;
    std::function<void()> apply;
  };
  /// At the fault's time; where it has an end, `undo` then.
  void add(const FaultConfig& fault, std::function<void()> apply, std::function<void()> undo = {});
  void add_fault(const FaultConfig& fault);
  void add_line_fault(const FaultConfig& fault);
  void add_pulses(const LatchPulses& pulses);

  FaultTarget& target_;
  Nanoseconds start_;
  std::vector<Action> actions_;
  std::size_t next_ = 0;
};

}  // namespace syncline::sim
