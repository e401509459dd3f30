// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario/scenario_faults.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "sim/faults/fault_rules.h"
#include "sim/scenario/scenario_table.h"

namespace syncline::sim {
namespace {

using R = FaultRule;

constexpr std::array kKeys{R::kUntil, R::kCount,       R::kPort, R::kValue, R::kState,
                           R::kCode,  R::kProbability, R::kPpm,  R::kPeriod};
constexpr std::int64_t kMostFrames = 1'000'000'000;

const FaultRule* find_rule(Table& table) {
  const auto kind = table.text("kind", "");
  const auto rules = fault_rules();
  const auto rule = std::ranges::find(rules, std::string_view(kind), &FaultRule::name);
  if (rule != rules.end()) return &*rule;
  std::vector<std::string_view> names;
  for (const auto& one : rules) names.push_back(one.name);
  table.fail_at("kind", "must be one of {names}", fmt::format("{}", fmt::join(names, ", ")));
  return nullptr;
}

/// Keys that go with other kinds only, and those that are missing.
void check_keys(Table& table, const FaultRule& rule) {
  for (const auto key : kKeys) {
    const auto name = name_of(key);
    if ((rule.keys & key) == 0 && table.has(name)) table.fail_at(name, "does not go with {fault}", rule.name);
    if ((rule.required & key) != 0 && !table.has(name)) table.fail_at(name, "is missing: {fault} needs it", rule.name);
  }
  if (table.has("count") && table.has("probability"))
    table.fail_at("count", "goes without probability: one of the two");
}

void read_values(Table& table, const FaultRule& rule, FaultConfig& fault) {
  fault.at = table.time_ms("at_ms", 0);
  fault.until = table.time_ms("until_ms", 0);
  fault.count = static_cast<std::uint32_t>(table.integer("count", 1, 1, kMostFrames));
  fault.port = port_number(table, "port", 'A');
  fault.value_ns = table.integer("value_ns", 0, rule.least, rule.most);
  fault.code = static_cast<std::uint16_t>(table.integer("code", 0, 1, UINT16_MAX));
  fault.probability = table.number("probability", 0, 0, 1);
  fault.ppm = table.number("ppm", 0, -kMostPpm, kMostPpm);
  fault.period = table.time_ms("period_ms", 1);
  if (fault.kind == FaultKind::kClockSlew && fault.ppm <= 0)
    table.fail_at("ppm", "must be above 0; the sign of value_ns says which way");
  // A frame takes 7 us on the wire; more of them never end.
  if (fault.period < 10 * kMicrosecond) table.fail_at("period_ms", "must be above 0: at least 0.01");
  const auto state = table.text("state", "");
  if (state.empty()) return;
  if (const auto wanted = al_state_from_name(state)) {
    fault.state = *wanted;
  } else {
    table.fail_at("state", "must be INIT, PREOP, SAFEOP or OP");
  }
}

bool overlap(const FaultConfig& a, const FaultConfig& b) {
  const auto end = [](const FaultConfig& fault) { return fault.until > fault.at ? fault.until : INT64_MAX; };
  return a.at < end(b) && b.at < end(a);
}

/// What lasts, so that a second one of its kind would end it or be ended by it.
bool lasts(const FaultConfig& fault, const FaultRule& rule) {
  if ((rule.keys & R::kUntil) == 0 || fault.kind == FaultKind::kTemperatureRamp) return false;  // ramps add up
  const bool frames = fault.kind == FaultKind::kLoseFrames || fault.kind == FaultKind::kBitErrors ||
                      fault.kind == FaultKind::kForeignFrames;
  return !frames || fault.until > 0 || fault.probability > 0;
}

}  // namespace

std::uint8_t port_number(Table& table, std::string_view key, char fallback) {
  constexpr std::string_view kPorts = "ABCD";
  const auto text = table.text(key, std::string(1, fallback));
  const auto place = text.size() == 1 ? kPorts.find(text[0]) : std::string_view::npos;
  if (place == std::string_view::npos) table.fail_at(key, "must be \"A\", \"B\", \"C\" or \"D\"");
  return static_cast<std::uint8_t>(place & 3U);
}

void ScenarioFaults::read(const toml::table& node) {
  Table table(node, file_, error_);
  FaultConfig fault;
  const auto* rule = find_rule(table);
  if (rule == nullptr) return;
  fault.kind = rule->kind;
  check_keys(table, *rule);
  read_values(table, *rule, fault);
  fault.slave = -1;
  if (rule->subject == R::Subject::kHost) {
    if (table.has("slave")) table.fail_at("slave", "does not go with {fault}: it is no slave's", rule->name);
  } else if (rule->subject == R::Subject::kSlave || table.has("slave")) {
    fault.slave = static_cast<int>(table.integer("slave", -1, 0, static_cast<std::int64_t>(slaves_.size()) - 1));
    if (fault.slave < 0) table.fail_at("slave", "must be the position of a slave of this scenario");
  }
  if (!table.failed()) check_slave(table, fault);
  if (!table.failed()) check_port(table, fault);
  if (!table.failed()) check_time(table, fault);
  table.reject_unknown_keys();
  if (!table.failed()) faults_.push_back(fault);
}

/// What the fault needs is what the slave has.
void ScenarioFaults::check_slave(Table& table, const FaultConfig& fault) {
  if (fault.slave < 0) return;
  const auto& slave = slaves_[static_cast<std::size_t>(fault.slave)];
  const auto& rule = *std::ranges::find(fault_rules(), fault.kind, &FaultRule::kind);
  switch (rule.needs) {
    case R::kNothing:
      break;
    case R::kFirmware:
      if (slave.device.device_emulation()) {
        table.fail_at("kind", "this slave has no firmware that could do so (device emulation)");
      }
      break;
    case R::kMailbox:
      if (!slave.device.mailbox) table.fail_at("kind", "this slave has no mailbox");
      break;
    case R::kClock:
      if (!slave.dc.receive_times) table.fail_at("kind", "this slave has no clock (dc)");
      break;
    case R::kSystemTime:
      if (!slave.dc.system_time) table.fail_at("kind", "this slave has no system time (dc)");
      break;
  }
}

bool ScenarioFaults::has_cable(int slave, std::uint8_t port) const {
  if (slaves_[static_cast<std::size_t>(slave)].entry_port == port) return true;
  return std::ranges::any_of(slaves_,
                             [&](const auto& other) { return other.parent == slave && other.parent_port == port; });
}

void ScenarioFaults::check_port(Table& table, const FaultConfig& fault) {
  if (fault.slave < 0) {
    if (table.has("port")) table.fail_at("port", "needs a slave");
    return;
  }
  switch (fault.kind) {
    case FaultKind::kLoseFrames:
    case FaultKind::kBitErrors:
    case FaultKind::kStuckPortTime:
      if (table.has("port") && !has_cable(fault.slave, fault.port)) table.fail_at("port", "no cable is at this port");
      break;
    case FaultKind::kClosedRing:
      if (has_cable(fault.slave, fault.port)) table.fail_at("port", "is not free: another slave is there");
      break;
    case FaultKind::kReversedCable:
      if (slaves_[static_cast<std::size_t>(fault.slave)].entry_port == fault.port) {
        table.fail_at("port", "is where the cable from the master is anyway");
      }
      break;
    default:
      break;
  }
}

void ScenarioFaults::check_time(Table& table, const FaultConfig& fault) {
  if (fault.until != 0 && fault.until <= fault.at) {
    return table.fail_at("until_ms", "the fault would end before it begins, at {time} ms; 0 or no until_ms: for good",
                         static_cast<double>(fault.at) / 1e6);
  }
  const bool of_frames = fault.kind == FaultKind::kLoseFrames || fault.kind == FaultKind::kBitErrors;
  if (of_frames && fault.until != 0 && table.has("count")) {
    return table.fail_at("count", "goes without until_ms: so many frames, or all of them until then");
  }
  if (fault.kind == FaultKind::kLoseFrames && fault.until != 0 && fault.slave < 0 && fault.probability == 0) {
    return table.fail_at("until_ms", "without a slave, lose-frames has a count or a probability");
  }
  const auto& rule = *std::ranges::find(fault_rules(), fault.kind, &FaultRule::kind);
  if (fault.kind == FaultKind::kHostStall) return check_stalls(table, fault, rule.name);
  if (!lasts(fault, rule)) return;
  const auto same = std::ranges::find_if(faults_, [&](const FaultConfig& other) {
    const bool same_place =
        other.slave == fault.slave && (other.port == fault.port || fault.kind == FaultKind::kReversedCable);
    return other.kind == fault.kind && same_place && lasts(other, rule) && overlap(other, fault);
  });
  if (same == faults_.end()) return;
  const auto begin = static_cast<double>(same->at) / 1e6;
  if (fault.slave < 0)
    return table.fail_at("at_ms", "the {fault} that begins at {time} ms is not over then", rule.name, begin);
  table.fail_at("at_ms", "the {fault} of the same slave that begins at {time} ms is not over then", rule.name, begin);
}

/// One host stands still once at a time: two stalls that overlap would be one of a length that nobody wrote.
void ScenarioFaults::check_stalls(Table& table, const FaultConfig& fault, std::string_view name) {
  const auto milliseconds = [](Nanoseconds time) { return static_cast<double>(time) / 1e6; };
  for (const auto& other : faults_) {
    if (other.kind != fault.kind) continue;
    const auto end = other.at + other.value_ns;
    if (fault.at >= end || other.at >= fault.at + fault.value_ns) continue;
    return table.fail_at("at_ms", "overlaps the {fault} from {time} ms to {other} ms", name, milliseconds(other.at),
                         milliseconds(end));
  }
}

}  // namespace syncline::sim
