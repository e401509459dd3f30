// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/compile/mailbox_init_cmds.h"
#include "config/settings/codecs.h"
#include "config/settings/startup_text.h"

namespace syncline::settings {
namespace {

constexpr std::uint32_t kLongestTimeoutMs = 600'000;

constexpr auto at = [](auto& project, const Place& place) -> auto& { return project.slaves[place.slave]; };

struct RevisionRuleCodec {
  using Value = RevisionCheck;
  [[nodiscard]] static std::string type() { return "choice"; }
  [[nodiscard]] static std::string range() { return "NONE, EQ, EQ_OR_G, LW_EQ, LW_EQ_HW_EQ_OR_G"; }
  [[nodiscard]] static std::string format(Value value) { return std::string(revision_check_name(value)); }
  [[nodiscard]] static Result<Value> parse(std::string_view text) {
    if (const auto rule = revision_check_from_name(text)) return *rule;
    return bad_value(fmt::format("\"{}\" is none of {}", text, range()));
  }
};

struct AddressCodec : TextCodec {
  [[nodiscard]] static std::string type() { return "IPv4 address"; }
  [[nodiscard]] static std::string range() { return "nothing, four numbers 0..255 with dots"; }
  [[nodiscard]] static Result<std::string> parse(std::string_view text) {
    if (text.empty() || compiler::ipv4_bytes(text)) return std::string(text);
    return bad_value(fmt::format("\"{}\" is no address like 192.168.1.10", text));
  }
};

struct NetIdCodec : TextCodec {
  [[nodiscard]] static std::string type() { return "AMS Net ID"; }
  [[nodiscard]] static std::string range() { return "nothing, six numbers 0..255 with dots"; }
  [[nodiscard]] static Result<std::string> parse(std::string_view text) {
    if (text.empty() || compiler::ams_net_id_bytes(text)) return std::string(text);
    return bad_value(fmt::format("\"{}\" is no address like 5.1.2.3.1.1", text));
  }
};

struct HostNameCodec : TextCodec {
  static constexpr std::size_t kBytes = 32;
  [[nodiscard]] static std::string range() { return "nothing, 1..32 bytes of text"; }
  [[nodiscard]] Result<std::string> parse(std::string_view text) const {
    if (text.size() > kBytes) return bad_value(fmt::format("a host name has at most {} bytes", kBytes));
    return TextCodec::parse(text);
  }
};

std::vector<Rule> identity_rules() {
  return {
      field_rule("slave.N.optional",
                 "The slave may be missing; it is known by its device ID or alias, and the others run without it.",
                 SwitchCodec{}, [](auto& p, const Place& place) -> auto& { return at(p, place).optional; }),
      field_rule("slave.N.check.revision_rule",
                 "How check.revision compares (ETG.2000 CheckRevisionNo): LW and HW are the low and high words, G is newer; "
                 "auto as in the ESI.",
                 AutoCodec<RevisionRuleCodec>{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).check.revision_rule; }),
      field_rule("slave.N.check.alias", "Compares the alias in the slave (0x0012) with the configured one at start-up.",
                 SwitchCodec{}, [](auto& p, const Place& place) -> auto& { return at(p, place).check.alias; }),
      field_rule("slave.N.check.device_id",
                 "Explicit device ID (switches or display of the device, ETG.1020) that is compared at start-up.",
                 AutoCodec<IntegerCodec<std::uint16_t>>{{0, 0xFFFF}, "none"},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).check.device_id; }),
  };
}

std::vector<Rule> watchdog_rules() {
  const auto rule = [](const char* name, std::string meaning, std::optional<std::uint16_t> WatchdogSettings::*field) {
    return field_rule(fmt::format("slave.N.watchdog.{}", name), std::move(meaning),
                      AutoCodec<IntegerCodec<std::uint16_t>>{{0, 0xFFFF}},
                      [field](auto& p, const Place& place) -> auto& { return at(p, place).watchdog.*field; });
  };
  return {
      rule("divider", "Watchdog divider (0x0400): unit of the watchdogs is (value + 2) * 40 ns; auto as in the ESI.",
           &WatchdogSettings::divider),
      rule("pdi", "PDI watchdog (0x0410) in units of the divider; 0 switches it off; auto as in the ESI.",
           &WatchdogSettings::pdi),
      rule("process_data", "Process data watchdog (0x0420) in units of the divider; 0 switches it off; auto as in the ESI.",
           &WatchdogSettings::process_data),
      field_rule("slave.N.watchdog.outputs",
                 "Outputs trigger the process data watchdog (control byte of their SyncManagers, bit 6); auto as in the ESI.",
                 AutoCodec<SwitchCodec>{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).watchdog.outputs; }),
  };
}

std::vector<Rule> timeout_rules() {
  const auto rule = [](const char* name, const char* what, std::optional<std::uint32_t> TimeoutSettings::*field) {
    return field_rule(fmt::format("slave.N.timeout.{}_ms", name), fmt::format("Time-out for {}; auto as in the ESI.", what),
                      AutoCodec<IntegerCodec<std::uint32_t>>{{1, kLongestTimeoutMs, "ms"}},
                      [field](auto& p, const Place& place) -> auto& { return at(p, place).timeouts.*field; });
  };
  return {
      rule("preop", "INIT to PREOP or BOOT", &TimeoutSettings::preop),
      rule("safeop_op", "PREOP to SAFEOP and SAFEOP to OP", &TimeoutSettings::safeop_op),
      rule("back_to_init", "the way back to INIT", &TimeoutSettings::back_to_init),
      rule("back_to_safeop", "OP to SAFEOP", &TimeoutSettings::back_to_safeop),
      rule("mailbox_request", "the slave to take a mailbox request", &TimeoutSettings::mailbox_request),
      rule("mailbox_response", "the slave to answer a mailbox request", &TimeoutSettings::mailbox_response),
  };
}

std::vector<Rule> mailbox_rules() {
  constexpr std::int64_t kSmallest = 24, kLargest = 1486;
  const auto size = [](const char* name, const char* what, std::optional<std::uint16_t> MailboxSettings::*field) {
    return field_rule(fmt::format("slave.N.mailbox.{}_size", name), fmt::format("Size of the {}; auto as in the ESI.", what),
                      AutoCodec<IntegerCodec<std::uint16_t>>{{kSmallest, kLargest, "bytes"}},
                      [field](auto& p, const Place& place) -> auto& { return at(p, place).mailbox.*field; });
  };
  return {
      size("out", "output mailbox", &MailboxSettings::out_size),
      size("in", "input mailbox", &MailboxSettings::in_size),
      field_rule("slave.N.mailbox.state_bit",
                 "The master learns of mail by a bit in the cyclic frames, where the device has an FMMU for it; off: it polls.",
                 SwitchCodec{}, [](auto& p, const Place& place) -> auto& { return at(p, place).mailbox.state_bit; }),
      field_rule("slave.N.mailbox.poll_time_ms", "How often the mailbox is polled; auto as the dialect's tool.",
                 AutoCodec<IntegerCodec<std::uint32_t>>{{1, 60'000, "ms"}},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).mailbox.poll_time_ms; }),
  };
}

std::vector<Rule> eoe_rules() {
  const auto address = [](const char* name, const char* what, std::string EoeSlaveSettings::*field) {
    return field_rule(fmt::format("slave.N.eoe.{}", name), fmt::format("{} that the slave gets at start-up (EoE).", what),
                      AddressCodec{}, [field](auto& p, const Place& place) -> auto& { return at(p, place).eoe.*field; });
  };
  return {
      field_rule("slave.N.eoe.enabled", "Ethernet frames are passed to and from the slave (EoE).", SwitchCodec{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).eoe.enabled; }),
      field_rule("slave.N.eoe.mac", "Ethernet address that the slave gets at start-up (EoE).", AutoCodec<MacCodec>{{}, "none"},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).eoe.mac; }),
      address("ip", "IP address", &EoeSlaveSettings::ip),
      address("subnet", "Subnet mask", &EoeSlaveSettings::subnet),
      address("gateway", "Default gateway", &EoeSlaveSettings::gateway),
      address("dns", "Name server", &EoeSlaveSettings::dns),
      field_rule("slave.N.eoe.host_name", "Host name that the slave gets at start-up (EoE).", HostNameCodec{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).eoe.host_name; }),
      field_rule("slave.N.aoe.net_id", "AMS Net ID of the slave (AoE).", NetIdCodec{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).ams_net_id; }),
  };
}

Status set_soe(SlaveSettings& slave, std::uint32_t number, std::string_view text) {
  const auto place = slave.soe_startup.begin() + static_cast<std::ptrdiff_t>(number);
  if (text.empty()) {
    if (number < slave.soe_startup.size()) slave.soe_startup.erase(place);
    return {};
  }
  if (!slave.device.mailbox || !slave.device.mailbox->soe) return bad_value("the device has no SoE mailbox");
  auto command = parse_soe(text);
  if (!command) return tl::unexpected(command.error());
  if (number < slave.soe_startup.size()) {
    *place = std::move(*command);
  } else {
    slave.soe_startup.push_back(std::move(*command));
  }
  return {};
}

Rule soe_rule() {
  Rule rule{.key = "slave.N.soe.K",
            .type = "SoE start-up command",
            .range = "TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# comment]; IDN like S-0-0047; nothing removes it",
            .meaning = "IDN that is written at these transitions, K counts from 0; the number behind the last adds one.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& startup = project.slaves[place.slave].soe_startup;
    return place.item < startup.size() ? format_soe(startup[place.item]) : std::string{};
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_soe(project.slaves[place.slave], place.item, text);
  };
  rule.items = [](const Project& project, std::size_t slave) {
    return numbered(slave, project.slaves[slave].soe_startup.size());
  };
  rule.extendable = true;
  return rule;
}

/// Name of a Sync Unit that the project has, or none.
Rule unit_rule(const char* direction, const char* what, std::string SlaveSettings::*field) {
  Rule rule{.key = fmt::format("slave.N.sync_unit.{}", direction),
            .type = "name",
            .range = "nothing, name of a master.sync_unit.K",
            .meaning = fmt::format("Sync Unit that exchanges the {}; nothing for the unnamed one in the base task.", what),
            .get = {},
            .set = {}};
  rule.get = [field](const Project& project, const Place& place) { return at(project, place).*field; };
  rule.set = [field](Project& project, const Place& place, std::string_view text) -> Status {
    const auto& units = project.master.sync_units;
    const bool known = text.empty() || text == at(project, place).*field ||
                       std::ranges::find(units, text, &SyncUnit::name) != units.end();
    if (!known) {
      std::string names;
      for (const SyncUnit& unit : units) names += (names.empty() ? "" : ", ") + unit.name;
      return bad_value(fmt::format("there is no Sync Unit \"{}\"; the project has {}", text, names.empty() ? "none" : names));
    }
    at(project, place).*field = std::string(text);
    return {};
  };
  return rule;
}

}  // namespace

std::vector<Rule> slave_option_rules() {
  std::vector<Rule> rules;
  for (auto part : {identity_rules(), watchdog_rules(), timeout_rules(), mailbox_rules(), eoe_rules()}) {
    rules.insert(rules.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  }
  rules.push_back(soe_rule());
  rules.push_back(unit_rule("outputs", "outputs", &SlaveSettings::output_unit));
  rules.push_back(unit_rule("inputs", "inputs", &SlaveSettings::input_unit));
  return rules;
}

}  // namespace syncline::settings
