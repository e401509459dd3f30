// SPDX-License-Identifier: Apache-2.0
#include "trace/fault_log.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace syncline {
namespace {

/// Without a form for any other: what a new kind of event means has to be said.
struct MeaningOf {
  using enum EventMeaning;
  static EventMeaning fault_or_order(bool fault) { return fault ? kFault : kReturnToOrder; }

  // ---- what disturbs
  EventMeaning operator()(const events::AlStatusError&) const { return kFault; }
  EventMeaning operator()(const events::SlaveLost&) const { return kFault; }
  EventMeaning operator()(const events::SlavesOutOfSync&) const { return kFault; }
  EventMeaning operator()(const events::SlavesSyncUnknown&) const { return kFault; }
  EventMeaning operator()(const events::MasterOutOfSync& e) const {
    return e.obstacle == dc::SyncObstacle::kToExternalClock ? kNews : kFault;
  }
  EventMeaning operator()(const events::DcmError&) const { return kFault; }
  EventMeaning operator()(const events::WkcError&) const { return kFault; }
  EventMeaning operator()(const events::FramesLost&) const { return kFault; }
  EventMeaning operator()(const events::FramesLate&) const { return kFault; }
  EventMeaning operator()(const events::CyclesLeftOut&) const { return kFault; }
  EventMeaning operator()(const events::LinkDown&) const { return kFault; }
  EventMeaning operator()(const events::Emergency& e) const {
    return fault_or_order(e.error_code != 0);
  }  // 0: none any more
  EventMeaning operator()(const events::DiagnosisTold& e) const {
    return e.type == DiagnosisMessageType::kError ? kFault : kNews;
  }
  EventMeaning operator()(const events::PortErrors&) const { return kFault; }
  EventMeaning operator()(const events::WatchdogExpired&) const { return kFault; }
  EventMeaning operator()(const events::LongCycles& e) const { return fault_or_order(e.begun); }
  EventMeaning operator()(const events::StaleProcessData& e) const { return fault_or_order(e.begun); }
  EventMeaning operator()(const events::CableChanged& e) const { return fault_or_order(!e.healed); }
  EventMeaning operator()(const events::UnknownSlave&) const { return kFault; }
  EventMeaning operator()(const events::MasterStopped&) const { return kFault; }
  EventMeaning operator()(const events::ReferenceClockChanged& e) const {
    return fault_or_order(e.what != events::ReferenceClockChanged::What::kPresent);
  }
  EventMeaning operator()(const events::RecoveryStep& e) const {
    using Stage = events::RecoveryStep::Stage;
    if (e.stage == Stage::kGivenUp) return kFault;
    return e.stage == Stage::kDone ? kReturnToOrder : kNews;
  }
  EventMeaning operator()(const events::LeftUnasked&) const { return kFault; }
  // ---- news, and what was asked for
  EventMeaning operator()(const events::BusWasRunning&) const { return kNews; }
  EventMeaning operator()(const events::ScanProgress&) const { return kNews; }
  EventMeaning operator()(const events::ScanTouchesRunning&) const { return kNews; }
  EventMeaning operator()(const events::Online&) const { return kNews; }
  EventMeaning operator()(const events::Offline&) const { return kNews; }
  EventMeaning operator()(const events::StateChanged&) const { return kNews; }
  EventMeaning operator()(const events::SlaveFound&) const { return kReturnToOrder; }
  EventMeaning operator()(const events::HotConnect&) const { return kNews; }
  EventMeaning operator()(const events::DcInitialised&) const { return kNews; }
  EventMeaning operator()(const events::SlavesInSync&) const { return kReturnToOrder; }
  EventMeaning operator()(const events::SlavesNotMonitored&) const { return kNews; }
  EventMeaning operator()(const events::MasterInSync&) const { return kReturnToOrder; }
  EventMeaning operator()(const events::DelayFinding&) const { return kNews; }
  EventMeaning operator()(const events::FramesWayChanged&) const { return kNews; }
  EventMeaning operator()(const events::DelaysMeasured&) const { return kNews; }
  EventMeaning operator()(const events::WkcExpected&) const { return kNews; }
  EventMeaning operator()(const events::LinkUp&) const { return kReturnToOrder; }
  EventMeaning operator()(const events::BringUpAgain&) const { return kNews; }
  EventMeaning operator()(const events::RealTimeRefused&) const { return kNews; }
  EventMeaning operator()(const events::OutputsForced&) const { return kNews; }
  EventMeaning operator()(const events::Failure&) const { return kNews; }
  EventMeaning operator()(const events::EventsLost&) const { return kNews; }
};

bool alike(const Fault& a, const Fault& b) {
  if (a.slave != b.slave || a.event.has_value() != b.event.has_value()) return false;
  return !a.event || a.event->kind() == b.event->kind();
}

/// Who stands for what in the same moment: a cable or a link is the cause of who does not answer behind it, and an
/// error code says less than the loss that names its reason.
int cause_rank(const Fault& fault) {
  if (!fault.event) return 0;
  if (fault.event->is<events::DcmError>()) return -1;
  const auto is_cause = fault.event->is<events::CableChanged>() || fault.event->is<events::LinkDown>() ||
                        fault.event->is<events::CyclesLeftOut>();
  if (is_cause) return 2;
  return fault.event->is<events::SlaveLost>() ? 1 : 0;
}

/// What frames or clocks only show of something else.
bool is_symptom(const Fault& fault) {
  return fault.event && (fault.event->is<events::WkcError>() || fault.event->is<events::FramesLost>() ||
                         fault.event->is<events::DcmError>() || fault.event->is<events::MasterOutOfSync>());
}

/// What went wrong with frames at `moment` did so between two readings of the counters of a port that counted damaged
/// ones meanwhile: counters are read in turn, and tell later what came first.
bool explains(const Fault& fault, Nanoseconds moment) {
  const auto* const errors = fault.event ? fault.event->as<events::PortErrors>() : nullptr;
  return errors != nullptr && errors->damaged_frames > 0 && errors->since != 0 && errors->since <= moment &&
         fault.first >= moment;
}

/// What is told at `time` came with the return to order at `over`.
bool follows(Nanoseconds over, Nanoseconds time) { return time >= over && time <= over + FaultLog::kQuiet; }

/// The return to order is that of this fault.
bool ends(const Event& order, const Fault& fault) {
  const auto& what = *fault.event;
  const bool same_slave = order.slave == fault.slave;
  if (order.is<events::SlaveFound>()) return same_slave && what.is<events::SlaveLost>();
  if (order.is<events::CableChanged>()) return same_slave && what.is<events::CableChanged>();
  if (order.is<events::LinkUp>()) return what.is<events::LinkDown>();
  if (order.is<events::SlavesInSync>()) {
    // Of one slave: it came back while the others were in sync.
    return order.slave < 0 && (what.is<events::SlavesOutOfSync>() || what.is<events::SlavesSyncUnknown>());
  }
  if (order.is<events::SlavesNotMonitored>()) return what.is<events::SlavesSyncUnknown>();
  if (order.is<events::MasterInSync>()) return what.is<events::MasterOutOfSync>();
  if (order.is<events::ReferenceClockChanged>()) return what.is<events::ReferenceClockChanged>();
  return same_slave && order.kind() == what.kind() &&
         (order.is<events::LongCycles>() || order.is<events::StaleProcessData>());
}

}  // namespace

bool Fault::lasts() const {
  if (!event) return false;
  return event->is<events::SlaveLost>() || event->is<events::CableChanged>() || event->is<events::LinkDown>() ||
         event->is<events::SlavesOutOfSync>() || event->is<events::SlavesSyncUnknown>() ||
         event->is<events::MasterOutOfSync>() || event->is<events::ReferenceClockChanged>() ||
         event->is<events::LongCycles>() || event->is<events::StaleProcessData>();
}

std::size_t FaultEpisode::leading() const {
  std::size_t lead = 0;
  if (!is_symptom(faults.front())) return lead;
  for (std::size_t i = 1; i < faults.size() && faults[i].first - faults.front().first <= kSameMoment; ++i) {
    if (cause_rank(faults[i]) > cause_rank(faults[lead])) lead = i;
  }
  const auto& first = *faults.front().event;
  if (lead > 0 || !(first.is<events::FramesLost>() || first.is<events::WkcError>())) return lead;
  const auto damaged =
      std::ranges::find_if(faults, [this](const Fault& f) { return explains(f, faults.front().first); });
  return damaged == faults.end() ? lead : static_cast<std::size_t>(damaged - faults.begin());
}

EventMeaning meaning_of(const Event& event) { return std::visit(MeaningOf{}, event.what); }

void FaultLog::add(const Event& event) {
  if (meaning_of(event) == EventMeaning::kFault) return add(Fault{event.time, event.time, event.slave, event, 1, {}});
  end(event);
}

void FaultLog::add_missed(Nanoseconds time, int slave, std::uint64_t missed) {
  if (missed > 0) add(Fault{time, time, slave, std::nullopt, missed, {}});
}

void FaultLog::end(const Event& news) {
  // From the newest on: what is taken over by one does not move those that are still to be asked.
  for (auto i = episodes_.size(); i-- > 0;) {
    bool any = false;
    for (auto& fault : episodes_[i].faults) {
      if (!fault.lasts() || fault.over || fault.last > news.time || !ends(news, fault)) continue;
      fault.over = news.time;
      any = true;
    }
    if (any) take_what_follows(i, news.time);
  }
}

/// Counts come with the samples, the return with the events: these may be drained later.
void FaultLog::take_what_follows(std::size_t episode, Nanoseconds over) {
  for (auto i = episode + 1; i < episodes_.size();) {
    if (!follows(over, episodes_[i].begin)) {
      ++i;
      continue;
    }
    auto later = std::move(episodes_[i]);
    episodes_.erase(episodes_.begin() + static_cast<std::ptrdiff_t>(i));
    --count_;
    for (auto& fault : later.faults) add(std::move(fault), episodes_[episode]);
    episodes_[episode].left_out += later.left_out;
  }
}

std::vector<const Fault*> FaultLog::lasting() const {
  std::vector<const Fault*> all;
  for (const auto& episode : episodes_) {
    for (const auto& fault : episode.faults) {
      if (fault.lasts() && !fault.over) all.push_back(&fault);
    }
  }
  return all;
}

void FaultLog::clear(Nanoseconds now) {
  episodes_.clear();
  count_ = 0;
  since_ = now;
}

FaultEpisode& FaultLog::episode_at(Nanoseconds time) {
  const auto found = std::find_if(episodes_.rbegin(), episodes_.rend(), [time](const FaultEpisode& episode) {
    const bool near = time >= episode.begin - kQuiet && time <= episode.end + kQuiet;
    return near ||
           std::ranges::any_of(episode.faults, [time](const Fault& f) { return f.over && follows(*f.over, time); });
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
  add(std::move(fault), episode);
}

void FaultLog::add(Fault fault, FaultEpisode& episode) {
  episode.begin = std::min(episode.begin, fault.first);
  episode.end = std::max(episode.end, fault.last);
  auto& faults = episode.faults;
  if (const auto same = std::ranges::find_if(faults, [&](const Fault& f) { return alike(f, fault); });
      same != faults.end()) {
    fault.count += same->count;
    if (same->over && *same->over > fault.last) fault.over = same->over;  // it came late
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
