// SPDX-License-Identifier: Apache-2.0
#include "master/recovery/recovery.h"

#include <algorithm>
#include <utility>

#include "config/network_config.h"
#include "master/cyclic/cyclic_task.h"
#include "master/exchange/bus.h"
#include "master/scan/bus_match.h"
#include "master/startup/bus_survey.h"
#include "master/startup/esm.h"
#include "master/startup/hot_connect.h"

namespace syncline {
namespace {

using Stage = events::RecoveryStep::Stage;

constexpr Nanoseconds kLookPeriod = 10 * kMillisecond;
constexpr Nanoseconds kFirstWait = 50 * kMillisecond;  // a device that is switched on is not there at once
constexpr Nanoseconds kRetryPeriod = 500 * kMillisecond;
constexpr Nanoseconds kWellPeriod = 10 * kSecond;  // in the state of the bus so long: the next trouble is a new one
constexpr std::uint32_t kReturnTries = 10;
/// So often a slave is led up from where it is. What it refuses then is what it was set up with before, as a clock that
/// has run away from the others: it is set up anew.
constexpr std::uint32_t kTriesAsItIs = 2;
constexpr Nanoseconds kAfterOutage = kSecond;  // all AL states have been read meanwhile, and drives have counted

bool is_behind(std::uint16_t al_status, AlState target) {
  return (al_status & kAlErrorFlag) != 0 || static_cast<int>(al_state_of(al_status)) < static_cast<int>(target);
}

}  // namespace

Recovery::Recovery(Bus& bus, RunState& run, CyclicTaskRunner& task, Esm& esm)
    : bus_(bus), run_(run), task_(task), esm_(esm), tracks_(run.config().slaves.size()) {}

std::size_t Recovery::present_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(run_.snapshot.slaves, &SlaveStatus::present));
}

// ---- when -----------------------------------------------------------------------------------------

Status Recovery::after_cycle() {
  const auto now = run_.snapshot.time;
  if (now < next_look_) return {};
  next_look_ = now + kLookPeriod;
  look();
  const auto due_again = [&](std::size_t i) {
    return comes_back(i) && !tracks_[i].given_up && now >= tracks_[i].next_try;
  };
  bool waiting = false;
  for (std::size_t i = 0; !waiting && i < tracks_.size(); ++i) waiting = due_again(i);
  const bool unknown = task_.slaves().answering().value_or(0) > present_count() && waiting;
  bool any = unknown;
  for (std::size_t i = 0; !any && i < tracks_.size(); ++i) any = due(i, now);
  if (!any || task_.slaves().refreshing()) return {};
  return work(false, esm_.level());
}

/// Was away, and is set up again without a command of the user: always so in a hot-connect group.
bool Recovery::comes_back(std::size_t slave) const {
  return tracks_[slave].returning && (run_.config().recovery.automatic || run_.config().hot_connect_head(slave));
}

/// Keeps the tracks up to date.
void Recovery::look() {
  const auto now = run_.snapshot.time;
  const bool leaderless = task_.reference().is_lost();
  const bool away = run_.link.away_since() || run_.link.outages() != outages_seen_;
  if (away || leaderless) fall_by_outage_ = now + kAfterOutage;
  outages_seen_ = run_.link.outages();
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const auto& slave = run_.snapshot.slaves[i];
    auto& track = tracks_[i];
    // Also one that went and came while others ran the cycles, as the bring-up does.
    const bool was_away = std::exchange(track.losses, run_.states.losses(i)) != run_.states.losses(i);
    if (!slave.present || was_away) {
      if (!track.returning || track.given_up) track = {.losses = track.losses};
      if (!track.returning) track.next_try = now + kFirstWait;
      track.returning = true;
    }
    if (!slave.present) continue;
    if (is_behind(slave.al_status, esm_.level())) {
      track.well_since.reset();
      // Without the adapter nobody heard us: as good as a cable that was pulled, also when it was too short to be
      // missed. So it is where nobody leads the clocks; who needs them waits for that.
      if (now < fall_by_outage_ && !track.returning && !track.given_up) {
        track.returning = true;
        track.next_try = now + kFirstWait;
      }
      if (leaderless && track.returning && needs_leader(i)) track.next_try = now + kFirstWait;
      continue;
    }
    if (!track.well_since) track.well_since = now;
    track.returning = false;
    if (now - *track.well_since >= kWellPeriod) track = {.losses = track.losses, .well_since = track.well_since};
  }
}

/// Its clock goes by that of others, and has not stopped: it is none that could be set to lead them.
bool Recovery::needs_leader(std::size_t slave) const {
  const auto state = al_state_of(run_.snapshot.slaves[slave].al_status);
  return run_.config().slaves[slave].dc.has_value() && has_process_data_communication(state);
}

bool Recovery::wants_help(std::size_t slave) const {
  const auto& status = run_.snapshot.slaves[slave];
  return status.present && is_behind(status.al_status, esm_.level());
}

bool Recovery::due(std::size_t slave, Nanoseconds now) const {
  const auto& track = tracks_[slave];
  if (track.given_up || now < track.next_try || !wants_help(slave)) return false;
  if (track.returning) return comes_back(slave);
  const bool error = (run_.snapshot.slaves[slave].al_status & kAlErrorFlag) != 0;
  return error && track.tries < run_.config().recovery.error_tries;
}

// ---- what -----------------------------------------------------------------------------------------

Status Recovery::bring_all_back() {
  for (auto& track : tracks_) {
    track.given_up = false;
    track.tries = 0;
    track.next_try = 0;
  }
  return work(true, AlState::kPreop);
}

Status Recovery::work(bool on_command, AlState target) {
  const auto now = bus_.clock().now();
  SlaveList slaves;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (on_command ? tracks_[i].returning && wants_help(i) : due(i, now)) slaves.push_back(i);
  }
  if (auto status = locate(slaves); !status) return status;
  if (slaves.empty()) return {};
  std::ranges::sort(slaves);
  SlaveList anew;
  for (const auto slave : slaves) {
    auto& track = tracks_[slave];
    if (++track.tries > kTriesAsItIs) anew.push_back(slave);
    tell(slave, Stage::kBegun);
  }
  if (auto status = esm_.join(slaves, target, anew); !status) return status;
  const auto limit = std::max(kReturnTries, run_.config().recovery.error_tries);
  for (const auto slave : slaves) {
    auto& track = tracks_[slave];
    const auto& status = run_.snapshot.slaves[slave];
    const bool well = status.present && !is_behind(status.al_status, target);
    tell(slave, well ? Stage::kDone : Stage::kFailed);
    track.next_try = bus_.clock().now() + kRetryPeriod;
    if (well) {
      track.returning = false;
      continue;
    }
    const auto tries = track.returning ? limit : run_.config().recovery.error_tries;
    track.given_up = on_command || track.tries >= tries;
    if (track.given_up && !on_command) tell(slave, Stage::kGivenUp);
  }
  return {};
}

void Recovery::tell(std::size_t slave, events::RecoveryStep::Stage stage) {
  run_.teller.tell(bus_.clock().now(), static_cast<int>(slave), events::RecoveryStep{stage, tracks_[slave].tries});
}

// ---- where ----------------------------------------------------------------------------------------

/// Devices answer that nobody knows by their station address: a power-on took it from them. They are found by their
/// place between the known ones, by identity and alias.
Status Recovery::locate(SlaveList& found) {
  if (task_.slaves().answering().value_or(0) <= present_count()) return {};
  const auto is_known = [this](std::uint16_t station) { return known_by(station).has_value(); };
  auto survey = survey_bus(bus_, *task_.slaves().answering(), is_known);
  if (!survey) return tl::unexpected(survey.error());
  auto& devices = *survey;
  if (auto status = identify_groups(bus_, run_.config(), devices, is_known); !status) return status;
  match_groups(devices, found);
  std::vector<std::uint16_t> wanted, positions;
  std::size_t next = 0;  // first slave of the configuration behind the last known one
  const auto close_gap = [&](std::size_t end) {
    for (; next < end; ++next) {
      if (run_.snapshot.slaves[next].present || run_.config().hot_connect_head(next)) continue;
      wanted.push_back(static_cast<std::uint16_t>(next));
    }
    match_gap(wanted, positions, devices, found);
    wanted.clear();
    positions.clear();
  };
  for (std::size_t position = 0; position < devices.size(); ++position) {
    const auto known = known_by(devices[position].station_address);
    if (known ? run_.config().hot_connect_head(*known).has_value() : devices[position].identified_as.has_value())
      continue;  // stands anywhere
    if (!known) {
      positions.push_back(static_cast<std::uint16_t>(position));
      continue;
    }
    const auto index = *known;
    esm_.commands().set_position(index, static_cast<std::uint16_t>(position));
    close_gap(index);
    next = std::max(next, index + 1);
  }
  close_gap(run_.config().slaves.size());
  return {};
}

void Recovery::place(std::size_t slave, std::uint16_t position, SlaveList& found) {
  esm_.commands().set_position(slave, position);
  if (!tracks_[slave].given_up) found.push_back(slave);
}

/// Hot-connect groups, wherever they were connected: a head is known by what it is asked for, the others stand behind
/// it, in their order. What belongs to one is marked as identified.
void Recovery::match_groups(std::vector<FoundDevice>& devices, SlaveList& found) {
  const auto& config = run_.config();
  for (std::size_t head = 0; head < config.slaves.size(); ++head) {
    const auto& group = config.slaves[head].hot_connect;
    if (!group) continue;
    auto at = find_head(devices, head);
    bool is_gap = false;
    const auto members = std::min<std::size_t>(group->member_count, config.slaves.size() - head);
    for (std::size_t slave = head; at && slave < head + members; ++slave) {
      if (run_.snapshot.slaves[slave].present) {
        at = place_of(devices, slave).value_or(*at) + 1;
        is_gap = false;
      } else if (!is_gap && is_new(devices, *at, slave) && devices[*at].identified_as.value_or(slave) == slave) {
        devices[*at].identified_as = static_cast<std::uint16_t>(slave);
        place(slave, static_cast<std::uint16_t>(*at), found);
        ++*at;
      } else {
        is_gap = true;  // who hangs behind one that is missing is missing, too
      }
    }
  }
}

/// Place of a group's head, whether it was there all the time or came just now.
std::optional<std::size_t> Recovery::find_head(std::span<const FoundDevice> devices, std::size_t head) const {
  if (run_.snapshot.slaves[head].present) return place_of(devices, head);
  const auto alias = run_.config().slaves[head].hot_connect->alias();
  for (std::size_t at = 0; at < devices.size(); ++at) {
    const bool is_head = alias ? devices[at].alias == *alias && is_new(devices, at, head)  //
                               : devices[at].identified_as == head;
    if (is_head) return at;
  }
  return std::nullopt;
}

/// Nobody knows the device at this place, and it may be this slave.
bool Recovery::is_new(std::span<const FoundDevice> devices, std::size_t at, std::size_t slave) const {
  return at < devices.size() && !known_by(devices[at].station_address) &&
         is_same_device(wanted_device(run_.config(), slave), devices[at]);
}

std::optional<std::size_t> Recovery::place_of(std::span<const FoundDevice> devices, std::size_t slave) const {
  const auto station = run_.config().slaves[slave].station_address;
  const auto device = std::ranges::find(devices, station, &FoundDevice::station_address);
  if (device == devices.end()) return std::nullopt;
  return static_cast<std::size_t>(device - devices.begin());
}

/// The slave that is there and has this station address.
std::optional<std::size_t> Recovery::known_by(std::uint16_t station) const {
  const auto& slaves = run_.config().slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (slaves[i].station_address == station && run_.snapshot.slaves[i].present) return i;
  }
  return std::nullopt;
}

void Recovery::match_gap(std::span<const std::uint16_t> wanted, std::span<const std::uint16_t> positions,
                         std::span<const FoundDevice> devices, SlaveList& found) {
  std::vector<WantedDevice> want;
  std::vector<FoundDevice> there;
  for (const auto slave : wanted) want.push_back(wanted_device(run_.config(), slave));
  for (const auto position : positions) there.push_back(devices[position]);
  const auto match = match_bus(want, there);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!match.position[i]) continue;
    place(wanted[i], positions[*match.position[i]], found);
  }
  for (std::size_t i = 0; i < there.size(); ++i) {
    const bool taken = std::ranges::any_of(match.position, [&](const auto& p) { return p == i; });
    const auto& identity = there[i].identity;
    const auto key = (std::uint64_t{identity.vendor_id} << 32) | identity.product_code;
    if (taken || !told_unknown_.emplace(positions[i], key).second) continue;
    run_.teller.tell(bus_.clock().now(), positions[i], events::UnknownSlave{identity});
  }
}

}  // namespace syncline
