// SPDX-License-Identifier: Apache-2.0
#include "app/composition/run_network.h"

#include <algorithm>
#include <optional>

#include "app/composition/capture_file.h"
#include "app/composition/open_link.h"
#include "master/master_service.h"

namespace syncline {
namespace {

/// Small enough that the sample ring never fills between two drains, at the shortest cycle too.
constexpr Nanoseconds kDrainPeriod = 100 * kMillisecond;

/// Whatever ends a run, an exception too: the slaves go to INIT.
class AtTheEnd {
 public:
  explicit AtTheEnd(MasterService& service) : service_(service) {}
  ~AtTheEnd() { service_.shut_down(); }
  AtTheEnd(const AtTheEnd&) = delete;
  AtTheEnd& operator=(const AtTheEnd&) = delete;

 private:
  MasterService& service_;
};

/// Tells once when the capture is lost.
class CaptureWatch {
 public:
  CaptureWatch(std::shared_ptr<const CaptureState> state, const RunRequest& request) : state_(std::move(state)), request_(request) {}
  void look() {
    if (!state_ || !state_->failed()) return;
    if (request_.on_capture_lost) request_.on_capture_lost(state_->error());
    state_.reset();
  }

 private:
  std::shared_ptr<const CaptureState> state_;
  const RunRequest& request_;
};

/// The consumer side of the channels.
class Drain {
 public:
  Drain(MasterChannels& channels, const NetworkConfig& config, const RunRequest& request, CaptureWatch& capture)
      : channels_(channels), request_(request), capture_(capture), recorder_(config) {}

  void operator()() {
    capture_.look();
    const bool news = channels_.snapshot.read(snapshot_);
    if (news && request_.on_snapshot) request_.on_snapshot(snapshot_);
    samples_.clear();
    channels_.samples.pop(samples_);
    recorder_.add(samples_);
    if (news) recorder_.add(snapshot_);
    if (request_.on_samples && !samples_.empty()) request_.on_samples(samples_);
    for (auto& event : channels_.events.drain()) {
      recorder_.add(event);
      if (request_.on_event) request_.on_event(event);
      if (const auto* failure = event.as<events::Failure>(); failure && !error_) error_ = failure->error;
    }
  }
  /// What happened before the end and is told only now; how the bus was left is no part of the run. The error when slaves
  /// were not left in INIT.
  std::optional<Error> rest() {
    const auto end = snapshot_.time;
    std::optional<Error> left_behind;
    for (const auto& event : channels_.events.drain()) {
      if (event.time <= end && request_.on_event) request_.on_event(event);
      const auto* failure = event.as<events::Failure>();
      if (event.time > end && failure && !error_) left_behind = failure->error;
    }
    return left_behind;
  }
  [[nodiscard]] RunOutcome outcome() const { return {recorder_.finish(snapshot_), error_, {}}; }
  [[nodiscard]] bool failed() const { return error_ && !snapshot_.online; }

 private:
  MasterChannels& channels_;
  const RunRequest& request_;
  CaptureWatch& capture_;
  RunRecorder recorder_;
  std::vector<CycleSample> samples_;
  Snapshot snapshot_;
  std::optional<Error> error_;
};

bool stopped(const RunRequest& request) { return request.stop != nullptr && request.stop->load(); }

/// The link goes to the service and with it.
RunOutcome run_on(OpenedLink& opened, const NetworkConfig& config, const RunRequest& request, CaptureWatch& capture) {
  MasterService service(std::move(opened.link), *opened.clock);
  const AtTheEnd at_the_end(service);
  auto& channels = service.channels();
  Drain drain(channels, config, request, capture);
  channels.commands.push(GoOnlineCommand{config, request.target});
  const auto end = opened.clock->now() + request.duration;

  if (opened.clock->is_virtual()) {
    while (opened.clock->now() < end && !stopped(request) && !drain.failed()) {
      service.run_for(std::min(kDrainPeriod, end - opened.clock->now()));
      drain();
    }
    auto outcome = drain.outcome();
    channels.commands.push(GoOfflineCommand{});
    while (service.online() && service.step()) {
    }
    outcome.left_behind = drain.rest();
    return outcome;
  }

  MasterThread thread(service);
  while (opened.clock->now() < end && !stopped(request) && !drain.failed()) {
    opened.clock->sleep_until(std::min(opened.clock->now() + kDrainPeriod, end));
    drain();
  }
  auto outcome = drain.outcome();
  channels.cancel = stopped(request);
  channels.commands.push(GoOfflineCommand{});
  const auto patience = opened.clock->now() + 10 * kSecond;
  Snapshot latest;
  latest.online = true;
  while (latest.online && opened.clock->now() < patience) {
    opened.clock->sleep_until(opened.clock->now() + kDrainPeriod);
    (void)channels.snapshot.read(latest);
  }
  thread.stop();
  outcome.left_behind = drain.rest();
  return outcome;
}

}  // namespace

Result<RunOutcome> run_network(const NetworkConfig& config, std::string_view link, const RunRequest& request) {
  auto opened = open_link(link);
  if (!opened) return tl::unexpected(opened.error());
  auto state = capture_to(request.capture, *opened);
  if (!state) return tl::unexpected(state.error());
  CaptureWatch capture(std::move(*state), request);
  auto outcome = run_on(*opened, config, request, capture);
  capture.look();  // the tap went with the service
  return outcome;
}

}  // namespace syncline
