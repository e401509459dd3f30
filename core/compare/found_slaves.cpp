// SPDX-License-Identifier: Apache-2.0
#include "compare/found_slaves.h"

#include <algorithm>
#include <set>

#include "compare/replaced_slave.h"
#include "compare/slave_pairing.h"
#include "config/slave_edits.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

/// A slave of the result and where it comes from.
struct Source {
  std::optional<std::size_t> ours, found;
  FoundKind kind = FoundKind::kMatched;
  bool taken = false;
  /// The slave is what the bus has, not what the project had there.
  [[nodiscard]] bool is_new() const { return !ours || (taken && kind == FoundKind::kOtherDevice); }
};

std::vector<SlaveKey> keys_of(const Project& project) {
  std::vector<SlaveKey> keys;
  for (const auto& slave : project.slaves) {
    keys.push_back({slave.device.identity, {}});
    keys.back().identity.serial_no = 0;
  }
  return keys;
}

/// Whether the slave hangs on the counterpart of what the other one hangs on.
bool same_wiring(const Project& ours, const Project& found, const SlavePairing& pairs, std::size_t left,
                 std::size_t right) {
  const auto& a = ours.slaves[left].previous;
  const auto& b = found.slaves[right].previous;
  if (!a || !b) return a.has_value() == b.has_value();
  return a->port == b->port && a->position < pairs.right_of.size() && pairs.right_of[a->position] == b->position;
}

FoundKind kind_of(const Project& ours, const Project& found, const SlavePairing& pairs, std::size_t left,
                  std::size_t right, bool moved) {
  const auto& a = ours.slaves[left].device.identity;
  const auto& b = found.slaves[right].device.identity;
  if (a.vendor_id != b.vendor_id || a.product_code != b.product_code) return FoundKind::kOtherDevice;
  if (a.revision_no != b.revision_no) return FoundKind::kRevision;
  if (moved) return FoundKind::kMoved;
  return same_wiring(ours, found, pairs, left, right) ? FoundKind::kMatched : FoundKind::kRewired;
}

bool in_place_of_bus(const FoundSlave& line, bool take) { return line.ours.has_value() && (take || !line.moved); }

/// The slaves of the result, in its order.
std::vector<Source> arrange(const Project& ours, std::span<const FoundSlave> lines, const std::vector<bool>& take) {
  std::vector<Source> sources;
  std::vector<bool> placed(ours.slaves.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    if (!line.found) {
      if (take[i]) placed[*line.ours] = true;  // goes
      continue;
    }
    if (!in_place_of_bus(line, take[i]) && !(line.kind == FoundKind::kExtra && take[i])) continue;
    sources.push_back({line.ours, line.found, line.kind, take[i]});
    if (line.ours) placed[*line.ours] = true;
  }
  // The others stay behind the slave behind which they were.
  for (std::size_t position = 0; position < ours.slaves.size(); ++position) {
    if (placed[position]) continue;
    auto place = sources.begin();
    for (std::size_t before = position; before-- > 0 && place == sources.begin();) {
      const auto found = std::ranges::find(sources, std::optional(before), &Source::ours);
      if (found != sources.end()) place = found + 1;
    }
    sources.insert(place, {position, {}, FoundKind::kMissing, false});
  }
  return sources;
}

/// Where `wanted` of one of the two projects is in the result.
std::optional<std::uint16_t> place_of(const std::vector<Source>& sources, std::optional<std::size_t> Source::*from,
                                      std::size_t wanted) {
  const auto found = std::ranges::find(sources, std::optional(wanted), from);
  if (found == sources.end()) return std::nullopt;
  return static_cast<std::uint16_t>(found - sources.begin());
}

std::optional<PreviousPort> wiring_of(const Project& ours, const Project& found, const std::vector<Source>& sources,
                                      std::size_t place) {
  const auto& source = sources[place];
  const bool from_bus = source.found && (source.taken || !source.ours || source.kind == FoundKind::kMatched);
  const auto& wanted = from_bus ? found.slaves[*source.found].previous : ours.slaves[*source.ours].previous;
  if (!wanted && place == 0) return std::nullopt;
  const auto at = wanted ? place_of(sources, from_bus ? &Source::found : &Source::ours, wanted->position)
                         : std::optional<std::uint16_t>{};
  if (at && *at != place) return PreviousPort{*at, wanted->port};
  if (place == 0) return std::nullopt;
  return PreviousPort{static_cast<std::uint16_t>(place - 1), 1};  // what it hung on is gone: behind the one in front
}

/// Of two slaves with one address the one that came from the bus gets another: the next that is free, 0 being none. A
/// name that tells the address follows it, and no slave that comes in is called like another.
void make_unique(Project& project, const std::vector<Source>& sources) {
  std::set<std::uint16_t> used;
  std::set<std::string> names;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!sources[i].is_new()) names.insert(project.slaves[i].name);
  }
  for (const bool own : {true, false}) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (sources[i].ours.has_value() != own) continue;
      auto& slave = project.slaves[i];
      const bool had_default = slave.name == default_name(slave.station_address, slave.device);
      slave.station_address = take_address(used, slave.station_address);
      if (!sources[i].is_new()) continue;
      slave.name = take_name(names, had_default ? default_name(slave.station_address, slave.device) : slave.name);
    }
  }
}

}  // namespace

std::vector<FoundSlave> compare_found(const Project& ours, const Project& found) {
  const auto pairs = pair_slaves(keys_of(ours), keys_of(found));
  std::vector<FoundSlave> lines;
  std::size_t next = 0;      // of ours
  std::size_t in_order = 0;  // the last of ours that stands in the order of the bus
  const auto missing_until = [&](std::size_t end) {
    for (; next < end; ++next) {
      if (!pairs.right_of[next]) lines.push_back({FoundKind::kMissing, next, {}});
    }
  };
  for (std::size_t right = 0; right < found.slaves.size(); ++right) {
    const auto left = pairs.left_of[right];
    if (!left) {
      lines.push_back({FoundKind::kExtra, {}, right});
      continue;
    }
    const bool moved = pairs.moved[*left] || *left < in_order;
    if (!moved) {
      missing_until(*left);
      in_order = *left;
    }
    lines.push_back({kind_of(ours, found, pairs, *left, right, moved), left, right, moved});
  }
  missing_until(ours.slaves.size());
  return lines;
}

TakenOver take_over(const Project& ours, const Project& found, std::span<const FoundSlave> lines,
                    const std::vector<bool>& take) {
  const auto sources = arrange(ours, lines, take);
  TakenOver out;
  out.project = ours;
  out.project.slaves.clear();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& source = sources[i];
    std::vector<const settings::Setting*> lost;
    if (source.taken && source.kind == FoundKind::kRevision) {
      auto replaced = replaced_slave(ours.slaves[*source.ours], found.slaves[*source.found], Carry::kAll);
      out.project.slaves.push_back(std::move(replaced.slave));
      lost = std::move(replaced.lost);
    } else {
      out.project.slaves.push_back(source.is_new() ? found.slaves[*source.found] : ours.slaves[*source.ours]);
    }
    for (const auto* setting : lost) {
      if (const auto key = settings::key_of(*setting, {.slave = i}); std::ranges::find(out.lost, key) == out.lost.end())
        out.lost.push_back(key);
    }
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    out.project.slaves[i].previous = wiring_of(ours, found, sources, i);
  }
  auto& reference = out.project.master.dc.reference_clock;
  if (reference) reference = place_of(sources, &Source::ours, *reference);
  make_unique(out.project, sources);
  return out;
}

}  // namespace syncline
