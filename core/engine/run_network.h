// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/slave_request.h"
#include "support/result.h"
#include "trace/run_report.h"

namespace syncline {

struct Event;
struct MasterChannels;
struct NetworkConfig;
struct OpenedLink;
struct SlaveAnswer;
struct Snapshot;

struct RunRequest {
  AlState target = AlState::kOp;
  Nanoseconds duration = 10 * kSecond;      // from the start of the bring-up
  const std::atomic<bool>* stop = nullptr;  // ends the run early (signal handler)
  std::string capture;                      // pcapng file of every frame; "" for none. Costs time in each cycle
  std::function<void(const Error&)> on_capture_lost;  // writing it failed, the run goes on; once
  std::function<Status(MasterChannels&)> on_ready;    // before the first frame; its error is that of the run
  std::function<void(const Event&)> on_event;         // may be empty
  WatchCommand watch;                                 // variables that the samples hold, from the first cycle on
  std::vector<SlaveRequest> requests;                 // any number, asked once the bring-up is over
  std::function<void(const SlaveRequest&, const SlaveAnswer&)> on_answer;  // in the order in which they come
  std::function<void(std::span<const CycleSample>)> on_samples;
  std::function<void(const Snapshot&)> on_snapshot;  // a newer one, before the samples that came with it
};

struct RunOutcome {
  RunReport report;
  std::optional<Error> error;        // the bring-up failed; the report says how far it came
  std::optional<Error> left_behind;  // the way down to INIT failed: slaves that are in other states
};

/// Runs a configuration on a link: on the virtual clock in the calling thread, on the real clock in a
/// thread of the master's while the calling thread drains the channels. Takes the bus down to INIT at the end.
/// An Error only when the link could not be opened or the capture cannot be begun, and that of
/// `on_ready`.
[[nodiscard]] Result<RunOutcome> run_network(const NetworkConfig& config, Result<OpenedLink> link,
                                             const RunRequest& request);

}  // namespace syncline
