// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/values/sync_obstacle.h"
#include "protocol/al_state.h"
#include "support/types.h"
#include "trace/held_frames.h"
#include "trace/histogram.h"

/// When what happened in a run: spells of disturbances, and what each slave went through. Host times.
namespace syncline {

struct CycleSample;
struct Event;
struct NetworkConfig;
struct Snapshot;

struct Spell {
  Nanoseconds from = 0, to = 0;
  std::uint64_t count = 0;
  std::int64_t largest = 0;
};

/// Disturbances of one kind. What follows within the gap belongs to the same spell; of more than kMost spells the last
/// one takes the rest, so that days of trouble cost no more memory.
class Spells {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr Nanoseconds kGap = 200 * kMillisecond;
  void note(Nanoseconds time, std::uint64_t count, std::int64_t size = 0, Nanoseconds from = 0);
  /// So many of the latest turned out to be none.
  void take_back(std::uint64_t count);
  [[nodiscard]] bool empty() const { return spells_.empty(); }
  [[nodiscard]] const std::vector<Spell>& list() const { return spells_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::int64_t largest() const { return largest_; }
  [[nodiscard]] Nanoseconds first() const { return spells_.empty() ? 0 : spells_.front().from; }
  [[nodiscard]] Nanoseconds last() const { return spells_.empty() ? 0 : spells_.back().to; }
  /// One of them lies within `margin` of the spell.
  [[nodiscard]] bool near(const Spell& spell, Nanoseconds margin) const;

 private:
  std::vector<Spell> spells_;
  std::uint64_t count_ = 0;
  std::int64_t largest_ = 0;
};

/// Somebody left a sync window and, perhaps, came back.
struct SyncLoss {
  Nanoseconds time = 0;
  int slave = -1;
  std::int64_t size = 0;
  dc::SyncObstacle obstacle =
      dc::SyncObstacle::kNone;  // of the master's losses; kClockStep of the slaves': all at once and to the same side
  std::optional<Nanoseconds> back;
  Nanoseconds held = 0;  // frames in the 0.4 s before were held up on their way by so much, all together
};

struct RunHistory {
  struct Fall {
    Nanoseconds time = 0;
    std::uint16_t al_status = 0, al_status_code = 0;
  };
  static constexpr std::size_t kMostFalls = 16;
  /// Went down without an error and without being asked.
  struct Unasked {
    Nanoseconds time = 0;
    AlState from = AlState::kNone, to = AlState::kNone;
  };
  struct Cable {
    int near = -1, port = 0;
  };
  struct DelayTrouble {
    Nanoseconds time = 0;
    Nanoseconds measured = 0;  // the way from the slave before it
  };
  struct Slave {
    Spells absences;  // count 1 each; the last one may last. Of a hot-connect group: not connected
    bool absent = false;
    Spells restarts;                                // found in INIT behind an absence: it had been without power
    std::optional<Cable> cable;                     // over which nothing comes back, as told last
    std::optional<Fall> fall;                       // the last AL status error
    std::vector<Fall> falls;                        // those out of OP, or of nobody knows what; the first kMostFalls
    std::optional<Nanoseconds> left_op;             // the last time, or that its state became known again
    std::optional<Unasked> unasked;                 // the first time
    std::optional<DelayTrouble> delay;              // what the last measurement of its propagation delay stumbled over
    std::optional<std::uint16_t> emergency;         // the last error code (0x603F)
    std::array<Spells, 4> port_errors, lost_links;  // when they were read
    std::array<Spells, 4> damage;                   // from the reading before, within which frames were damaged
    Spells unprocessed;                             // frames that its processing unit could not use (0x030C)
    Spells recoveries;                              // tries to lead it up again
    Spells process_data_watchdog, pdi_watchdog;
    Spells pdi_silent;  // the PDI watchdog's status said so, as long as it did; no counts
    Spells outputs_exceeded, inputs_exceeded;
    /// Times in which it did not renew its inputs, or take its outputs, as before; count 1 each, the last one may last.
    Spells late_inputs, late_outputs;
    std::uint32_t mailbox_silences = 0;          // most requests in a row without an answer
    Nanoseconds silent_from = 0, silent_to = 0;  // within these times; host clock
    Spells missed, shift_too_short;              // SM2 events; outputs too late for SYNC0 (0x1C32:0D)
    Spells off;                     // its own deviation over the limit after it had been within; size in ns
    std::int32_t first_off_ns = 0;  // the first of these, signed
    bool was_near = false;
  };
  using SyncLoss = syncline::SyncLoss;

  Nanoseconds begin = 0, end = 0;  // first event, newest sample or snapshot
  Spells link_outages;             // of the master's own adapter; count 1 each, size in ns; the last one may last
  bool link_down = false;
  std::string link;  // its name, once it was away
  bool reached_op = false;
  Nanoseconds op_reached = 0;  // the first time
  bool operated = false;       // the way there is over: in OP, or as far as the slaves came
  Spells lost_frames, late_frames, stalls, wrong_counters;  // stalls: cycles left out, size = standstill ns
  Spells lead_changes;                  // another one leads than before, or the reference clock again
  Nanoseconds largest_stamp_doubt = 0;  // in operation: CycleSample::stamp_doubt_ns, by which stamps may be wrong
  Spells held_frames;                   // came back so much later than usual, size in ns
  std::uint16_t counter_expected = 0, counter_received = 0;  // of the last wrong one
  struct WayChange {
    Nanoseconds time = 0;
    int slave = -1;                      // that went or came back
    std::int64_t deviation = 0;          // of those behind it, ns
    std::optional<Nanoseconds> renewed;  // when delays were measured anew
  };
  std::vector<WayChange> way_changes;                 // the first kMostLosses
  std::vector<SyncLoss> slave_losses, master_losses;  // while operated, the first kMostLosses
  std::vector<Slave> slaves;
  /// How much later than nominal the frame passed the reference clock, ns; in SAFEOP and OP, once OP was reached.
  Histogram frame_lateness;
};

/// Fills a RunHistory; feed it everything that is drained, samples before the snapshot that came with them.
class HistoryRecorder {
 public:
  explicit HistoryRecorder(const NetworkConfig& config);
  void add(std::span<const CycleSample> samples);
  void add(const Event& event);
  void add(const Snapshot& snapshot);
  [[nodiscard]] const RunHistory& history() const { return history_; }

 private:
  void add(const CycleSample& sample);
  void add_deviation(const CycleSample& sample);
  void add_arrival(const CycleSample& sample);
  void add_missed(const CycleSample& sample);
  void add_loss(std::vector<RunHistory::SyncLoss>& losses, const RunHistory::SyncLoss& loss) const;
  RunHistory::Slave* slave_at(int position);

  struct OfRun;
  struct OfSlave;

  RunHistory history_;
  std::int64_t limit_ns_;
  Nanoseconds cycle_, base_ = 0, set_value_ = 0;
  bool grid_known_ = false;
  std::vector<std::array<std::uint32_t, 4>> counts_;  // totals of the sync objects and of 0x030C, seen last
  std::vector<std::uint32_t> missed_;                 // SM2 events, as told last
  std::optional<Nanoseconds> last_send_;
  std::uint64_t late_frames_ = 0;  // seen last
  HeldFrames held_frames_;
};

}  // namespace syncline
