// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "config/dcm_settings.h"
#include "dc/dcm/dcm_controller.h"
#include "support/clock.h"
#include "support/jitter_profile.h"
#include "support/random.h"

namespace syncline::dc {

/// Clock of an ESC with its time control loop, in floating point (ESC data sheet I, 9.1.4, with the
/// filters as they are usually reconstructed). Independent of the simulator on purpose: tests that used
/// its loop would not notice when both are wrong.
class EscClock {
 public:
  /// `ppm`: of the quartz, against the host's clock. `depth`: messages over which the differences are averaged
  /// (0x0934).
  explicit EscClock(double ppm, double depth = 16) : ppm_(ppm), depth_(depth) {}
  void advance(double ns) { time_ = time_after(ns); }
  /// One time written to 0x0910.
  void receive(double local_minus_received);
  /// As after a burst: the loop holds `share` of the rate that makes the clock run `ppm` against the host.
  void learn(double ppm, double share);
  void step(double ns) { time_ += ns; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double time_after(double ns) const;
  [[nodiscard]] double deviation() const { return mean_; }  // 0x092C, ns

 private:
  double ppm_, depth_, time_ = 0, mean_ = 0, period_deviation_ = 0;
  std::int32_t diff_ = 0;
};

[[nodiscard]] inline DcmSettings settings_for(DcmMode mode) {
  DcmSettings settings;
  settings.mode = mode;
  return settings;
}

/// What the plant is made of. The host's clock is the true time, so `reference_ppm` is what the DCM has to
/// balance.
struct PlantOptions {
  DcmMode mode = DcmMode::kMasterShift;
  DcmSettings settings{};
  Nanoseconds cycle = kMillisecond;
  Nanoseconds set_value = 666'667;
  double reference_ppm = 50;
  std::vector<double> slave_ppm{80, -40};
  double learned_share = 1;  // of their drift, that a burst has taught the clocks before
  double start_error = 0;    // of the first frame in the SYNC grid, ns
  JitterProfile jitter{};
  double stamp_noise = 0;       // sigma of the host's send stamp, ns
  double send_delay = 0;        // sigma of the one-sided normal time from the stamp to the wire, ns
  QuantileCurve stamp_error{};  // ... and as measured, with its tails
  struct {
    int cycle = -1;
    double ns = 0;
  } clock_step{};  // of the reference clock and all that follow it
  /// Another controller than the mode's own.
  std::function<std::unique_ptr<DcmController>()> controller{};
  std::uint64_t seed = 1;
  std::function<bool(int)> lost = [](int) { return false; };
  std::function<double(int)> late = [](int) { return 0.0; };  // ns, of a single cycle
};

struct PlantCycle {
  double time = 0;         // s
  double grid_error = 0;   // the schedule against the SYNC grid, truth, ns
  double jitter = 0;       // how late the frame left, ns
  double slave_error = 0;  // worst slave against the reference clock, truth, ns
  double deviation = 0;    // worst 0x092C, ns
  DcmState state;
};

/// A host that sends cyclic frames late by its jitter, a reference clock, and slaves behind it.
class DcmPlant {
 public:
  explicit DcmPlant(PlantOptions options);

  /// Runs until `seconds` from the start.
  void run_until(double seconds);

  /// First cycle in sync, s; infinity when never.
  [[nodiscard]] double in_sync_at() const;
  [[nodiscard]] int times_lost() const;
  [[nodiscard]] bool reported(std::uint32_t error_code) const;
  using Field = double PlantCycle::*;
  static constexpr double kEnd = std::numeric_limits<double>::infinity();
  [[nodiscard]] double worst(Field field, double from, double to = kEnd) const;
  [[nodiscard]] double rms(Field field, double from, double to = kEnd) const;
  [[nodiscard]] double mean(Field field, double from, double to = kEnd) const;
  [[nodiscard]] const PlantCycle& last() const { return cycles_.back(); }
  [[nodiscard]] const std::vector<PlantCycle>& cycles() const { return cycles_; }

 private:
  void cycle();
  void advance_to(double host_time);
  [[nodiscard]] double draw_jitter();
  [[nodiscard]] double draw_stamp_error();
  void write_again();

  PlantOptions options_;
  Random random_;
  std::unique_ptr<DcmController> controller_;
  EscClock reference_;
  std::vector<EscClock> slaves_;
  Nanoseconds schedule_ = 0;
  double now_ = 0;
  int count_ = 0;
  std::vector<PlantCycle> cycles_;
};

}  // namespace syncline::dc
