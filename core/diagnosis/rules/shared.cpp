// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "channels/values/absent_after.h"
#include "diagnosis/rules/rules.h"
#include "protocol/port_damage.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {

Figure slave_figure(const RunReport& report, int slave, int last) {
  (void)report;
  return {"slave", Figure::Unit::kSlave, slave, std::max(slave, last)};
}

Figure count_figure(std::string_view name, std::uint64_t count, bool at_least) {
  return {name, Figure::Unit::kCount, static_cast<std::int64_t>(count), 0, at_least ? "at least" : ""};
}

Figure times_figure(std::string_view name, std::uint64_t count, bool at_least) {
  auto figure = count_figure(name, count, at_least);
  figure.unit = Figure::Unit::kTimes;
  return figure;
}

Figure time_figure(std::string_view name, Nanoseconds length) { return {name, Figure::Unit::kNanoseconds, length}; }

Figure moment_figure(const RunReport& report, std::string_view name, Nanoseconds time) {
  const auto begin = report.told_from != 0 ? report.told_from : report.history.begin;
  return {name, Figure::Unit::kMoment, std::max<Nanoseconds>(0, time - begin)};
}

Figure phrase_figure(std::string_view name, std::string_view text) {
  return {name, Figure::Unit::kPhrase, 0, 0, std::string(text)};
}

Figure text_figure(std::string_view name, std::string text) {
  return {name, Figure::Unit::kText, 0, 0, std::move(text)};
}

Nanoseconds usual_worst_lateness(const RunReport& report) { return report.history.frame_lateness.percentile(0.999); }

Nanoseconds worst_lateness(const RunReport& report) { return report.history.frame_lateness.max(); }

Nanoseconds advised(Nanoseconds amount) {
  constexpr Nanoseconds kStep = 10 * kMicrosecond;
  return std::max(kStep, (amount + kStep - 1) / kStep * kStep);
}

bool adapter_was_away(const RunReport& report, const Spell& spell) {
  // Slaves count as absent when nothing was heard for a while, and are found one after the other.
  constexpr Nanoseconds kFollows = 500 * kMillisecond;
  return report.history.link_outages.near(spell, kFollows);
}

DamagedPort noisy_port(const RunReport& report, const Spell& spell) {
  return first_damaged_port(report.slaves.size(), [&](std::size_t slave, std::size_t port) {
    return report.history.slaves[slave].damage[port].near(spell, kTogether);
  });
}

bool was_silence_of_all(const RunReport& report, const Spell& spell) {
  constexpr Nanoseconds kFound = 100 * kMillisecond;  // one after the other
  const auto& slaves = report.history.slaves;
  const auto silent = [&](const RunReport::Slave& slave) {
    return slave.optional || slaves[slave.position].absences.near(spell, kFound);
  };
  const Spell read{spell.from, spell.to + kReadLater, 0, 0};
  return std::ranges::all_of(report.slaves, silent) && !slaves.front().lost_links.front().near(read, kReadLater);
}

bool were_held_up(const RunReport& report, const Spell& spell) {
  const Spell silence{spell.from - kAbsentAfter, spell.to, 0, 0};
  const auto lost = [&](const Spell& frames) {
    return frames.count > 0 && frames.from <= silence.to && silence.from <= frames.to;
  };
  const auto& history = report.history;
  return was_silence_of_all(report, spell) && history.late_frames.near(spell, kTogether) &&
         std::ranges::none_of(history.lost_frames.list(), lost);
}

bool was_lost_on_the_way(const RunReport& report, const Spell& silence) {
  constexpr Nanoseconds kFoundLater = kSecond;
  const auto restarted = [&](const RunHistory::Slave& slave) { return slave.restarts.near(silence, kFoundLater); };
  const Spell before{silence.from - kAbsentAfter, silence.to, 0, 0};
  return was_silence_of_all(report, silence) && report.slaves.front().evidence.ports_time >= silence.to &&
         report.history.lost_frames.near(before, 0) && std::ranges::none_of(report.history.slaves, restarted);
}

bool was_seeming(const RunReport& report, const Spell& absence) {
  return were_held_up(report, absence) || was_lost_on_the_way(report, absence);
}

bool was_absent(const RunReport& report, int slave, const Spell& spell) {
  const auto& absences = report.history.slaves[static_cast<std::size_t>(slave)].absences.list();
  return std::ranges::any_of(absences, [&](const Spell& absence) {
    return absence.from <= spell.to && spell.from <= absence.to && !was_seeming(report, absence);
  });
}

int lost_link_after(const RunReport& report, const Spell& spell) {
  const Spell read{spell.from, spell.to + kReadLater, 0, 0};
  for (const auto& slave : report.slaves) {
    const auto& ports = report.history.slaves[static_cast<std::size_t>(slave.position)].lost_links;
    const auto lost = std::ranges::find_if(ports, [&](const Spells& port) { return port.near(read, kTogether); });
    if (lost == ports.end()) continue;
    // Both ends of a cable lose it: who hangs at this port is behind it.
    const auto behind = std::ranges::find_if(report.slaves, [&](const RunReport::Slave& other) {
      return other.parent == slave.position && other.parent_port == static_cast<int>(lost - ports.begin());
    });
    return behind == report.slaves.end() ? slave.position : behind->position;
  }
  return -1;
}

bool has_other_master(const RunReport& report) {
  return std::ranges::any_of(report.history.slaves,
                             [](const RunHistory::Slave& slave) { return slave.unasked.has_value(); });
}

int slave_in_trouble(const RunReport& report, const Spell& spell) {
  constexpr Nanoseconds kNear = 500 * kMillisecond;
  for (std::size_t i = 0; i < report.history.slaves.size(); ++i) {
    const auto& slave = report.history.slaves[i];
    const bool fell = slave.fall && slave.fall->time >= spell.from - kNear && slave.fall->time <= spell.to + kNear;
    const bool away = slave.absences.near(spell, kNear) || (slave.absent && slave.absences.last() <= spell.to + kNear);
    if (fell || away) return static_cast<int>(i);
  }
  return lost_link_after(report, spell);
}

}  // namespace syncline::diagnosis
