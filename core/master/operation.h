// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <utility>

#include "config/network_config.h"
#include "master/clocks/delay_compensation.h"
#include "master/clocks/sync_watch.h"
#include "master/cyclic/cyclic_task.h"
#include "master/exchange/bus.h"
#include "master/exchange/run_state.h"
#include "master/recovery/delay_renewal.h"
#include "master/recovery/recovery.h"
#include "master/startup/esm.h"
#include "master/startup/history_collector.h"

namespace syncline {

struct ForceOutputCommand;
struct MasterChannels;
struct ReleaseOutputCommand;

/// One time of being online with one configuration, from the first frame to the last.
class Operation {
 public:
  Operation(NetworkConfig config, FrameExchange& exchange, Clock& clock, MasterChannels& channels);
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  /// Takes the bus from whatever it does to `target`. On failure cyclic() says whether the bus is still
  /// operated (and can be looked at), or was never.
  Status start(AlState target);
  Status change_to(AlState target);
  /// INIT, and no frames afterwards. Cannot be cancelled.
  void stop();
  [[nodiscard]] bool cyclic() const { return bus_.cyclic(); }
  /// One bus cycle; when there is something to do, also the recovery of slaves, delays that are measured anew and the
  /// reading of diagnosis histories, which take many cycles.
  Status run_cycle();
  /// While there are no cycles: a datagram of a request on a slave, or its state. False when there was nothing to do.
  Result<bool> run_requests();
  /// For those who look when the caller has got control back.
  void publish_latest() {
    if (cyclic()) task_.publish_latest();
  }
  void clear_statistics();
  Status configure_dcm(const DcmSettings& change);
  void reset_dcm_status() { sync_.clear_statistics(); }
  Status force(const ForceOutputCommand& wanted);
  Status release(const ReleaseOutputCommand& wanted);
  void release_all_outputs();
  void watch(const WatchCommand& command) { task_.watched().watch(command); }
  /// Continuous compensation of the propagation delays.
  void compensate_delays(bool on);
  void set_start_time(DcStartTimeCallback callback) { sync_.set_start_time(std::move(callback)); }
  [[nodiscard]] RunState& run() { return run_; }

 private:
  Status check() const;
  Status bring_up(AlState target);
  Status lead_to(AlState target);
  Status through_outages(AlState target, const std::function<Status(bool again)>& lead);
  bool lost_its_ground(const Status& status);
  Status see_whether_reached(AlState target);
  bool await_link();
  Status note_learned_rate();
  bool serve_state_request();
  void end_requests();
  void tell_forced();
  void tell_whether_it_runs();
  void tell_left_behind(const Error& why);

  NetworkConfig config_;
  FrameExchange& exchange_;
  Clock& clock_;
  Bus bus_;
  RunState run_;
  SyncWatch sync_;
  CyclicTaskRunner task_;
  DelayCompensation delays_;
  Esm esm_;
  Recovery recovery_;
  DelayRenewal renewal_;
  HistoryCollector history_;
  bool unasked_ = false;  // at work on its own account: a command of the user comes first
};

}  // namespace syncline
