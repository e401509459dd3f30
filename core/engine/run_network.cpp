// SPDX-License-Identifier: Apache-2.0
#include "engine/run_network.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "capture/capture_tap.h"
#include "channels/background_master.h"
#include "channels/command.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "engine/background_master.h"
#include "engine/capture_file.h"
#include "engine/opened_link.h"
#include "support/clock.h"

namespace syncline {
namespace {

/// Small enough that the sample ring never fills between two drains, at the shortest cycle too. On the virtual clock
/// the master asks for them, too: a bring-up is one step of it.
constexpr Nanoseconds kDrainPeriod = 100 * kMillisecond;

/// Tells once when the capture is lost.
class CaptureWatch {
 public:
  CaptureWatch(std::shared_ptr<const CaptureState> state, const RunRequest& request)
      : state_(std::move(state)), request_(request) {}
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
      if (event.is<events::Online>()) ask();
    }
    take_answers();
  }
  /// What happened before the end and is told only now; how the bus was left is no part of the run. The error when
  /// slaves were not left in INIT.
  std::optional<Error> rest() {
    take_answers();
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
  void ask() {
    for (const auto& what : request_.requests) {
      const auto id = channels_.requests.submit(what);
      if (id) asked_.emplace_back(*id, &what);
      if (!id && request_.on_answer) request_.on_answer(what, {.error = id.error()});
    }
  }
  void take_answers() {
    std::erase_if(asked_, [this](const auto& asked) {
      const auto answer = channels_.requests.take(asked.first);
      if (answer && request_.on_answer) request_.on_answer(*asked.second, *answer);
      return answer.has_value();
    });
  }

  MasterChannels& channels_;
  const RunRequest& request_;
  CaptureWatch& capture_;
  std::vector<std::pair<RequestId, const SlaveRequest*>> asked_;
  RunRecorder recorder_;
  std::vector<CycleSample> samples_;
  Snapshot snapshot_;
  std::optional<Error> error_;
};

/// While it lives the master asks for room in the sample ring (MasterChannels::relieve).
class Relief {
 public:
  Relief(MasterChannels& channels, Drain& drain) : channels_(channels) {
    channels_.relieve = [&drain] { drain(); };
  }
  ~Relief() { channels_.relieve = nullptr; }
  Relief(const Relief&) = delete;
  Relief& operator=(const Relief&) = delete;

 private:
  MasterChannels& channels_;
};

bool stopped(const RunRequest& request) { return request.stop != nullptr && request.stop->load(); }

/// The master goes at the end, and takes the slaves to INIT whatever ends the run, an exception too.
RunOutcome run_on(std::unique_ptr<BackgroundMaster> master, Clock& clock, const NetworkConfig& config,
                  const RunRequest& request, CaptureWatch& capture) {
  auto& channels = master->channels();
  Drain drain(channels, config, request, capture);
  if (request.watch.count > 0) channels.commands.push(request.watch);
  channels.commands.push(GoOnlineCommand{config, request.target});
  const auto end = clock.now() + request.duration;

  if (clock.is_virtual()) {
    std::optional<Relief> relief(std::in_place, channels, drain);
    while (clock.now() < end && !stopped(request) && !drain.failed()) {
      master->run_for(std::min(kDrainPeriod, end - clock.now()));
      drain();
    }
    relief.reset();
    auto outcome = drain.outcome();
    channels.commands.push(GoOfflineCommand{});
    while (master->online() && master->step()) {
    }
    outcome.left_behind = drain.rest();
    return outcome;
  }

  master->start();
  while (clock.now() < end && !stopped(request) && !drain.failed()) {
    clock.sleep_until(std::min(clock.now() + kDrainPeriod, end));
    drain();
  }
  auto outcome = drain.outcome();
  channels.cancel = stopped(request);
  channels.commands.push(GoOfflineCommand{});
  const auto patience = clock.now() + 10 * kSecond;
  Snapshot latest;
  latest.online = true;
  while (latest.online && clock.now() < patience) {
    clock.sleep_until(clock.now() + kDrainPeriod);
    (void)channels.snapshot.read(latest);
  }
  master->stop();
  outcome.left_behind = drain.rest();
  return outcome;
}

}  // namespace

Result<RunOutcome> run_network(const NetworkConfig& config, Result<OpenedLink> link, const RunRequest& request) {
  if (!link) return tl::unexpected(link.error());
  auto state = capture_to(request.capture, *link);
  if (!state) return tl::unexpected(state.error());
  CaptureWatch capture(std::move(*state), request);
  auto& clock = *link->clock;  // the master keeps it as long as it lives
  auto master = make_background_master(std::move(*link));
  if (request.on_ready) {
    if (auto status = request.on_ready(master->channels()); !status) return tl::unexpected(status.error());
  }
  auto outcome = run_on(std::move(master), clock, config, request, capture);
  capture.look();  // the tap went with the service
  return outcome;
}

}  // namespace syncline
