// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "master/clocks/dc_start.h"
#include "support/types.h"

namespace syncline {

class Clock;
class Link;
struct MasterChannels;

/// While no frames are to be sent.
inline constexpr Nanoseconds kIdlePeriod = 1 * kMillisecond;

/// The background core: executes commands from the channels on a link and a clock. Whoever calls
/// step() is its thread: MasterThread on the real clock, the caller itself on the virtual clock
/// (then everything is deterministic and nothing sleeps).
class MasterService {
 public:
  /// The clock must outlive the service; the link is owned.
  MasterService(std::unique_ptr<Link> link, Clock& clock);
  ~MasterService();

  [[nodiscard]] MasterChannels& channels();
  [[nodiscard]] Clock& clock();
  [[nodiscard]] const Link& link() const;

  /// Who calculates the start times of the SYNC signals instead of the master, from the next time of going online.
  /// Called in the thread that runs the cycle. Before that thread is started.
  void set_dc_start_time(DcStartTimeCallback callback);

  /// Takes one command (a bring-up or a scan runs to its end, cycles go on meanwhile and the
  /// channels are fed), or runs one bus cycle when online. False when there was nothing to do.
  bool step();
  /// step() until the clock has passed `duration`; for the virtual clock.
  void run_for(Nanoseconds duration);
  [[nodiscard]] bool online() const;
  /// Takes the slaves to INIT if the bus is online. Whatever ends the program's way, an exception too, the slaves must
  /// not stay in OP: MasterThread does it at its end, who calls step() himself has to.
  void shut_down() noexcept;
  /// step() for a thread that nothing may end: what it throws becomes an event, and the bus is taken down.
  bool step_guarded() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Runs a MasterService in a thread of its own: SCHED_FIFO, locked memory, prefaulted stack where
/// permitted; what is refused is told once by events::RealTimeRefused. stop() joins.
class MasterThread {
 public:
  explicit MasterThread(MasterService& service);
  ~MasterThread();
  MasterThread(const MasterThread&) = delete;
  MasterThread& operator=(const MasterThread&) = delete;
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline
