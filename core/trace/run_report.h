// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/host_status.h"
#include "channels/slave_evidence.h"
#include "channels/slave_status.h"
#include "channels/snapshot.h"
#include "config/identity.h"
#include "protocol/al_state.h"
#include "trace/histogram.h"
#include "trace/run_history.h"
#include "trace/statistics.h"

namespace syncline {

struct CycleSample;
struct Event;
struct NetworkConfig;
struct Snapshot;

/// What a run showed, as `synclinectl run` reports it. Times in ms from the first cyclic frame,
/// deviations and errors in ns.
struct RunReport {
  struct Slave {
    std::uint16_t position = 0;
    std::string name;
    bool present = false;          // answers at the end; if not, its state is unknown
    bool cable_broken = false;     // see SlaveStatus
    Nanoseconds absent_since = 0;  // host clock; while it does not answer
    std::uint16_t al_status = 0;   // 0 = unknown
    std::uint16_t al_status_code = 0;
    Nanoseconds al_status_time = 0;  // host clock of the newest reading of both; 0: unknown
    /// From the reference clock; nothing for itself, and for slaves that do not follow it.
    std::optional<std::int32_t> deviation_ns;      // latest reading
    Nanoseconds deviation_time = 0;                // host clock of that; 0: none
    std::optional<std::int32_t> deviation_max_ns;  // largest magnitude after settling, in sync or not
    Statistics deviation;                          // ns, of every reading after settling
    std::optional<Sm2MissedStatus> sm2_missed;
    std::optional<std::uint32_t> propagation_delay_ns;
    SlaveEvidence evidence;
    // out of the configuration
    Identity identity;
    bool optional = false;                         // of a hot-connect group: may be absent with its head
    int group_head = -1;                           // of that group
    int parent = -1, parent_port = 0;              // whom it is wired to, and by which of its ports; -1: the host
    std::optional<Nanoseconds> sync0_margin;       // from its outputs' nominal arrival to SYNC0; nothing without SYNC0
    Nanoseconds sync0_shift = 0, sync0_cycle = 0;  // ns; cycle 0: no SYNC0
    Nanoseconds outputs_wire_time = 0;             // see config/frame_time.h
  };
  AlState state = AlState::kNone;  // of the master, see Snapshot::state
  Nanoseconds time = 0;            // host clock, at the end
  Nanoseconds cycle_time = 0;
  Nanoseconds wire_time = 0, first_wire_time = 0;  // of the base task's frames, and of the first of them
  std::optional<Nanoseconds> round_trip;  // of the first frame, the shortest; nothing when none came back in time
  std::uint64_t cycles = 0, wkc_errors = 0;
  std::uint64_t lost_frames = 0, late_frames = 0, overruns = 0, skipped_cycles = 0;
  std::vector<Slave> slaves;
  DcStatus dc;
  std::optional<std::int32_t> deviation_max_ns;  // over all slaves that follow, after settling
  DcmStatus dcm;
  bool sync_window_enabled = false;  // configured
  Statistics dcm_error;              // ns, of the cycles that read the reference clock since the master came in sync
  Statistics lateness;               // ns, every cycle
  Histogram lateness_histogram;      // where sending_time_matters()
  RunHistory history;
  Nanoseconds told_from = 0;  // host clock: from here on findings count their moments; 0: from history.begin on
  HostStatus host;
};

/// Collects while a run goes on; feed everything that is drained, the samples before the snapshot that came with them.
class RunRecorder {
 public:
  explicit RunRecorder(const NetworkConfig& config);
  void add(std::span<const CycleSample> samples);
  void add(const Event& event);
  void add(const Snapshot& snapshot);
  [[nodiscard]] RunReport finish(const Snapshot& snapshot) const;

 private:
  struct SlaveReadings {
    std::optional<std::int32_t> latest;
    Nanoseconds latest_time = 0;
    std::optional<std::int32_t> max;
    Statistics settled;
  };
  void note_settled(const CycleSample& sample);
  [[nodiscard]] static RunReport::Slave configured(const NetworkConfig& config, std::size_t position);

  std::vector<RunReport::Slave> configured_;  // what the configuration says of each slave
  bool sync_window_enabled_;
  Nanoseconds wire_time_ = 0, first_wire_time_ = 0;
  std::optional<Nanoseconds> round_trip_;
  std::vector<SlaveReadings> readings_;
  Statistics dcm_error_, lateness_;
  Histogram lateness_histogram_;
  HistoryRecorder history_;
  bool settled_ = false, master_settled_ = false;
};

}  // namespace syncline
