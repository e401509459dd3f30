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
  return std::ranges::any_of(open_, [](const auto& one) { return one.second.writes; });
}

/// Every run that was asked something is listened to.
RequestQueue& SlaveRequests::queueOf(NetworkRun& run) {
  const auto [place, first] = queues_.try_emplace(&run);
  if (first) {
    connect(&run, &NetworkRun::drained, this, [this, asked = &run] { look(*asked); });
    connect(&run, &NetworkRun::phaseChanged, this, &SlaveRequests::endAll);
    connect(&run, &QObject::destroyed, this, [this, gone = &run] {
      auto queue = queues_.extract(gone);
      queue.mapped().end_all();
      tell(queue.mapped().take_ended(nullptr));
    });
  }
  return place->second;
}

SlaveRequests::Id SlaveRequests::post(SlaveRequest request, QObject& asker, Done done, RequestUrgency urgency) {
  const auto id = ++last_;
  auto& run = live_.run();
  auto& queue = queueOf(run);
  open_.emplace(id, Open{&asker, std::move(done), &run, writes(request)});
  queue.post(id, std::move(request), urgency);
  if (auto* desk = deskOf(&run)) {
    queue.submit(*desk);
    if (queue.has_ended()) lookLater(run);
  } else {  // nobody ticks while the bus is away, and who asks is not ready for an answer yet
    QTimer::singleShot(0, this, &SlaveRequests::endAll);
  }
  return id;
}

std::uint32_t SlaveRequests::progress(Id id) const {
  const auto found = open_.find(id);
  const auto* desk = found == open_.end() ? nullptr : deskOf(found->second.run);
  return desk == nullptr ? 0 : queues_.at(found->second.run).progress(id, *desk);
}

void SlaveRequests::cancel(Id id) {
  const auto found = open_.find(id);
  if (found == open_.end() || !found->second.run) return;
  auto& run = *found->second.run;
  auto& queue = queueOf(run);
  queue.cancel(id, deskOf(&run));
  if (queue.has_ended()) lookLater(run);
}

void SlaveRequests::drop(const QObject& asker) {
  for (auto at = open_.begin(); at != open_.end();) {
    const auto& [id, open] = *at;
    if (open.asker != &asker) {
      ++at;
      continue;
    }
    if (open.run) queueOf(*open.run).forget(id, deskOf(open.run));
    at = open_.erase(at);
  }
}

std::size_t SlaveRequests::waiting(const QObject& asker) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(open_, [&](const auto& one) { return one.second.asker == &asker; }));
}

void SlaveRequests::look(const NetworkRun& run) {
  const auto queue = queues_.find(&run);
  if (queue != queues_.end()) tell(queue->second.take_ended(deskOf(&run)));
}

/// Whoever is told may ask for more, drop others or go.
void SlaveRequests::tell(std::vector<RequestQueue::Ended> all) {
  for (auto& ended : all) {
    QString why;
    if (ended.end == RequestEnd::kCancelled) {
      why = tr("Cancelled.");
    } else if (ended.answer.error) {
      why = errorText(*ended.answer.error);
    } else if (ended.end == RequestEnd::kGone) {
      why = tr("The bus is offline: go online first (F5).");
    }
    deliver(ended.id, {ended.end, std::move(ended.answer), why});
  }
}

void SlaveRequests::lookLater(const NetworkRun& run) {
  QTimer::singleShot(0, this, [this, asked = &run] { look(*asked); });
}

/// Of the runs that have no bus any more.
void SlaveRequests::endAll() {
  std::vector<const NetworkRun*> away;
  for (auto& [run, queue] : queues_) {
    if (deskOf(run) != nullptr) continue;
    queue.end_all();
    away.push_back(run);
  }
  for (const auto* run : away) look(*run);
}

void SlaveRequests::deliver(Id id, const RequestOutcome& outcome) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  const auto open = std::move(found->second);
  open_.erase(found);
  if (open.asker && open.done) open.done(outcome);
}

}  // namespace syncline::ui
