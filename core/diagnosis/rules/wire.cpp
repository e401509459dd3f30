// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "channels/values/miss_cause.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "protocol/al_state.h"
#include "protocol/port_damage.h"
#include "protocol/registers.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

using Unit = Figure::Unit;

constexpr std::size_t kPorts = 4;

/// The neighbour at the other end of a port's cable, as the configuration wires it; -1: the host, -2: nobody.
Figure behind(const RunReport& report, const RunReport::Slave& slave, std::size_t port) {
  Figure figure{"behind", Unit::kSlave, slave.parent, slave.parent};
  if (port == 0) return figure;
  const auto child = std::ranges::find_if(report.slaves, [&](const RunReport::Slave& other) {
    return other.parent == slave.position && other.parent_port == static_cast<int>(port);
  });
  figure.value = figure.other = child == report.slaves.end() ? -2 : child->position;
  return figure;
}

void find_damage(const RunReport& report, const RunReport::Slave& slave, std::size_t port, Findings& findings) {
  const auto& spells = report.history.slaves[slave.position].port_errors[port];
  if (spells.empty()) return;
  const auto& errors = slave.evidence.ports[port];
  findings.push_back({code::kPortErrors,
                      Severity::kWarning,
                      slave.position,
                      spells.first(),
                      spells.last(),
                      {slave_figure(report, slave.position),
                       {"port", Unit::kPort, static_cast<std::int64_t>(port)},
                       count_figure("count", spells.count(), errors.at_least),
                       text_figure("register", fmt::format("{:04X}", reg::kRxErrorCounter + 2 * port)),
                       moment_figure(report, "since", spells.first()),
                       behind(report, slave, port)}});
}

void find_lost_link(const RunReport& report, const RunReport::Slave& slave, std::size_t port, Findings& findings) {
  const auto& spells = report.history.slaves[slave.position].lost_links[port];
  if (spells.empty()) return;
  const bool pluggable = std::ranges::any_of(report.slaves, [&](const RunReport::Slave& other) {
    return other.optional && other.parent == slave.position && other.parent_port == static_cast<int>(port);
  });
  if (pluggable || slave.optional) return;
  findings.push_back({code::kLinkLost,
                      Severity::kWarning,
                      slave.position,
                      spells.first(),
                      spells.last(),
                      {slave_figure(report, slave.position),
                       {"port", Unit::kPort, static_cast<std::int64_t>(port)},
                       times_figure("count", spells.count(), slave.evidence.ports[port].at_least),
                       text_figure("register", fmt::format("{:04X}", reg::kLostLinkCounter + port)),
                       moment_figure(report, "last", spells.last())}});
}

struct Losses {
  std::uint64_t count = 0, most = 0;
  Nanoseconds first = 0, last = 0;
  void add(const Spell& spell) {
    if (spell.count == 0) return;  // all came late
    if (count == 0) first = spell.from;
    count += spell.count;
    most = std::max(most, spell.count);
    last = spell.to;
  }
};

Finding lost(const RunReport& report, std::string_view code, Severity severity, int slave, const Losses& losses) {
  return {code,
          severity,
          code == code::kFramesLostByNoise ? slave : -1,
          losses.first,
          losses.last,
          {count_figure("count", losses.count), count_figure("most", losses.most),
           moment_figure(report, "since", losses.first), slave_figure(report, slave)}};
}

/// What the slaves' own counters prove of where lost frames were lost.
struct LostAt {
  std::string_view code = code::kFramesLost;  // nothing
  int slave = -1;
};

/// Some time of the run, and not only as it seemed.
bool was_away(const RunReport& report, const RunHistory::Slave& slave) {
  return !std::ranges::all_of(slave.absences.list(),
                              [&](const Spell& absence) { return was_seeming(report, absence); });
}

/// Behind the last in frame order whose counter says that it had its outputs all the same, or in front of the first one
/// that counts, when all of them have missed theirs. Only who was in OP all the time since counts every frame, of those
/// that were lost in OP, and only a cycle of one frame has all outputs in that which was lost. Where frames are lost
/// here and there, each slave has missed some of them, and there is no such place.
LostAt place_of(const RunReport& report, const Losses& losses) {
  constexpr std::uint64_t kEnough = 4;                    // fewer may have fallen into other times
  constexpr std::uint64_t kHadThem = 8, kMissedThem = 2;  // an eighth of them at most, and half of them at least
  constexpr auto kFrameLost = static_cast<std::size_t>(dc::MissCause::kFrameLost);
  int last = -1, first_without = -1;
  const auto& history = report.history;
  if (!history.reached_op || losses.first < history.op_reached || report.wire_time != report.first_wire_time) return {};
  for (const auto& slave : report.slaves) {
    const auto& missed = slave.sm2_missed;
    const bool counts =
        slave.sync0_cycle > 0 && missed && missed->known && missed->valid && missed->time + kReadLater >= losses.last;
    const bool in_op = slave.present && al_state_of(slave.al_status) == AlState::kOp;
    const auto& past = history.slaves[slave.position];
    if (!counts || !in_op || past.fall || was_away(report, past)) continue;
    const std::uint64_t lost = missed->by_cause[kFrameLost];
    if (kHadThem * lost <= losses.count) {
      if (first_without >= 0) return {};
      last = slave.position;
    } else if (kMissedThem * lost < losses.count) {
      return {};
    } else if (first_without < 0) {
      first_without = slave.position;
    }
  }
  if (last >= 0) return losses.count < kEnough ? LostAt{} : LostAt{code::kFramesLostBehind, last};
  return first_without < 0 ? LostAt{} : LostAt{code::kFramesLostInFront, first_without};
}

/// So many frames were damaged in the spell at most: no more of those that were lost can have been.
std::uint64_t damaged_in(const RunReport& report, const Spell& spell) {
  std::uint64_t count = 0;
  for (const auto& slave : report.slaves) {
    for (std::size_t port = 0; port < kPorts; ++port) {
      for (const auto& damage : report.history.slaves[slave.position].damage[port].list()) {
        if (damage.from > spell.to + kTogether || spell.from > damage.to + kTogether) continue;
        if (slave.evidence.ports[port].at_least) return UINT64_MAX;
        count += damage.count;
      }
    }
  }
  return count;
}

/// The error counters of some slave have not been read since: nobody knows what they say.
bool is_unread(const RunReport& report, const Spell& spell) {
  return std::ranges::any_of(report.slaves, [&](const RunReport::Slave& slave) {
    return slave.present && slave.evidence.ports_time != 0 && slave.evidence.ports_time < spell.to;
  });
}

}  // namespace

void find_port_errors(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    for (std::size_t port = 0; port < kPorts; ++port) {
      find_damage(report, slave, port, findings);
      find_lost_link(report, slave, port, findings);
    }
  }
}

/// Only the first slave sees them as they come; a cable that is plugged and a frame that was damaged count there, too.
void find_foreign_frames(const RunReport& report, Findings& findings) {
  const auto first =
      std::ranges::find_if(report.slaves, [](const RunReport::Slave& slave) { return slave.parent < 0; });
  if (first == report.slaves.end()) return;
  const auto& history = report.history;
  const auto explained = [&](const Spell& spell) {
    const Spell around{spell.from - kReadLater, spell.to, 0, 0};
    const auto by_slave = [&](const RunHistory::Slave& slave) {
      const auto near = [&](const Spells& port) { return port.near(around, kReadLater); };
      return slave.absences.near(around, kReadLater) || std::ranges::any_of(slave.port_errors, near) ||
             std::ranges::any_of(slave.lost_links, near);
    };
    return adapter_was_away(report, around) || std::ranges::any_of(history.slaves, by_slave);
  };
  Spells foreign;
  for (const auto& spell : history.slaves[first->position].unprocessed.list()) {
    if (!explained(spell)) foreign.note(spell.to, spell.count, 0, spell.from);
  }
  if (foreign.empty()) return;
  const bool at_least = first->evidence.processing_unit_errors.at_least;
  findings.push_back({code::kForeignFrames,
                      Severity::kWarning,
                      first->position,
                      foreign.first(),
                      foreign.last(),
                      {slave_figure(report, first->position), count_figure("count", foreign.count(), at_least),
                       moment_figure(report, "since", foreign.first())}});
}

void find_lost_frames(const RunReport& report, Findings& findings) {
  Losses by_host, by_noise, by_slave, by_link, unread, unexplained;
  DamagedPort noisy;
  int gone = -1, unplugged = -1;
  const auto all_damaged = damaged_in(report, {0, INT64_MAX - kTogether, 0, 0});
  for (auto spell : report.history.lost_frames.list()) {
    if (adapter_was_away(report, spell)) continue;  // those that were under way at that moment
    if (report.history.stalls.near(spell, kTogether)) {
      by_host.add(spell);
      continue;
    }
    if (const auto port = noisy_port(report, spell); port.slave >= 0) {
      if (noisy.slave < 0) noisy = port;
      auto damaged = spell;
      const auto left = all_damaged - std::min(all_damaged, by_noise.count);
      damaged.count = std::min({spell.count, damaged_in(report, spell), left});
      by_noise.add(damaged);
      spell.count -= damaged.count;
      if (spell.count == 0) continue;
    }
    const auto& slaves = report.history.slaves;
    const auto away = std::ranges::find_if(slaves, [&](const RunHistory::Slave& slave) {
      return slave.absences.near(spell, 200 * kMillisecond) && was_away(report, slave);
    });
    if (away == slaves.end()) {
      if (const auto link = lost_link_after(report, spell); link >= 0) {
        if (unplugged < 0) unplugged = link;
        by_link.add(spell);
      } else {
        (is_unread(report, spell) ? unread : unexplained).add(spell);
      }
    } else {
      if (gone < 0) gone = static_cast<int>(away - slaves.begin());
      by_slave.add(spell);
    }
  }
  if (unexplained.count > 0) {
    const auto [code, slave] = place_of(report, unexplained);
    findings.push_back(lost(report, code, Severity::kWarning, slave, unexplained));
    findings.back().place.slave = slave;
  }
  if (by_noise.count > 0) {
    findings.push_back(lost(report, code::kFramesLostByNoise, Severity::kWarning, noisy.slave, by_noise));
    findings.back().figures.push_back({"port", Unit::kPort, static_cast<std::int64_t>(noisy.port)});
  }
  if (by_host.count > 0) findings.push_back(lost(report, code::kFramesLostByHost, Severity::kWarning, -1, by_host));
  if (by_link.count > 0) {
    findings.push_back(lost(report, code::kFramesLostByCable, Severity::kNote, unplugged, by_link));
    findings.back().facts = sentence_of(*find_finding_words(code::kFramesLostByCable), "link");
  }
  if (unread.count > 0) findings.push_back(lost(report, code::kFramesLostLast, Severity::kNote, -1, unread));
  if (by_slave.count > 0) findings.push_back(lost(report, code::kFramesLostByCable, Severity::kNote, gone, by_slave));
  const auto& late = report.history.late_frames;
  // What lay in the card while it was away comes when it is back.
  const bool by_outage =
      std::ranges::all_of(late.list(), [&](const Spell& spell) { return adapter_was_away(report, spell); });
  if (!late.empty() && report.late_frames > 0 && !by_outage) {
    const bool host = std::ranges::all_of(
        late.list(), [&](const Spell& spell) { return report.history.stalls.near(spell, kTogether); });
    findings.push_back({code::kFramesLate,
                        host ? Severity::kNote : Severity::kWarning,
                        -1,
                        late.first(),
                        late.last(),
                        {count_figure("count", report.late_frames), time_figure("largest", late.largest())}});
  }
}

}  // namespace syncline::diagnosis
