// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "compare/difference_list.h"
#include "config/command_text.h"
#include "config/mailbox_config.h"
#include "config/slave_config.h"
#include "config/startup_messages.h"

namespace syncline::comparison {
namespace {

using Group = DifferenceGroup;

std::string pdo_list(const std::vector<std::uint16_t>& pdos) {
  std::string out;
  for (const std::uint16_t pdo : pdos) out += fmt::format("{}0x{:04x}", out.empty() ? "" : " ", pdo);
  return out.empty() ? "none" : out;
}

std::string optional_number(const std::optional<std::uint32_t>& value) {
  return value ? fmt::format("{}", *value) : "none";
}

const ConfiguredSyncManager* manager(const SlaveConfig& slave, unsigned number) {
  const auto found = std::ranges::find(slave.sync_managers, number, &ConfiguredSyncManager::number);
  return found == slave.sync_managers.end() ? nullptr : &*found;
}

constexpr const char* kNotDescribed = "not described";

const ConfiguredPdo* described(const SlaveConfig& slave, std::uint16_t index) {
  const auto pdo = std::ranges::find_if(slave.pdos, [&](const ConfiguredPdo& p) { return p.pdo.index == index; });
  return pdo == slave.pdos.end() ? nullptr : &*pdo;
}

/// Mapping of a PDO as entries without names.
std::string mapping(const ConfiguredPdo* pdo) {
  if (pdo == nullptr) return kNotDescribed;
  std::string out;
  for (const PdoEntry& entry : pdo->pdo.entries) {
    out += fmt::format("{}0x{:04x}:{:02x}/{}", out.empty() ? "" : " ", entry.index, entry.sub_index, entry.bit_length);
  }
  return out.empty() ? "empty" : out;
}

/// Tools leave out a limit, or write 0 for none; some leave out the size.
std::string sizes(const SyncManagerDescription& manager, bool with_default) {
  return fmt::format("{} to {} bytes{}", manager.min_size.value_or(0), manager.max_size.value_or(0),
                     with_default ? fmt::format(", {} by default", manager.default_size.value_or(0)) : "");
}

void compare_manager(const ConfiguredSyncManager& left, const ConfiguredSyncManager& right, DifferenceList& out) {
  const auto field = [&](FindingSentence<words::kDifferences, FigureName("sm")> sentence, const std::string& one,
                         const std::string& other) {
    if (one != other) out.add(Group::kProcessData, what(sentence, fig::number<"sm">(left.number)), one, other);
  };
  const SyncManagerDescription& l = left.description;
  const SyncManagerDescription& r = right.description;
  field("difference-sm/pdos", pdo_list(left.pdos), pdo_list(right.pdos));
  field("difference-sm-settings/type", fmt::format("{}", static_cast<int>(l.type)),
        fmt::format("{}", static_cast<int>(r.type)));
  field("difference-sm-settings/start", fmt::format("0x{:04x}", l.start_address),
        fmt::format("0x{:04x}", r.start_address));
  field("difference-sm-settings/control", fmt::format("0x{:02x}", l.control_byte),
        fmt::format("0x{:02x}", r.control_byte));
  field("difference-sm-settings", l.enable ? "yes" : "no", r.enable ? "yes" : "no");
  field("difference-sm-settings/op-only", l.op_only ? "yes" : "no", r.op_only ? "yes" : "no");
  const bool both = l.default_size && r.default_size && l.default_size != r.default_size;
  field("difference-sm/sizes", sizes(l, both), sizes(r, both));
  field("difference-sm-settings/watchdog", optional_number(left.watchdog), optional_number(right.watchdog));
}

std::string bits(const std::optional<ImageRange>& range) {
  return range ? fmt::format("{} bits", range->bit_length) : "none";
}

std::string channel(const MailboxChannel& mailbox) {
  return fmt::format("{} bytes at 0x{:04x}{}", mailbox.length, mailbox.start, mailbox.short_send ? ", short" : "");
}
std::string channel(const std::optional<MailboxChannel>& mailbox) { return mailbox ? channel(*mailbox) : "none"; }

std::string protocols(const MailboxConfig& m) {
  std::string out;
  const std::pair<bool, const char*> all[] = {{m.aoe, "AoE"}, {m.eoe, "EoE"}, {m.coe, "CoE"},
                                              {m.foe, "FoE"}, {m.soe, "SoE"}, {m.voe, "VoE"}};
  for (const auto& [has, name] : all) {
    if (has) out += fmt::format("{}{}", out.empty() ? "" : " ", name);
  }
  return out.empty() ? "none" : out;
}

/// A start-up command as one line: what is written, and everything that matters about it.
struct StartupLine {
  std::string what;
  std::string value;
  bool operator==(const StartupLine&) const = default;
};

template <class Cmd>
std::string value_text(const Cmd& cmd) {
  return fmt::format("{}{}{}", cmd.data.empty() ? "nothing" : hex_text(cmd.data),
                     cmd.timeout_ms ? fmt::format(", {} ms", cmd.timeout_ms) : "", cmd.enabled ? "" : ", disabled");
}

/// Assignment and mapping of PDOs.
bool is_pdo_object(std::uint16_t index) {
  return (index >= 0x1C10 && index <= 0x1C2F) || (index >= 0x1600 && index <= 0x17FF) ||
         (index >= 0x1A00 && index <= 0x1BFF);
}

std::vector<StartupLine> startup_lines(const std::optional<MailboxConfig>& mailbox, bool with_pdos) {
  std::vector<StartupLine> out;
  if (!mailbox) return out;
  for (const CoeInitCmd& cmd : mailbox->coe_commands) {
    if (!with_pdos && is_pdo_object(cmd.command.index)) continue;
    out.push_back(
        {fmt::format("0x{:04X}:{:02X}{} ({})", cmd.command.index, cmd.command.sub_index,
                     cmd.command.complete_access ? " complete" : "", transitions_text(cmd.command.transitions)),
         value_text(cmd.command) + (cmd.ccs == 1 ? "" : fmt::format(", specifier {}", cmd.ccs))});
  }
  for (const SoeInitCmd& cmd : mailbox->soe_commands) {
    out.push_back({fmt::format("SoE drive {} IDN {}, operation {}, elements {} attribute {} ({})", cmd.drive_no,
                               cmd.idn, cmd.op_code, cmd.elements, cmd.attribute, transitions_text(cmd.transitions)),
                   value_text(cmd)});
  }
  for (const auto& protocol : kMessageProtocols) {
    for (const MailboxInitCmd& cmd : (*mailbox).*protocol.commands) {
      out.push_back({fmt::format("{} ({})", protocol.name, transitions_text(cmd.transitions)), value_text(cmd)});
    }
  }
  return out;
}

/// Same object written several times counts in order: the n-th write of the one with the n-th of the other.
void compare_startup(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) {
  // Other PDOs need other start-up commands: those are told already.
  const bool with_pdos = !out.has(Group::kProcessData);
  const auto l = startup_lines(left.mailbox, with_pdos);
  const auto r = startup_lines(right.mailbox, with_pdos);
  if (l == r) return;
  std::map<std::string, std::vector<const StartupLine*>> open;
  for (auto line = r.rbegin(); line != r.rend(); ++line) open[line->what].push_back(&*line);
  std::vector<const StartupLine*> order;
  bool same_set = true;
  for (const StartupLine& line : l) {
    auto& counterparts = open[line.what];
    if (counterparts.empty()) {
      same_set = false;
      out.add(Group::kStartup, what("difference-start-up-command", fig::text<"command">(line.what)), line.value, "");
      continue;
    }
    const StartupLine* other = counterparts.back();
    counterparts.pop_back();
    order.push_back(other);
    if (other->value != line.value) {
      out.add(Group::kStartup, what("difference-start-up-command", fig::text<"command">(line.what)), line.value,
              other->value);
    }
  }
  for (const StartupLine& line : r) {
    const auto& rest = open[line.what];
    if (std::ranges::find(rest, &line) == rest.end()) continue;
    same_set = false;
    out.add(Group::kStartup, what("difference-start-up-command", fig::text<"command">(line.what)), "", line.value);
  }
  if (same_set && !std::ranges::is_sorted(order)) {
    out.add(Group::kStartup, "difference-start-up-commands-come-in-another-order", "", "");
  }
}

/// A PDO that a SyncManager of either side carries.
void compare_pdo(const SlaveConfig& left, const SlaveConfig& right, std::uint16_t index, DifferenceList& out) {
  const ConfiguredPdo* l = described(left, index);
  const ConfiguredPdo* r = described(right, index);
  // One that is described on one side only is told with the assignment, where that is another; a tool that describes
  // none says nothing.
  if ((l == nullptr || r == nullptr) && (out.has(Group::kProcessData) || left.pdos.empty() || right.pdos.empty()))
    return;
  if (const std::string one = mapping(l), other = mapping(r); one != other)
    out.add(Group::kProcessData, what("difference-pdo", fig::hex<"pdo">(index)), one, other);
  // Tools may leave out the one or the other way to say it.
  if (l != nullptr && r != nullptr && l->pdo.sync_manager && r->pdo.sync_manager &&
      *l->pdo.sync_manager != *r->pdo.sync_manager) {
    out.add(Group::kProcessData, what("difference-pdo/sm", fig::hex<"pdo">(index)),
            fmt::format("SM{}", *l->pdo.sync_manager), fmt::format("SM{}", *r->pdo.sync_manager));
  }
}

}  // namespace

void compare_process_data(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) {
  std::set<std::uint16_t> assigned;
  for (unsigned number = 0; number < 16; ++number) {
    const ConfiguredSyncManager* l = manager(left, number);
    const ConfiguredSyncManager* r = manager(right, number);
    if (l) assigned.insert(l->pdos.begin(), l->pdos.end());
    if (r) assigned.insert(r->pdos.begin(), r->pdos.end());
    if (l && r) {
      compare_manager(*l, *r, out);
    } else if (l || r) {
      out.add(Group::kProcessData, what("difference-sm", fig::number<"sm">(number)), l ? pdo_list(l->pdos) : "",
              r ? pdo_list(r->pdos) : "");
    }
  }
  for (const std::uint16_t pdo : assigned) compare_pdo(left, right, pdo, out);
  if (!out.has(Group::kProcessData)) {
    out.field(Group::kProcessData, "difference-outputs", bits(left.send), bits(right.send));
    out.field(Group::kProcessData, "difference-inputs", bits(left.receive), bits(right.receive));
  }
}

void compare_mailbox(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) {
  if (left.mailbox.has_value() != right.mailbox.has_value()) {
    return out.flag(Group::kMailbox, "difference-mailbox", left.mailbox.has_value(), right.mailbox.has_value());
  }
  if (!left.mailbox) return;
  const MailboxConfig& l = *left.mailbox;
  const MailboxConfig& r = *right.mailbox;
  out.field(Group::kMailbox, "difference-mailbox-for-requests", channel(l.send), channel(r.send));
  out.field(Group::kMailbox, "difference-mailbox-for-answers", channel(l.receive), channel(r.receive));
  out.field(Group::kMailbox, "difference-bootstrap-mailbox-for-requests", channel(l.bootstrap_send),
            channel(r.bootstrap_send));
  out.field(Group::kMailbox, "difference-bootstrap-mailbox-for-answers", channel(l.bootstrap_receive),
            channel(r.bootstrap_receive));
  out.field(Group::kMailbox, "difference-mailbox-protocols", protocols(l), protocols(r));
  out.flag(Group::kMailbox, "difference-data-link-layer-of-the-mailbox", l.data_link_layer, r.data_link_layer);
  // Which bit it is follows from the slaves before it.
  out.flag(Group::kMailbox, "difference-mailbox-state-bit", l.status_bit_address.has_value(),
           r.status_bit_address.has_value());
  out.field(Group::kMailbox, "difference-mailbox-poll-time", optional_number(l.poll_time_ms),
            optional_number(r.poll_time_ms));
  out.field(Group::kMailbox, "difference-aoe-address", l.aoe_net_id, r.aoe_net_id);
  out.flag(Group::kMailbox, "difference-eoe-switched-off", l.eoe_disabled, r.eoe_disabled);
  compare_startup(left, right, out);
}

void compare_clocks(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) {
  if (left.dc.has_value() != right.dc.has_value()) {
    return out.flag(Group::kClocks, "difference-distributed-clocks", left.dc.has_value(), right.dc.has_value());
  }
  if (!left.dc) return;
  const SlaveDcConfig& l = *left.dc;
  const SlaveDcConfig& r = *right.dc;
  out.flag(Group::kClocks, "difference-reference-clock", l.reference_clock, r.reference_clock);
  out.flag(Group::kClocks, "difference-possible-reference-clock", l.potential_reference_clock,
           r.potential_reference_clock);
  out.field(Group::kClocks, "difference-activation", fmt::format("0x{:04x}", l.assign_activate),
            fmt::format("0x{:04x}", r.assign_activate));
  out.time(Group::kClocks, "difference-sync0-cycle", l.cycle_time0, r.cycle_time0);
  out.time(Group::kClocks, "difference-sync1-behind-sync0", l.cycle_time1, r.cycle_time1);
  out.time(Group::kClocks, "difference-sync0-shift", l.shift_time, r.shift_time);
}

}  // namespace syncline::comparison
