// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "sim/segment/segment.h"
#include "support/types.h"

namespace syncline {
struct FaultConfig;
struct LatchPulses;
struct SimConfig;
}  // namespace syncline

namespace syncline::sim {

class Device;
class Esc;
class LineFaults;

/// What faults and pulses act upon. A slave that is switched on is a new one: nobody keeps its ESC or its device.
class FaultTarget {
 public:
  virtual ~FaultTarget() = default;
  virtual LineFaults& lines() = 0;
  virtual Esc& esc(std::size_t slave) = 0;
  virtual Device& device(std::size_t slave) = 0;
  virtual void set_cable(std::size_t slave, bool plugged) = 0;
  virtual void set_power(std::size_t slave, bool on, Nanoseconds time) = 0;
  /// The cable to the parent goes to `port`, and what was there to where it was.
  virtual void reverse_cable(std::size_t slave, std::uint8_t port) = 0;
  virtual void close_ring(const std::optional<Wiring::Ring>& ring) = 0;
  virtual void foreign_frame(Nanoseconds time) = 0;
};

/// What a scenario does to a segment: its faults, and the pulses at latch inputs, in order of time.
class FaultSchedule {
 public:
  /// Times of the scenario count from `start`. The target must outlive it.
  FaultSchedule(const SimConfig& config, Nanoseconds start, FaultTarget& target);
  /// Does what is due up to `time`.
  void run(Nanoseconds time) {
    if (time >= due_) run_due(time);
  }
  /// The slave is a new one: what was wrong with the one before is wrong with it too, unless switching it off mends
  /// that.
  void started_anew(std::size_t slave);

 private:
  using Act = std::function<void()>;
  struct Action {
    Nanoseconds time = 0;
    Act act;
  };
  struct Repeated {
    Nanoseconds next = 0, period = 0, end = 0;
    std::function<void(Nanoseconds)> act;
  };
  struct Lasting {
    std::size_t fault = 0, slave = 0;
    Act act;
  };
  /// At the fault's time; where it has an end, `undo` then.
  void add(const FaultConfig& fault, Act apply, Act undo = {});
  /// The same, of something that a new slave has too.
  void add_lasting(const FaultConfig& fault, std::size_t slave, const Act& apply, const Act& undo);
  void add_repeated(const FaultConfig& fault, std::uint32_t count, std::function<void(Nanoseconds)> act);
  void add_fault(const FaultConfig& fault);
  void add_line_fault(const FaultConfig& fault);
  void add_wiring_fault(const FaultConfig& fault, std::uint8_t entry_port);
  void add_clock_fault(const FaultConfig& fault, std::size_t slave);
  void add_firmware_fault(const FaultConfig& fault);
  void add_noisy_delay(const FaultConfig& fault);
  void add_pulses(const LatchPulses& pulses);
  void add_foreign_frames(double per_second);
  void run_due(Nanoseconds time);
  void skip_long_ago(Nanoseconds time);

  FaultTarget& target_;
  Nanoseconds start_;
  std::uint64_t seed_;
  std::vector<Action> actions_;
  std::vector<Repeated> repeated_;
  std::vector<Lasting> lasting_;
  std::size_t next_ = 0, faults_ = 0;
  Nanoseconds due_ = INT64_MIN;
};

}  // namespace syncline::sim
