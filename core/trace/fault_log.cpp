// SPDX-License-Identifier: Apache-2.0
#include "trace/fault_log.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace syncline {
namespace {

/// Without a form for any other: whether a new kind of event is a fault has to be said.
struct IsFault {
  // ---- what disturbs
  bool operator()(const events::AlStatusError&) const { return true; }
  bool operator()(const events::SlaveLost&) const { return true; }
  bool operator()(const events::SlavesOutOfSync&) const { return true; }
  bool operator()(const events::SlavesSyncUnknown&) const { return true; }
  bool operator()(const events::MasterOutOfSync&) const { return true; }
  bool operator()(const events::DcmError&) const { return true; }
  bool operator()(const events::WkcError&) const { return true; }
  bool operator()(const events::FramesLost&) const { return true; }
  bool operator()(const events::FramesLate&) const { return true; }
  bool operator()(const events::CyclesLeftOut&) const { return true; }
  bool operator()(const events::LinkDown&) const { return true; }
  bool operator()(const events::Emergency& e) const { return e.error_code != 0; }  // 0: none any more
  bool operator()(const events::DiagnosisTold& e) const { return e.type == DiagnosisMessage::Type::kError; }
  bool operator()(const events::PortErrors&) const { return true; }
  bool operator()(const events::WatchdogExpired&) const { return true; }
  bool operator()(const events::LongCycles& e) const { return e.begun; }
  bool operator()(const events::StaleInputs& e) const { return e.begun; }
  bool operator()(const events::CableChanged& e) const { return !e.healed; }
  bool operator()(const events::UnknownSlave&) const { return true; }
  bool operator()(const events::MasterStopped&) const { return true; }
  bool operator()(const events::ReferenceClockChanged& e) const {
    return e.what != events::ReferenceClockChanged::What::kPresent;
  }
  bool operator()(const events::RecoveryStep& e) const { return e.stage == events::RecoveryStep::Stage::kGivenUp; }
  // ---- news, and what was asked for
  bool operator()(const events::ScanProgress&) const { return false; }
  bool operator()(const events::ScanTouchesRunning&) const { return false; }
  bool operator()(const events::Online&) const { return false; }
  bool operator()(const events::Offline&) const { return false; }
  bool operator()(const events::StateChanged&) const { return false; }
  bool operator()(const events::SlaveFound&) const { return false; }
  bool operator()(const events::HotConnect&) const { return false; }
  bool operator()(const events::DcInitialised&) const { return false; }
  bool operator()(const events::SlavesInSync&) const { return false; }
  bool operator()(const events::SlavesNotMonitored&) const { return false; }
  bool operator()(const events::MasterInSync&) const { return false; }
  bool operator()(const events::DelayFinding&) const { return false; }
  bool operator()(const events::DelaysMeasured&) const { return false; }
  bool operator()(const events::WkcExpected&) const { return false; }
  bool operator()(const events::LinkUp&) const { return false; }
  bool operator()(const events::BringUpAgain&) const { return false; }
  bool operator()(const events::RealTimeRefused&) const { return false; }
  bool operator()(const events::Failure&) const { return false; }
  bool operator()(const events::EventsLost&) const { return false; }
};

bool alike(const Fault& a, const Fault& b) {
  if (a.slave != b.slave || a.event.has_value() != b.event.has_value()) return false;
  return !a.event || a.event->kind() == b.event->kind();
}

}  // namespace

bool is_fault(const Event& event) { return std::visit(IsFault{}, event.what); }

void FaultLog::add(const Event& event) {
  if (is_fault(event)) add(Fault{event.time, event.time, event.slave, event, 1});
}

void FaultLog::add_missed(Nanoseconds time, int slave, std::uint64_t missed) {
  if (missed > 0) add(Fault{time, time, slave, std::nullopt, missed});
}

void FaultLog::clear(Nanoseconds now) {
  episodes_.clear();
  count_ = 0;
  since_ = now;
}

FaultEpisode& FaultLog::episode_at(Nanoseconds time) {
  const auto found = std::find_if(episodes_.rbegin(), episodes_.rend(), [time](const FaultEpisode& episode) {
    return time >= episode.begin - kQuiet && time <= episode.end + kQuiet;
  });
  if (found != episodes_.rend()) return *found;
  ++count_;
  if (episodes_.size() == kMostEpisodes) episodes_.erase(episodes_.begin());
  episodes_.push_back({time, time, {}, 0});
  return episodes_.back();
}

void FaultLog::add(Fault fault) {
  if (fault.first < since_) return;
  auto& episode = episode_at(fault.first);
  episode.begin = std::min(episode.begin, fault.first);
  episode.end = std::max(episode.end, fault.last);
  auto& faults = episode.faults;
  if (const auto same = std::ranges::find_if(faults, [&](const Fault& f) { return alike(f, fault); });
      same != faults.end()) {
    fault.count += same->count;
    fault.last = std::max(fault.last, same->last);
    if (same->first <= fault.first) {
      fault.first = same->first;
      fault.event = std::move(same->event);
    }
    faults.erase(same);
  } else if (faults.size() == FaultEpisode::kMostFaults) {
    ++episode.left_out;
    return;
  }
  const auto place = std::ranges::upper_bound(faults, fault.first, {}, &Fault::first);
  faults.insert(place, std::move(fault));
}

}  // namespace syncline
