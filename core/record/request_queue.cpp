// SPDX-License-Identifier: Apache-2.0
#include "record/request_queue.h"

#include <iterator>
#include <utility>

namespace syncline {
namespace {

RequestEnd end_of(const SlaveAnswer& answer, bool cancelled) {
  if (!answer.error) return RequestEnd::kAnswered;
  if (answer.error->code != ErrorCode::kCancelled) return RequestEnd::kFailed;
  return cancelled ? RequestEnd::kCancelled : RequestEnd::kGone;
}

}  // namespace

void RequestQueue::post(Id id, SlaveRequest request, RequestUrgency urgency) {
  waiting_.insert_or_assign(id, Waiting{std::move(request), urgency});
}

void RequestQueue::submit(RequestDesk& desk) {
  for (const auto urgency : {RequestUrgency::kPerson, RequestUrgency::kBackground}) {
    for (auto at = waiting_.begin(); at != waiting_.end();) {
      const auto next = std::next(at);
      const auto& waiting = at->second;
      if (waiting.ticket == 0 && waiting.urgency == urgency && has_room(waiting)) give(at, desk);
      at = next;
    }
  }
}

bool RequestQueue::has_room(const Waiting& waiting) const {
  const auto found = of_slave_.find(slave_of(waiting.request));
  return with_master_ < room_.total && (found == of_slave_.end() || found->second < room_.per_slave);
}

void RequestQueue::give(Place at, RequestDesk& desk) {
  auto& waiting = at->second;
  const auto ticket = desk.submit(waiting.request);
  if (!ticket) {  // beyond its limits: no other time is better
    ended_.push_back({at->first, RequestEnd::kFailed, {.error = ticket.error()}});
    remove(at);
    return;
  }
  waiting.ticket = *ticket;
  ++of_slave_[slave_of(waiting.request)];
  ++with_master_;
}

RequestQueue::Place RequestQueue::remove(Place at) {
  if (at->second.ticket != 0) {
    --of_slave_[slave_of(at->second.request)];
    --with_master_;
  }
  return waiting_.erase(at);
}

void RequestQueue::cancel(Id id, RequestDesk* desk) {
  const auto found = waiting_.find(id);
  if (found == waiting_.end()) return;
  found->second.cancelled = true;
  if (found->second.ticket != 0 && desk != nullptr) return desk->cancel(found->second.ticket);
  ended_.push_back({id, RequestEnd::kCancelled});
  remove(found);
}

void RequestQueue::forget(Id id, RequestDesk* desk) {
  std::erase_if(ended_, [id](const Ended& ended) { return ended.id == id; });
  const auto found = waiting_.find(id);
  if (found == waiting_.end()) return;
  if (found->second.ticket != 0 && desk != nullptr) desk->forget(found->second.ticket);
  remove(found);
}

void RequestQueue::end_all() {
  for (auto at = waiting_.begin(); at != waiting_.end(); at = remove(at))
    ended_.push_back({at->first, RequestEnd::kGone});
}

std::uint32_t RequestQueue::progress(Id id, const RequestDesk& desk) const {
  const auto found = waiting_.find(id);
  return found == waiting_.end() ? 0 : desk.progress(found->second.ticket);
}

void RequestQueue::collect(RequestDesk& desk) {
  for (auto at = waiting_.begin(); at != waiting_.end();) {
    auto answer = at->second.ticket != 0 ? desk.take(at->second.ticket) : std::nullopt;
    if (!answer) {
      ++at;
      continue;
    }
    const auto end = end_of(*answer, at->second.cancelled);
    ended_.push_back({at->first, end, std::move(*answer)});
    at = remove(at);
  }
}

std::vector<RequestQueue::Ended> RequestQueue::take_ended(RequestDesk* desk) {
  if (desk != nullptr) {
    collect(*desk);
    submit(*desk);
  }
  return std::exchange(ended_, {});
}

}  // namespace syncline
