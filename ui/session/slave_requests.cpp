// SPDX-License-Identifier: Apache-2.0
#include "ui/session/slave_requests.h"

#include <QTimer>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/session/live_session.h"
#include "ui/text/error_text.h"

namespace syncline::ui {

SlaveRequests::SlaveRequests(LiveSession& live, QObject* parent) : QObject(parent), live_(live) {
  connect(&live_, &LiveSession::drained, this, &SlaveRequests::look);
  connect(&live_, &LiveSession::phaseChanged, this, [this] {
    if (!possible()) endAll();
  });
}

SlaveRequests::~SlaveRequests() = default;

bool SlaveRequests::possible() const { return live_.requests() != nullptr; }

SlaveRequests::Id SlaveRequests::post(SlaveRequest request, QObject& asker, Done done, RequestUrgency urgency) {
  const auto id = ++last_;
  open_.emplace(id, Open{std::move(request), &asker, std::move(done), urgency});
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
  const auto* desk = live_.requests();
  return found == open_.end() || desk == nullptr ? 0 : desk->progress(found->second.ticket);
}

void SlaveRequests::cancel(Id id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  found->second.cancelled = true;
  if (found->second.ticket != 0 && possible()) return live_.requests()->cancel(found->second.ticket);
  QTimer::singleShot(0, this, [this, id] { deliver(id, {RequestState::kCancelled, {}, tr("Cancelled.")}); });
}

void SlaveRequests::drop(const QObject& asker) {
  for (auto at = open_.begin(); at != open_.end();) {
    if (at->second.asker != &asker) {
      ++at;
      continue;
    }
    if (at->second.ticket != 0 && possible()) live_.requests()->forget(at->second.ticket);
    count(at->second, false);
    at = open_.erase(at);
  }
}

std::size_t SlaveRequests::waiting(const QObject& asker) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(open_, [&](const auto& one) { return one.second.asker == &asker; }));
}

bool SlaveRequests::hasRoom(std::uint16_t slave) const {
  const auto found = per_slave_.find(slave);
  return with_master_ < kTotal && (found == per_slave_.end() || found->second < kPerSlave);
}

void SlaveRequests::count(const Open& open, bool more) {
  if (open.ticket == 0) return;
  auto& of_slave = per_slave_[slave_of(open.request)];
  more ? ++of_slave : --of_slave;
  more ? ++with_master_ : --with_master_;
}

void SlaveRequests::look() {
  collect();
  if (possible()) submitAll();
}

void SlaveRequests::submitAll() {
  for (const auto urgency : {RequestUrgency::kPerson, RequestUrgency::kBackground}) {
    for (auto& [id, open] : open_) {
      if (with_master_ >= kTotal) return;
      if (open.urgency == urgency) submit(id, open);
    }
  }
}

void SlaveRequests::submit(Id id, Open& open) {
  if (open.ticket != 0 || open.cancelled || !hasRoom(slave_of(open.request))) return;
  const auto ticket = live_.requests()->submit(open.request);
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

void SlaveRequests::collect() {
  std::vector<std::pair<Id, RequestOutcome>> over;
  for (auto& [id, open] : open_) {
    if (open.ticket == 0) continue;
    auto answer = live_.requests()->take(open.ticket);
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

void SlaveRequests::endAll() {
  if (possible()) return;
  std::vector<Id> all;
  for (const auto& [id, open] : open_) all.push_back(id);
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
