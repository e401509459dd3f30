// SPDX-License-Identifier: Apache-2.0
#include "compile/pdo_findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/finding_list.h"
#include "compile/slave_plan.h"
#include "config/dc_description.h"
#include "config/object_description.h"
#include "config/pdo_description.h"
#include "config/slave_settings.h"

namespace syncline::compiler {
namespace {

struct Assignment {
  PdoDirection direction;
  const char* key;
  const std::vector<std::uint16_t>& chosen;
};

bool contains(const std::vector<std::uint16_t>& indices, std::uint16_t index) {
  return std::ranges::find(indices, index) != indices.end();
}

void check_chosen(FindingList& findings, const SlavePlan& slave, const Assignment& assignment) {
  const auto& pdos = slave.device().pdos(assignment.direction);
  for (std::size_t i = 0; i < assignment.chosen.size(); ++i) {
    const std::uint16_t index = assignment.chosen[i];
    const auto pdo = std::ranges::find(pdos, index, &Pdo::index);
    if (pdo == pdos.end()) {
      findings.add_at(assignment.key, "pdo-missing", fig::hex16<"pdo">(index));
      continue;
    }
    if (std::ranges::count(assignment.chosen, index) > 1 &&
        std::ranges::find(assignment.chosen, index) - assignment.chosen.begin() == static_cast<std::ptrdiff_t>(i)) {
      findings.add_at(assignment.key, "pdo-twice", fig::hex16<"pdo">(index));
    }
    const bool carried = std::ranges::any_of(slave.channels, [&](const auto& c) { return contains(c.pdos, index); });
    if (!carried) {
      findings.add_at(assignment.key, "pdo-without-sync-manager", fig::hex16<"pdo">(index));
    }
    for (const std::uint16_t excluded : pdo->exclude) {
      if (excluded != index && contains(assignment.chosen, excluded)) {
        findings.add_at(assignment.key, "pdo-excluded", fig::hex16<"pdo">(index), fig::hex16<"other">(excluded));
      }
    }
  }
}

void check_mandatory(FindingList& findings, const SlavePlan& slave, const Assignment& assignment) {
  for (const Pdo& pdo : slave.device().pdos(assignment.direction)) {
    if (pdo.mandatory && !contains(assignment.chosen, pdo.index)) {
      findings.add_at(assignment.key, "pdo-mandatory", fig::hex16<"pdo">(pdo.index));
    }
  }
}

/// A device is made to be told something where its ESI assigns outputs.
void check_outputs_assigned(FindingList& findings, const SlavePlan& slave) {
  const auto& pdos = slave.device().rx_pdos;
  const bool missed = std::ranges::any_of(pdos, &Pdo::mandatory);  // check_mandatory() says so
  if (!slave.settings->assigned_rx_pdos.empty() || missed) return;
  if (std::ranges::any_of(pdos, [](const Pdo& pdo) { return pdo.sync_manager.has_value(); }))
    findings.add("outputs-not-assigned");
}

/// Without the object 0x1C1x the device goes on with its own assignment, and its SyncManager length does not fit ours.
void check_assignable(FindingList& findings, const SlavePlan& slave, const Assignment& assignment) {
  const auto& mailbox = slave.device().mailbox;
  if (mailbox && mailbox->coe && mailbox->coe->pdo_assign) {
    return;
  }
  std::vector<std::uint16_t> fixed, chosen = assignment.chosen;
  for (const Pdo& pdo : slave.device().pdos(assignment.direction)) {
    if (pdo.sync_manager) {
      fixed.push_back(pdo.index);
    }
  }
  std::ranges::sort(fixed);
  std::ranges::sort(chosen);
  if (fixed != chosen) {
    findings.add_at(assignment.key, "pdo-assignment-fixed");
  }
}

void check_sizes(FindingList& findings, const SlavePlan& slave) {
  for (const auto& channel : slave.channels) {
    const char* key = channel.is_output() ? "pdo.rx" : "pdo.tx";
    const auto& description = channel.description;
    const std::uint32_t bytes = (channel.bit_length + 7) / 8;
    if (description.max_size && *description.max_size > 0 && bytes > *description.max_size) {
      findings.add_at(key, "process-data-too-long", fig::count<"bytes">(bytes),
                      fig::count<"most">(*description.max_size), fig::number<"manager">(channel.number));
    }
    if (description.min_size && bytes > 0 && bytes < *description.min_size) {
      findings.add_at(key, "process-data-too-short", fig::number<"manager">(channel.number),
                      fig::count<"least">(*description.min_size), fig::count<"bytes">(bytes));
    }
  }
}

/// The mapping and assignment objects count in one byte, and sub-index 255 is taken.
void check_counts(FindingList& findings, const SlavePlan& slave) {
  constexpr std::size_t kMost = 254;
  const auto& mailbox = slave.device().mailbox;
  if (!mailbox || !mailbox->coe) return;
  for (const auto& [direction, pdo] : slave.pdos) {
    if (mailbox->coe->pdo_config && !pdo.fixed && pdo.entries.size() > kMost) {
      findings.add_at(fmt::format("pdo.map.0x{:04x}", pdo.index), "mapping-too-long",
                      fig::count<"entries">(pdo.entries.size()), fig::hex16<"object">(pdo.index),
                      fig::count<"most">(kMost));
    }
  }
  for (const auto& channel : slave.channels) {
    if (mailbox->coe->pdo_assign && channel.pdos.size() > kMost) {
      findings.add_at(channel.is_output() ? "pdo.rx" : "pdo.tx", "assignment-too-long",
                      fig::count<"pdos">(channel.pdos.size()), fig::number<"manager">(channel.number),
                      fig::count<"most">(kMost));
    }
  }
}

/// The dictionary lists as many sub-indices of a mapping object as the device keeps room for.
void check_room(FindingList& findings, const SlavePlan& slave) {
  for (const Pdo& changed : slave.settings->changed_pdos) {
    const auto& dictionary = slave.device().dictionary;
    const auto object = std::ranges::find(dictionary, changed.index, &ObjectDescription::index);
    if (object == dictionary.end() || object->entries.empty()) continue;
    const std::size_t room = object->entries.back().sub_index;
    if (room > 0 && changed.entries.size() > room) {
      findings.add_at(fmt::format("pdo.map.0x{:04x}", changed.index), "mapping-without-room",
                      fig::count<"entries">(changed.entries.size()), fig::count<"room">(room),
                      fig::hex16<"object">(changed.index));
    }
  }
}

void check_excluded_managers(FindingList& findings, const SlavePlan& slave) {
  for (const auto& [direction, pdo] : slave.pdos) {
    const auto& excluded = pdo.excluded_sync_managers;
    if (!pdo.sync_manager || std::ranges::find(excluded, *pdo.sync_manager) == excluded.end()) continue;
    findings.add_at(direction == PdoDirection::kRx ? "pdo.rx" : "pdo.tx", "pdo-sync-manager-excluded",
                    fig::hex16<"pdo">(pdo.index), fig::number<"manager">(*pdo.sync_manager));
  }
}

void check_oversampling(FindingList& findings, const SlavePlan& slave) {
  for (const PdoOversampling& wanted : slave.settings->oversampling) {
    const Pdo* pdo = slave.find_pdo(wanted.pdo);
    const std::string key = fmt::format("pdo.oversampling.0x{:04x}", wanted.pdo);
    if (pdo == nullptr) {
      findings.add_at(key, "pdo-missing/direction-free", fig::hex16<"pdo">(wanted.pdo));
    } else if (wanted.factor < pdo->os_min.value_or(1) || wanted.factor > pdo->os_max.value_or(1000)) {
      findings.add_at(key, "oversampling-out-of-range", fig::hex16<"pdo">(wanted.pdo),
                      fig::count<"least">(pdo->os_min.value_or(1)), fig::count<"most">(pdo->os_max.value_or(1000)),
                      fig::count<"factor">(wanted.factor));
    }
  }
}

/// A mapping without an entry that the ESI fixes would be refused by the device.
void check_fixed_entries(FindingList& findings, const SlavePlan& slave) {
  for (const Pdo& changed : slave.settings->changed_pdos) {
    const Pdo* pdo = nullptr;
    for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
      const auto& pdos = slave.device().pdos(direction);
      const auto found = std::ranges::find(pdos, changed.index, &Pdo::index);
      if (found != pdos.end()) pdo = &*found;
    }
    if (pdo == nullptr) continue;
    for (const PdoEntry& entry : pdo->entries) {
      const bool kept = std::ranges::any_of(changed.entries, [&](const PdoEntry& e) {
        return e.index == entry.index && e.sub_index == entry.sub_index && e.bit_length == entry.bit_length;
      });
      if (entry.fixed && !kept) {
        findings.add_at(fmt::format("pdo.map.0x{:04x}", changed.index), "pdo-entry-fixed",
                        fig::text<"object">(fmt::format("0x{:04X}:{:02X}", entry.index, entry.sub_index)),
                        fig::hex16<"pdo">(changed.index));
      }
    }
  }
}

void check_changed(FindingList& findings, const SlavePlan& slave) {
  const auto& mailbox = slave.device().mailbox;
  const bool configurable = mailbox && mailbox->coe && mailbox->coe->pdo_config;
  for (const Pdo& changed : slave.settings->changed_pdos) {
    const Pdo* pdo = slave.find_pdo(changed.index);
    const std::string key = fmt::format("pdo.map.0x{:04x}", changed.index);
    if (pdo == nullptr) {
      findings.add_at(key, "pdo-missing/direction-free", fig::hex16<"pdo">(changed.index));
    } else if (pdo->fixed || !configurable) {
      findings.add_at(key, "mapping-fixed", fig::hex16<"pdo">(changed.index));
    }
  }
}

}  // namespace

void find_pdo_problems(FindingList& findings, const SlavePlan& slave) {
  const Assignment assignments[] = {{PdoDirection::kRx, "pdo.rx", slave.settings->assigned_rx_pdos},
                                    {PdoDirection::kTx, "pdo.tx", slave.settings->assigned_tx_pdos}};
  for (const Assignment& assignment : assignments) {
    check_chosen(findings, slave, assignment);
    check_mandatory(findings, slave, assignment);
    check_assignable(findings, slave, assignment);
  }
  check_outputs_assigned(findings, slave);
  check_sizes(findings, slave);
  check_changed(findings, slave);
  check_fixed_entries(findings, slave);
  check_excluded_managers(findings, slave);
  check_counts(findings, slave);
  check_room(findings, slave);
  check_oversampling(findings, slave);
}

}  // namespace syncline::compiler
