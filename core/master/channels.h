// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "config/network_config.h"
#include "dc/master_verdict.h"
#include "master/bus_scan.h"
#include "master/cyclic_application.h"
#include "master/slave_evidence.h"
#include "protocol/al_state.h"
#include "support/result.h"
#include "support/types.h"

/// The four channels between the background core and whoever looks at it: commands, events,
/// snapshot, samples. Everything crosses by value.
namespace syncline {

// ---- samples: one a cycle -------------------------------------------------------------------

/// One bus cycle, stamped by the cyclic thread. Trivially copyable.
struct CycleSample {
  std::uint64_t cycle = 0;                // counts from going online
  Nanoseconds send_time = 0;              // host clock, just before the frame was handed to the link
  Nanoseconds reference_time = 0;         // system time of the reference clock when the frame passed, 0 = none
  std::int32_t wake_lateness_ns = 0;      // send_time minus the scheduled time
  std::int32_t round_trip_ns = 0;
  std::int32_t dcm_error_ns = 0;          // controller error, raw
  std::int32_t dcm_error_filtered_ns = 0;
  float drift_ppm = 0;                    // host clock against reference clock
  std::int32_t dcm_adjust_ns = 0;         // of the next period, or of what is written to the reference clock
  float dcm_output_sum_ns = 0;            // what the controller has learned, ns a cycle
  std::int64_t dcm_output_total_ns = 0;   // all adjustments since it was started
  std::uint32_t dcm_error_code = 0;       // DCM_E_..., 0 = none
  std::uint32_t deviation_ored_ns = 0;    // magnitude of the wire-ored 0x092C of all clocks
  std::uint32_t deviation_ns = 0;         // of the slaves that follow the reference clock: the or-ed value where it ors
                                          // only them, else the largest of their latest readings
  std::int32_t slave_deviation_ns = 0;    // signed 0x092C of slave_position
  std::uint32_t slave_sm2_missed = 0;     // of sm2_position, see Sm2MissedStatus::total
  std::uint32_t slave_sm2_integrator = 0; // see Sm2MissedStatus::integrator
  std::int16_t slave_position = -1;       // round robin, -1 = none in this cycle
  std::int16_t sm2_position = -1;
  std::uint16_t wkc_expected = 0;         // sum over the process-data commands
  std::uint16_t wkc_received = 0;
  std::uint16_t frames_lost = 0;          // of this cycle: not back at its deadline
  std::uint16_t skipped_cycles = 0;       // left out just before this one: the host came too late for them
  std::int32_t late_by_ns = 0;            // a frame of an earlier cycle came back in this one, so long after its deadline
  enum Flag : std::uint16_t {
    kFrameLost = 1, kWkcError = 2, kDeviationValid = 4, kDcmActive = 8, kDcmInSync = 16,
    kDcInSync = 32, kDcMonitored = 64, kReferenceValid = 128, kOverrun = 256,
    kFrameLate = 512,                     // late_by_ns is valid
    kFollowersRead = 2048,                // deviation_ns is valid
    kSlaveFollows = 1024,                 // slave_position follows the reference clock: what it shows is a deviation
  };
  std::uint16_t flags = 0;
  std::uint8_t master_state = 0;          // AlState
};

/// Single producer, single consumer, power-of-two ring that never blocks the producer: a full ring
/// drops the new sample and counts it.
class SampleRing {
 public:
  explicit SampleRing(std::size_t capacity = 1U << 16);
  bool push(const CycleSample& sample);                    // producer only
  std::size_t pop(std::vector<CycleSample>& out, std::size_t at_most = SIZE_MAX);  // consumer only; appends
  [[nodiscard]] std::uint64_t overruns() const { return overruns_.load(std::memory_order_relaxed); }

 private:
  std::vector<CycleSample> slots_;
  std::size_t mask_;
  std::atomic<std::size_t> head_{0}, tail_{0};
  std::atomic<std::uint64_t> overruns_{0};
};

// ---- snapshot: the latest of everything -------------------------------------------------------

/// kUnknown: was or should be watched, but the readings are too old to say anything.
enum class SyncState : std::uint8_t { kNotMonitored, kNotReady, kBusy, kInSync, kOutOfSync, kUnknown };

/// Missed SM2 events: the slave's counter and where it was read, and what the master makes of it and of what it knows of
/// each cycle (dc/sync_event_account.h).
struct Sm2MissedStatus {
  bool valid = false;                     // the counter was read
  std::uint32_t value = 0;                // as it was read last
  Nanoseconds time = 0;                   // host clock of that reading
  std::uint16_t index = 0x1C32;
  std::uint8_t sub_index = 0;             // 0x0B or 0x0C, by object name or device profile
  std::uint8_t other_sub_index = 0;       // neither says which: the other one of the two, else 0
  std::uint32_t other_value = 0;
  bool known = false;                     // the following count
  std::uint32_t missed = 0;               // since the slave was in OP first
  std::uint32_t computed = 0;             // part of it that the slave did not tell: it fell, or has no counter
  bool at_least = false;
  dc::MissesByCause by_cause{};
  std::uint32_t integrator = 0;           // what 0x10F1 makes of the misses
  std::uint32_t integrator_highest = 0;   // so far
  std::uint32_t limit = 0;                // 0x10F1:02, at which the slave gives up; 0 = never, or not told
  /// What is shown: the followed count, which a fall does not clear, or without one the slave's own.
  [[nodiscard]] std::uint32_t total() const { return known ? missed : value; }
  bool operator==(const Sm2MissedStatus&) const = default;
};

struct SlaveStatus {
  std::uint16_t al_status = 0;            // register 0x0130; 0 = unknown, it does not answer
  std::uint16_t al_status_code = 0;
  bool present = false;                   // answers
  bool cable_broken = false;              // nothing comes back over the cable from the one that it hangs at
  Nanoseconds absent_since = 0;           // host clock; while it does not answer
  bool dc_enabled = false;
  bool is_reference_clock = false;
  bool follows = false;                   // the reference clock: there, with a clock, behind it in frame order
  bool deviation_valid = false;
  std::int32_t deviation_ns = 0;          // signed 0x092C; a deviation from the reference clock when it follows
  Nanoseconds deviation_time = 0;         // host clock of the reading
  std::uint32_t propagation_delay_ns = 0;
  Sm2MissedStatus sm2_missed;
  SlaveEvidence evidence;
  bool operator==(const SlaveStatus&) const = default;
};

struct DcStatus {
  bool enabled = false;
  int reference_clock = -1;               // position
  SyncState state = SyncState::kNotReady; // the verdict on the slaves, see dc/sync_verdict.h; kNotMonitored also while
                                          // nobody follows
  Nanoseconds since = 0;                  // host clock: the state is the same since then
  bool monitored = false;                 // sync-window monitoring configured and at least two DC slaves
  std::uint32_t limit_ns = 0;
  std::uint32_t deviation_ored_ns = 0;    // of all clocks, those in front of the reference clock and itself included
  std::optional<std::uint32_t> deviation_ns;  // largest latest reading of those that follow, monitored or not
  std::uint16_t followers = 0;            // slaves that follow the reference clock
  std::uint16_t over_limit = 0;           // of them, by their own readings
  bool all_alike = false;                 // all of them are, to the same side: the reference clock has moved
  int culprit = -1;                       // else the one furthest over the limit
  Nanoseconds newest_age_ns = -1;         // of the latest own reading of any of them; -1: none yet
  Nanoseconds oldest_age_ns = -1;         // since something was heard of each of them
  std::optional<double> settled_after_ms; // from the first cyclic frame until the settle time began
  Nanoseconds sync_base = 0;              // SYNC0 lies at sync_base + n * cycle + shift in system time
  Nanoseconds start_time = 0;             // system time at which SYNC0 starts, as sent to a slave last; 0 = not yet
  bool operator==(const DcStatus&) const = default;
};

struct DcmStatus {
  DcmMode mode = DcmMode::kOff;
  SyncState state = SyncState::kNotReady;
  std::int32_t error_ns = 0, error_filtered_ns = 0;
  double drift_ppm = 0;
  double error_mean_ns = 0, error_rms_ns = 0;  // since in sync
  std::int32_t error_max_ns = 0;
  std::int32_t frame_error_ns = 0;        // error of the frame: that of the schedule, and how late it was sent
  std::int32_t frame_error_max_ns = 0;    // since in sync
  std::int32_t late_allowed_ns = 0;       // frame error at which a frame meets SYNC0 at the last slave
  std::uint64_t late_sends = 0;           // frames sent later than that
  dc::SyncObstacle obstacle = dc::SyncObstacle::kNone;  // why it is not in sync
  std::optional<double> in_sync_after_ms; // from the first cyclic frame
  std::uint32_t error_code = 0;           // EC-Master DCM codes, 0 = none
  std::int32_t set_value_ns = 0;
  double adjust_permil = 0;               // of the host's timer: applied, or wanted when control is off or by application
  bool control_off = false;               // or left to the application
  bool bus_shift_configured = false;      // the cyclic frames can steer the reference clock
  bool operator==(const DcmStatus&) const = default;
};

/// How this host wakes up, on the real clock.
struct HostStatus {
  Nanoseconds spin = 0;                   // end of each wait that is spent asking the clock, now
  Nanoseconds spin_mean = 0;              // what a cycle has spent so in the mean
  Nanoseconds wake_p50 = 0, wake_p99 = 0; // how late sleeping alone wakes up, of the latest some hundred cycles; 0 not known
  bool operator==(const HostStatus&) const = default;
};

struct Snapshot {
  Nanoseconds time = 0;
  bool online = false;
  bool link_up = false;
  AlState state = AlState::kNone;         // of the master: lowest of all slaves, kNone while one does not answer
  AlState requested = AlState::kNone;
  std::uint64_t cycles = 0;
  std::uint64_t lost_frames = 0;          // not back at their deadline, and not come since
  std::uint64_t late_frames = 0;          // came back after their deadline
  std::uint64_t wkc_errors = 0;
  std::uint64_t overruns = 0;             // times that cycles were left out because the host came too late
  std::uint64_t skipped_cycles = 0;       // cycles left out
  Nanoseconds cycle_time = 0;
  std::vector<SlaveStatus> slaves;        // sized once when a configuration is taken
  DcStatus dc;
  DcmStatus dcm;
  HostStatus host;
};

/// Latest value, lossy: the writer never waits for the reader (it skips publishing when the reader
/// holds the slot). Vectors keep their capacity, so publishing does not allocate.
class SnapshotBox {
 public:
  void publish(const Snapshot& snapshot);                  // cyclic thread
  /// Waits for a reader: for what must not be missed (online, offline), outside the cycle.
  void publish_surely(const Snapshot& snapshot);
  /// Copies the latest snapshot; false when nothing new came since the last call.
  bool read(Snapshot& out);
  /// The last one has been read: somebody is waiting for the next. Cyclic thread.
  [[nodiscard]] bool taken() const { return !fresh_.load(std::memory_order_relaxed); }

 private:
  std::mutex mutex_;  // the writer only try_locks
  Snapshot latest_;
  std::atomic<bool> fresh_{false};  // written with the mutex held
};

// ---- events ---------------------------------------------------------------------------------

enum class EventKind : std::uint8_t {
  kScanProgress,        // a = slaves done, b = slaves found
  kScanFinished,        // scan
  kOnline, kOffline,
  kStateChanged,        // slave (-1 master), a = old AlState, b = new AlState
  kAlStatusError,       // slave, a = AL status, b = AL status code
  kDcInitialised,       // a = number of DC slaves, b = position of the reference clock
  kReferenceClock,      // slave, a = 1 present, 0 lost, 2 took over from the one that was lost, 3 has no system time: the
                        // next one leads in its place
  kDcSlaveSync,         // a = 1 in sync (of a slave: it was away and is again), 0 out of sync, 2 nothing is monitored;
                        // 3 unknown; b = deviation ns (3: age of the oldest reading, ns, 0 when nobody follows); slave = culprit when out, whose
                        // own reading is over the limit, c = number of those; without a culprit they are all
                        // that follow, and over it to the same side: the reference clock has moved
  kDcmSync,             // a = 1 in sync, 0 out of sync, b = error ns (size of the step, when a clock has
                        // stepped), c = dc::SyncObstacle when out
  kDcmError,            // a = DCM error code, b = drift in ppm
  kWkcError,            // a = expected, b = received; repeated ones are counted, c = count
  kFramesLost,          // a = count; each lost frame is in one of these, see MissingFrames
  kFramesLate,          // a = count that came back after its deadline, b = by how much at most, ns; c = those of them that
                        // a kFramesLost had counted before
  kOverrun,             // a = cycles left out, b = longest time without a frame, ns
  kSlaveLost, kSlaveFound,                // its state is unknown from then on, until the kStateChanged that follows
  kEmergency,           // slave, a = error code, b = error register, c = the 5 bytes of data, the first one lowest;
                        // text = the vendor's name of the alarm, where it is known
  kRealTime,            // text: what of SCHED_FIFO, mlock was refused (once)
  kRestarted,           // c: reserved
  kError,               // error
  kEventsLost,          // a = count: the queue was full
  kScanTouchesRunning,  // a = slaves beyond INIT, b = EEPROMs that are taken from their PDIs to be read
  kCable,               // slave and its port a lead to slave b; c = 0 nothing comes back from there, 1 healed
  kWkcExpected,         // a = by the configuration, b = now, without slaves that are lost or below SAFEOP
  kRecovery,            // slave, a = 0 begun, 1 done, 2 failed, 3 given up; b = number of this try
  kUnknownSlave,        // slave = position on the bus, text = identity: it is none of the configuration's
  kHotConnect,          // slave of a group, a = 1 connected, 0 disconnected, 2 not there at the start; text = the group
  kDiagnosis,           // slave: new in its history 0x10F3; a = diag code, b = type (0 info, 1 warning, 2 error) and
                        // text ID in bits 31..16, c = time stamp in ns (DC system time, or since power-on; 0 none)
  kDelayFinding,        // slave, a = dc::DelayWarning, b = its value: what the delay measurement stumbled over
  kPortErrors,          // slave, a = port, b = frames damaged on their way into it, c = links lost, since it was read last
  kWatchdog,            // slave, a = 0 process data, 1 PDI (its firmware is silent); b = how often since it was read last
  kDelaysMeasured,      // while the bus runs: a = slaves whose delay is being corrected, b = largest change in ns
  kLink,                // the master's own adapter, text = link: a = 0 down or gone, 1 up again, b = for how long it was away, ns;
                        // 2 what it ended of a bring-up begins again
  kFirmwareSlow,        // slave, a = 1 begun, 0 over; b of c cycles in which it had renewed no inputs, as it did in every
                        // cycle before; c = 0: b cycles that took longer than the cycle time, by its own counter
};

struct Event {
  EventKind kind = EventKind::kError;
  Nanoseconds time = 0;                   // host clock
  int slave = -1;
  std::int64_t a = 0, b = 0, c = 0;
  std::string text;
  std::optional<Error> error;
  std::shared_ptr<const BusScan> scan;    // kScanFinished
};

/// Bounded; overflow drops the newest and later delivers kEventsLost with the count. The cyclic path
/// uses it only on changes, never each cycle.
class EventQueue {
 public:
  explicit EventQueue(std::size_t capacity = 4096);
  void push(Event event);
  std::vector<Event> drain();

 private:
  std::mutex mutex_;
  std::vector<Event> events_;
  std::size_t capacity_;
  std::uint64_t lost_ = 0;
};

// ---- commands -------------------------------------------------------------------------------

/// `look_only`: see ScanOptions.
struct ScanCommand { bool look_only = false; };
struct GoOnlineCommand { NetworkConfig config; AlState target = AlState::kOp; };
struct GoOfflineCommand {};
struct RequestStateCommand { AlState state = AlState::kInit; };
struct ClearStatisticsCommand {};
/// Parameters of the running master synchronisation; zeros leave what is. The mode cannot change while online: it is
/// part of the cyclic frames. Refused with kError when a parameter is outside its range.
struct ConfigureDcmCommand { DcmSettings settings; };
/// Forgets mean, rms and largest control error, and an error that is over.
struct ResetDcmStatusCommand {};
/// Continuous compensation of the propagation delays, on or off while the bus runs.
struct CompensateDelaysCommand { bool on = false; };
using MasterCommand =
    std::variant<ScanCommand, GoOnlineCommand, GoOfflineCommand, RequestStateCommand, ClearStatisticsCommand,
                 ConfigureDcmCommand, ResetDcmStatusCommand, CompensateDelaysCommand>;

class CommandQueue {
 public:
  void push(MasterCommand command);
  std::optional<MasterCommand> pop();
  [[nodiscard]] bool empty();

 private:
  std::mutex mutex_;
  std::vector<MasterCommand> commands_;
};

struct MasterChannels {
  CommandQueue commands;
  EventQueue events;
  SnapshotBox snapshot;
  SampleRing samples;
  std::atomic<bool> cancel{false};        // ends a scan or a bring-up within a cycle
  /// By how much the application makes the host's timer slower, in thousandths of its rate; holds until it is written
  /// again. In force in the mode master-shift-by-app and with control off. -20..20.
  std::atomic<double> timer_adjust_permil{0};
  std::atomic<CyclicApplication*> application{nullptr};  // none: the outputs stay 0; must outlive the cycles
};

}  // namespace syncline
