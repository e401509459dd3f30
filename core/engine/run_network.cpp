// SPDX-License-Identifier: Apache-2.0
#include "engine/run_network.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "capture/capture_tap.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "engine/background_master.h"
#include "engine/capture_file.h"
#include "engine/opened_link.h"
#include "record/request_queue.h"
#include "record/run_session.h"
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

/// What whoever asked for the run gets of what the session drains.
class Drain {
 public:
  Drain(RunSession& session, const NetworkConfig& config, const RunRequest& request, CaptureWatch& capture)
      : session_(session), request_(request), capture_(capture), recorder_(config) {}

  void operator()() {
    capture_.look();
    const auto& news = session_.drain();
    if (news.snapshot != nullptr && request_.on_snapshot) request_.on_snapshot(*news.snapshot);
    news.feed(recorder_);
    if (request_.on_samples && !news.samples.empty()) request_.on_samples(news.samples);
    for (const auto& event : news.events) {
      if (request_.on_event) request_.on_event(event);
      if (const auto* failure = event.as<events::Failure>()) note(failure->error);
      if (event.is<events::Online>()) {
        was_online_ = true;
        ask();
      }
    }
    take_answers(&session_.channels().requests);
  }
  /// What happened before the end and is told only now; how the bus was left is no part of the run. The error when
  /// slaves were not left in INIT.
  std::optional<Error> rest() {
    take_answers(&session_.channels().requests);
    queue_.end_all();
    take_answers(nullptr);
    const auto end = end_;
    std::optional<Error> left_behind;
    for (const auto& event : session_.channels().events.drain()) {
      if (event.time <= end && request_.on_event) request_.on_event(event);
      const auto* failure = event.as<events::Failure>();
      if (event.time > end && failure && !error_) left_behind = failure->error;
    }
    return left_behind;
  }
  /// As of now: the end of the run.
  [[nodiscard]] RunOutcome outcome() {
    end_ = session_.snapshot().time;
    return {recorder_.finish(session_.snapshot()), failed() && !error_ ? ended_by_ : error_, {}};
  }
  [[nodiscard]] bool failed() const { return (error_ || ended_by_) && !session_.snapshot().online; }

 private:
  /// What one of several tries to bring a slave back came to is no failure of the run, as long as the bus is there.
  void note(const Error& error) {
    auto& first = was_online_ ? ended_by_ : error_;
    if (!first) first = error;
  }
  void ask() {
    for (std::size_t i = 0; i < request_.requests.size(); ++i) queue_.post(i, request_.requests[i]);
  }
  void take_answers(RequestDesk* desk) {
    for (auto& ended : queue_.take_ended(desk)) {
      const auto& what = request_.requests[ended.id];
      if (ended.end == RequestEnd::kGone && !ended.answer.error)  // the run was over before its turn
        ended.answer.error = Error{ErrorCode::kCancelled, subject_of(what)};
      if (request_.on_answer) request_.on_answer(what, ended.answer);
    }
  }

  RunSession& session_;
  const RunRequest& request_;
  CaptureWatch& capture_;
  // Nobody waits for one of them while others fill a page: all that the desk takes.
  RequestQueue queue_{{RequestDesk::kCapacity, RequestDesk::kCapacity}};
  RunRecorder recorder_;
  Nanoseconds end_ = 0;
  bool was_online_ = false;
  std::optional<Error> error_, ended_by_;  // of the bring-up; of the bus that was online
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

/// On the virtual clock: time passes as far as it is let.
void pass_virtual(RunSession& session, Clock& clock, Nanoseconds end, const RunRequest& request, Drain& drain) {
  const Relief relief(session.channels(), drain);
  while (clock.now() < end && !stopped(request) && !drain.failed()) {
    session.master()->run_for(std::min(kDrainPeriod, end - clock.now()));
    drain();
  }
}

void pass_real(RunSession& session, Clock& clock, Nanoseconds end, const RunRequest& request, Drain& drain) {
  session.start();
  while (clock.now() < end && !stopped(request) && !drain.failed()) {
    clock.sleep_until(std::min(clock.now() + kDrainPeriod, end));
    drain();
  }
}

/// Until the slaves are in INIT, or have had time enough for it.
void lead_down(RunSession& session, Clock& clock, const RunRequest& request) {
  session.go_offline(!clock.is_virtual() && stopped(request));
  if (clock.is_virtual()) {
    if (session.master()->online()) session.run_down();
    return;
  }
  const auto patience = clock.now() + 10 * kSecond;
  Snapshot latest;
  latest.online = true;
  while (latest.online && clock.now() < patience) {
    clock.sleep_until(clock.now() + kDrainPeriod);
    (void)session.channels().snapshot.read(latest);
  }
  session.master()->stop();
}

/// The master goes at the end, and takes the slaves to INIT whatever ends the run, an exception too.
RunOutcome run_on(RunSession& session, Clock& clock, const NetworkConfig& config, const RunRequest& request,
                  CaptureWatch& capture) {
  Drain drain(session, config, request, capture);
  (void)session.go_online(config, request.target, request.watch);
  const auto end = clock.now() + request.duration;
  clock.is_virtual() ? pass_virtual(session, clock, end, request, drain)
                     : pass_real(session, clock, end, request, drain);
  auto outcome = drain.outcome();
  lead_down(session, clock, request);
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
  std::optional<RunSession> session(std::in_place);
  // Where something throws, the way down to INIT is waited for all the same.
  session->set_patience({.stop = std::chrono::minutes(1)});
  session->take(make_background_master(std::move(*link)));
  if (request.on_ready) {
    if (auto status = request.on_ready(session->channels()); !status) return tl::unexpected(status.error());
  }
  auto outcome = run_on(*session, clock, config, request, capture);
  session.reset();
  capture.look();  // the tap went with the service
  return outcome;
}

}  // namespace syncline
