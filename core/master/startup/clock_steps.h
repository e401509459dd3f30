// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "master/clocks/sync_watch.h"
#include "master/startup/slave_commands.h"

namespace syncline {

class Attendance;
class Bus;
class CyclicTaskRunner;
struct DcNetwork;
class DelayCompensation;

/// What the state machine does about distributed clocks between its steps: measures and sets them on the way to PREOP,
/// waits until slaves and master run in step, sees that SYNC signals have started.
class ClockSteps {
 public:
  ClockSteps(Bus& bus, RunState& run, CyclicTaskRunner& task, SyncWatch& sync, DelayCompensation& delays,
             const Attendance& attendance)
      : bus_(bus), run_(run), task_(task), sync_(sync), delays_(delays), attendance_(attendance) {}

  /// Before the first cycle: delays, offsets and drift of the clocks of `present`. True time of the first cycle.
  Result<Nanoseconds> initialise(SlaveList present);
  /// Until the slaves are within the sync window. kDcSetup after 30 s.
  Status await_slaves();
  /// Until the master keeps its distance from them. After 30 s kDcmOutOfLimit, or kDcSetup where something else
  /// than the error stands in the way.
  Status await_master();
  /// Gives clocks to slaves that have come while the others go on.
  Status join(const SlaveList& slaves);
  /// The first error is the result; every one is told.
  Status check_sync_signals(const SlaveList& slaves);
  /// Those of them whose SYNC0 will not come, as it is now.
  Result<SlaveList> without_sync_signals(const SlaveList& slaves);

 private:
  void note(const DcNetwork& network);
  Result<std::vector<DcStartReading>> read_sync_signals(const SlaveList& slaves);
  /// False when it does not within 30 s.
  Result<bool> comes_true(bool (SyncWatch::*in_sync)() const);
  /// Of a slave that was never measured, ns: a usual hop behind the one that it hangs at.
  [[nodiscard]] std::uint32_t estimated_delay(std::size_t slave) const;

  Bus& bus_;
  RunState& run_;
  CyclicTaskRunner& task_;
  SyncWatch& sync_;
  DelayCompensation& delays_;
  const Attendance& attendance_;
};

}  // namespace syncline
