// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "channels/image_contents.h"
#include "master/clocks/clock_amendment.h"
#include "master/clocks/clock_feed.h"
#include "master/clocks/loop_tuning.h"
#include "master/clocks/told_time.h"
#include "master/cyclic/acyclic_scheduler.h"
#include "master/cyclic/bus_health.h"
#include "master/cyclic/cyclic_frame_set.h"
#include "master/cyclic/external_clock_reader.h"
#include "master/cyclic/mailbox_bits.h"
#include "master/cyclic/output_forces.h"
#include "master/cyclic/reference_clock.h"
#include "master/cyclic/slave_watch.h"
#include "master/cyclic/spin_budget.h"
#include "master/cyclic/standstill_cause.h"
#include "master/cyclic/sync_event_watch.h"
#include "master/cyclic/watched_values.h"
#include "master/cyclic/working_counter.h"
#include "master/exchange/bus.h"

namespace syncline {

struct CycleSample;

/// The bus cycle: wakes on its absolute schedule, stamps and sends the cyclic frames and as many acyclic
/// frames as the cycle has room for, collects the answers and hands them to those who watch. In the steady cycle it
/// allocates, locks, logs and throws nothing (the snapshot is only published when nobody reads it just then).
class CyclicTaskRunner final : public CyclePump, private SendStamp {
 public:
  CyclicTaskRunner(FrameExchange& exchange, Clock& clock, RunState& run, SyncWatch& sync);

  /// The next cycle is scheduled for `first_cycle`.
  void start(Nanoseconds first_cycle);
  /// Which cyclic commands are sent: those of this master state.
  void select(AlState state) { frames_.select(state); }
  Status run_cycle(std::span<Datagram* const> acyclic) override;

  [[nodiscard]] SlaveWatch& slaves() { return slaves_; }
  [[nodiscard]] AcyclicScheduler& acyclic() { return acyclic_; }
  [[nodiscard]] WorkingCounter& working_counter() { return working_counter_; }
  [[nodiscard]] CyclicFrameSet& frames() { return frames_; }
  [[nodiscard]] ReferenceClock& reference() { return reference_; }
  [[nodiscard]] ClockFeed& feed() { return feed_; }
  [[nodiscard]] OutputForces& forces() { return forces_; }
  /// What of the process image goes into the samples.
  [[nodiscard]] WatchedValues& watched() { return watched_; }
  /// Expects the working counter of those slaves that are there and exchange process data, and are not about to stop
  /// it. Tells a change.
  void expect_present(std::optional<std::size_t> leaving = std::nullopt);
  [[nodiscard]] Nanoseconds next_cycle() const { return scheduled_; }
  /// No more cycles follow: what has not been told yet.
  void tell_rest();
  /// The snapshot of the latest cycle, unless it has been: somebody may look before the next.
  void publish_latest();

 private:
  void wait_for_slot();
  void publish();
  void stamp(Nanoseconds send_time) override;
  void note_sending(CycleSample& sample);
  void calculate_outputs(const CycleSample& sample);
  void publish_image(std::uint64_t cycle);
  /// See TaskSlots::next().
  [[nodiscard]] std::optional<Nanoseconds> since_base() const;
  void fill_acyclic(std::span<Datagram* const> requests, Nanoseconds now);
  Status exchange_frames(Nanoseconds deadline);
  Status note_link(Status status);
  [[nodiscard]] Nanoseconds cyclic_wire_time();
  /// When the frames of this cycle count as lost.
  [[nodiscard]] Nanoseconds deadline();
  void learn_travel(const PendingFrame& frame);
  void change_way(CycleSample& sample);
  Status send(PendingFrame& frame);
  void evaluate(CycleSample& sample);
  void after_sweep();
  Status amend_clock();
  [[nodiscard]] dc::DcmObservation observation(const CyclicFrameSet::Reading& reading);
  [[nodiscard]] std::optional<Nanoseconds> reference_time(const CyclicFrameSet::Reading& reading) const;
  void finish_sample(CycleSample& sample);

  FrameExchange& exchange_;
  Clock& clock_;
  RunState& run_;
  SyncWatch& sync_;
  CyclicFrameSet frames_;
  OutputForces forces_;
  ImageContents image_;  // published last
  WatchedValues watched_;
  SlaveWatch slaves_;
  MailboxBits mailbox_bits_;
  SyncEventWatch sync_events_;
  AcyclicScheduler acyclic_;
  BusHealth health_;
  WorkingCounter working_counter_;
  LoopTuning tuning_;
  ReferenceClock reference_;
  ClockFeed feed_;
  ClockAmendment amendment_;
  ToldTime told_;
  const PendingFrame* sending_ = nullptr;
  std::uint64_t lost_seen_ = 0;  // lost frames that have been told
  std::uint64_t sweeps_seen_ = 0;
  std::vector<bool> without_;  // slaves that take no part in the process data
  std::vector<PendingFrame*> in_flight_;
  Nanoseconds cycle_time_;
  TaskSlots slots_;
  SpinBudget spin_;  // last part of each wait
  StandstillCause standstill_;
  std::int64_t skipped_ = 0;              // cycles left out before this one
  std::optional<Nanoseconds> last_sent_;  // first frame of the cycle before
  Nanoseconds scheduled_ = 0;
  Nanoseconds send_time_ = 0;               // of this cycle's first frame
  Nanoseconds wire_free_ = 0;               // when the frames that were sent have left
  Nanoseconds travel_ = 0;                  // a frame's way through the segment and back, without its length
  Nanoseconds stamp_doubt_ = 0;             // by how much the last frame came back later than that
  std::optional<Nanoseconds> first_stamp_;  // of that frame, from before it was sent
  Nanoseconds amendment_stamp_ = 0;
  bool steering_ = false;
  Nanoseconds last_published_ = 0;
  Nanoseconds adjust_ = 0;
  std::optional<ExternalClockReader> external_clock_;
};

}  // namespace syncline
