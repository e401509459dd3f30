// SPDX-License-Identifier: Apache-2.0
#include "ui/session/slave_requests.h"

#include <QTimer>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/session/live_session.h"
#include "ui/text/error_text.h"

namespace syncline::ui {
namespace {

/// Of a run that is online, or on the way there.
RequestDesk* deskOf(const NetworkRun* run) { return run == nullptr ? nullptr : run->requests(); }

bool writes(const SlaveRequest& request) {
  return std::holds_alternative<requests::SdoWrite>(request) ||
         std::holds_alternative<requests::RegisterWrite>(request) ||
         std::holds_alternative<requests::EepromWrite>(request) || std::holds_alternative<requests::FileWrite>(request);
}

}  // namespace

SlaveRequests::SlaveRequests(LiveSession& live, QObject* parent) : QObject(parent), live_(live) {}

SlaveRequests::~SlaveRequests() = default;

bool SlaveRequests::possible() const { return live_.requests() != nullptr; }

bool SlaveRequests::writing() const {
  return std::ranges::any_of(open_, [](const auto& one) { return writes(one.second.request); });
}

/// Of every run that was asked something.
void SlaveRequests::hear() {
  auto* run = &live_.run();
  if (!loads_.try_emplace(run).second) return;
  connect(run, &NetworkRun::drained, this, [this, run] { look(*run); });
  connect(run, &NetworkRun::phaseChanged, this, &SlaveRequests::endAll);
  connect(run, &QObject::destroyed, this, [this, run] {
    loads_.erase(run);
    endAll();
  });
}

SlaveRequests::Id SlaveRequests::post(SlaveRequest request, QObject& asker, Done done, RequestUrgency urgency) {
  const auto id = ++last_;
  hear();
  open_.emplace(id, Open{std::move(request), &asker, std::move(done), &live_.run(), urgency});
  // Nobody ticks while the bus is away, and who asks is not ready for an answer yet.
  if (!possible()) {
    QTimer::singleShot(0, this, &SlaveRequests::endAll);
  } else {
    submit(id, open_.at(id));
  }
  return id;
}

std::optional<RequestState> SlaveRequests::state(Id id) const {
  return open_.contains(id) ? std::optional(RequestState::kWaiting) : std::nullopt;
}

std::uint32_t SlaveRequests::progress(Id id) const {
  const auto found = open_.find(id);
  const auto* desk = found == open_.end() ? nullptr : deskOf(found->second.run);
  return desk == nullptr ? 0 : desk->progress(found->second.ticket);
}

void SlaveRequests::cancel(Id id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  found->second.cancelled = true;
  if (auto* desk = deskOf(found->second.run); found->second.ticket != 0 && desk != nullptr)
    return desk->cancel(found->second.ticket);
  QTimer::singleShot(0, this, [this, id] { deliver(id, {RequestState::kCancelled, {}, tr("Cancelled.")}); });
}

void SlaveRequests::drop(const QObject& asker) {
  for (auto at = open_.begin(); at != open_.end();) {
    if (at->second.asker != &asker) {
      ++at;
      continue;
    }
    if (auto* desk = deskOf(at->second.run); at->second.ticket != 0 && desk != nullptr) desk->forget(at->second.ticket);
    count(at->second, false);
    at = open_.erase(at);
  }
}

std::size_t SlaveRequests::waiting(const QObject& asker) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(open_, [&](const auto& one) { return one.second.asker == &asker; }));
}

bool SlaveRequests::hasRoom(const Open& open) const {
  const auto& load = loads_.at(open.run);
  const auto found = load.per_slave.find(slave_of(open.request));
  return load.all < kTotal && (found == load.per_slave.end() || found->second < kPerSlave);
}

void SlaveRequests::count(const Open& open, bool more) {
  const auto load = loads_.find(open.run);
  if (open.ticket == 0 || load == loads_.end()) return;
  auto& of_slave = load->second.per_slave[slave_of(open.request)];
  more ? ++of_slave : --of_slave;
  more ? ++load->second.all : --load->second.all;
}

void SlaveRequests::look(const NetworkRun& run) {
  collect(run);
  if (deskOf(&run) != nullptr) submitAll(run);
}

void SlaveRequests::submitAll(const NetworkRun& run) {
  for (const auto urgency : {RequestUrgency::kPerson, RequestUrgency::kBackground}) {
    for (auto& [id, open] : open_) {
      if (loads_.at(&run).all >= kTotal) return;
      if (open.run == &run && open.urgency == urgency) submit(id, open);
    }
  }
}

void SlaveRequests::submit(Id id, Open& open) {
  if (open.ticket != 0 || open.cancelled || !hasRoom(open)) return;
  const auto ticket = open.run->requests()->submit(open.request);
  if (ticket) {
    open.ticket = *ticket;
    return count(open, true);
  }
  // Beyond its limits: no other time is better.
  open.cancelled = true;
  QTimer::singleShot(0, this, [this, id, error = ticket.error()] {
    deliver(id, {RequestState::kFailed, {.error = error}, errorText(error)});
  });
}

void SlaveRequests::collect(const NetworkRun& run) {
  std::vector<std::pair<Id, RequestOutcome>> over;
  for (auto& [id, open] : open_) {
    if (open.ticket == 0 || open.run != &run || deskOf(&run) == nullptr) continue;
    auto answer = run.requests()->take(open.ticket);
    if (!answer) continue;
    RequestOutcome outcome;
    outcome.state = RequestState::kAnswered;
    if (answer->error) {
      const bool ended = answer->error->code == ErrorCode::kCancelled;
      outcome.state = !ended ? RequestState::kFailed : open.cancelled ? RequestState::kCancelled : RequestState::kGone;
      outcome.why = open.cancelled && ended ? tr("Cancelled.") : errorText(*answer->error);
    }
    outcome.answer = std::move(*answer);
    over.emplace_back(id, std::move(outcome));
  }
  for (auto& [id, outcome] : over) deliver(id, std::move(outcome));
}

/// Of the runs that have no bus any more.
void SlaveRequests::endAll() {
  std::vector<Id> all;
  for (const auto& [id, open] : open_) {
    if (deskOf(open.run) == nullptr) all.push_back(id);
  }
  for (const auto id : all) deliver(id, {RequestState::kGone, {}, tr("The bus is offline: go online first (F5).")});
}

/// Whoever is told may ask for more, drop others or go.
void SlaveRequests::deliver(Id id, RequestOutcome outcome) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  const auto open = std::move(found->second);
  open_.erase(found);
  count(open, false);
  if (open.asker && open.done) open.done(outcome);
}

}  // namespace syncline::ui
