// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/network_config.h"
#include "master/channels.h"
#include "trace/statistics.h"

namespace syncline {

/// What a run showed, as `synclinectl run` reports it. Times in ms from the first cyclic frame,
/// deviations and errors in ns.
struct RunReport {
  struct Slave {
    std::uint16_t position = 0;
    std::string name;
    std::uint16_t al_status = 0;
    std::uint16_t al_status_code = 0;
    /// From the reference clock; nothing for itself, and for slaves that do not follow it.
    std::optional<std::int32_t> deviation_ns;        // latest reading
    std::optional<std::int32_t> deviation_max_ns;    // largest magnitude after settling, in sync or not
    std::optional<Sm2MissedStatus> sm2_missed;
    std::optional<std::uint32_t> propagation_delay_ns;
  };
  AlState state = AlState::kNone;
  Nanoseconds time = 0;                              // host clock, at the end
  Nanoseconds cycle_time = 0;
  std::uint64_t cycles = 0, wkc_errors = 0;
  std::uint64_t lost_frames = 0, late_frames = 0, overruns = 0, skipped_cycles = 0;
  std::vector<Slave> slaves;
  DcStatus dc;
  std::optional<std::int32_t> deviation_max_ns;      // over all slaves that follow, after settling
  DcmStatus dcm;
  Statistics lateness;                               // ns, every cycle
};

/// Collects while a run goes on; feed every sample that is drained.
class RunRecorder {
 public:
  explicit RunRecorder(const NetworkConfig& config);
  void add(std::span<const CycleSample> samples);
  [[nodiscard]] RunReport finish(const Snapshot& snapshot) const;

 private:
  struct SlaveReadings {
    std::optional<std::int32_t> latest;
    std::optional<std::int32_t> max;
  };
  void note_settled(const CycleSample& sample);

  std::vector<std::string> names_;
  std::vector<SlaveReadings> readings_;
  Statistics lateness_;
  bool settled_ = false;
};

}  // namespace syncline
