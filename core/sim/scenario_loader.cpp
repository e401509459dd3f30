// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <toml++/toml.h>

#include "protocol/sii.h"
#include "support/random.h"

namespace syncline::sim {
namespace {

namespace fs = std::filesystem;

/// Reads one table: every key that is asked for is remembered, the others are errors.
class Table {
 public:
  Table(const toml::table& table, const std::string& file, std::optional<Error>& error)
      : table_(table), file_(file), error_(error) {}

  template <class T>
  T get(std::string_view key, T fallback) {
    asked_.emplace(key);
    const auto* node = table_.get(key);
    if (node == nullptr) return fallback;
    if constexpr (std::is_same_v<T, double>) {
      if (const auto value = node->value<double>()) return *value;
    } else if (const auto value = node->value_exact<std::conditional_t<std::is_integral_v<T> && !std::is_same_v<T, bool>, std::int64_t, T>>()) {
      return static_cast<T>(*value);
    }
    fail_at(key, "has the wrong type");
    return fallback;
  }
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
  const toml::table* table(std::string_view key) {
    asked_.emplace(key);
    const auto* node = table_.get(key);
    if (node != nullptr && !node->is_table()) fail_at(key, "must be a table");
    return node == nullptr ? nullptr : node->as_table();
  }
  const toml::array* tables(std::string_view key) {
    asked_.emplace(key);
    const auto* node = table_.get(key);
    if (node == nullptr) return nullptr;
    if (!node->is_array_of_tables()) fail_at(key, "must be written as [[" + std::string(key) + "]]");
    return node->as_array();
  }
  void fail_at(std::string_view key, std::string detail) {
    if (error_) return;
    const auto* node = table_.get(key);
    const auto line = node != nullptr ? node->source().begin.line : table_.source().begin.line;
    error_ = Error{ErrorCode::kScenarioKey, std::string(key), std::move(detail), file_, static_cast<int>(line)};
  }
  void reject_unknown_keys() {
    for (const auto& [key, node] : table_) {
      if (!asked_.contains(std::string(key.str()))) fail_at(key.str(), "is not a key that a scenario has here");
    }
  }

 private:
  const toml::table& table_;
  const std::string& file_;
  std::optional<Error>& error_;
  std::set<std::string> asked_;
};

std::uint8_t port_number(Table& table, const std::string& text, bool towards_master = false) {
  constexpr std::string_view kPorts = "ABCD";
  const auto place = text.size() == 1 ? kPorts.find(text[0]) : std::string_view::npos;
  if (place == std::string_view::npos || (place == 0 && !towards_master)) {
    table.fail_at("port", towards_master ? "must be \"A\", \"B\", \"C\" or \"D\"" : "must be \"B\", \"C\" or \"D\"");
    return 1;
  }
  return static_cast<std::uint8_t>(place);
}

SimDcConfig dc_of(Table& table, const std::string& text) {
  if (text == "64") return {true, true, true};
  if (text == "32") return {true, true, false};
  if (text == "times") return {false, true, false};
  if (text == "none") return {false, false, false};
  table.fail_at("dc", "must be \"64\", \"32\", \"times\" or \"none\"");
  return {};
}

JitterProfile jitter_of(Table& table, const std::string& text) {
  if (text == "none") return JitterProfile::none();
  if (text == "quiet") return JitterProfile::quiet();
  if (text == "desktop") return JitterProfile::desktop();
  if (text == "bad") return JitterProfile::bad();
  table.fail_at("jitter", "must be \"none\", \"quiet\", \"desktop\" or \"bad\"");
  return {};
}

/// Auto-increment addressing has 16 bits; station addresses start at 1001.
constexpr std::int64_t kMostSlaves = 64'000;

constexpr Nanoseconds kLongestStall = 60 * kSecond;

constexpr std::array<std::pair<std::string_view, FaultKind>, 11> kFaults{{
    {"lose-frames", FaultKind::kLoseFrames}, {"cable-break", FaultKind::kCableBreak}, {"slave-off", FaultKind::kSlaveOff},
    {"clock-step", FaultKind::kClockStep}, {"refuse-state", FaultKind::kRefuseState},
    {"mailbox-silence", FaultKind::kMailboxSilence}, {"slow-mailbox", FaultKind::kSlowMailbox}, {"bit-errors", FaultKind::kBitErrors},
    {"slow-application", FaultKind::kSlowApplication}, {"stop-application", FaultKind::kStopApplication},
    {"host-stall", FaultKind::kHostStall}}};

class Loader {
 public:
  Loader(const std::string& path, const DeviceSource& devices) : path_(path), devices_(devices) {}

  Result<SimConfig> load() {
    toml::table root;
    try {
      root = toml::parse_file(path_);
    } catch (const toml::parse_error& error) {
      if (!fs::exists(path_)) return fail(Error{ErrorCode::kFileNotFound, {}, {}, path_});
      return fail(Error{ErrorCode::kTomlMalformed, {}, std::string(error.description()), path_,
                        static_cast<int>(error.source().begin.line)});
    }
    Table table(root, path_, error_);
    config_.name = table.get<std::string>("name", fs::path(path_).stem().string());
    config_.seed = table.get<std::uint64_t>("seed", 1);
    const auto networks = table.get<std::int64_t>("networks", 1);
    if (networks < 1 || networks > 256) table.fail_at("networks", "must be 1 to 256");
    config_.networks = static_cast<unsigned>(networks);
    if (const auto* host = table.table("host")) read_host(*host);
    if (const auto* slaves = table.tables("slave")) {
      for (const auto& node : *slaves) read_slave(*node.as_table());
    } else {
      table.fail_at("slave", "a scenario needs at least one [[slave]]");
    }
    if (const auto* faults = table.tables("fault")) {
      for (const auto& node : *faults) read_fault(*node.as_table());
    }
    if (const auto* latches = table.tables("latch")) {
      for (const auto& node : *latches) read_latch(*node.as_table());
    }
    table.reject_unknown_keys();
    if (error_) return tl::unexpected(*error_);
    return std::move(config_);
  }

 private:
  void read_host(const toml::table& node) {
    Table table(node, path_, error_);
    config_.host_jitter = jitter_of(table, table.get<std::string>("jitter", "none"));
    host_ppm_ = table.get<double>("ppm", 0);
    table.reject_unknown_keys();
  }

  /// One [[slave]]: `count` of them in a line, the first where the keys say.
  void read_slave(const toml::table& node) {
    Table table(node, path_, error_);
    const auto position = config_.slaves.size();
    SimSlaveConfig slave;
    read_device(table, slave);
    slave.name = table.get<std::string>("name", slave.device.type);
    slave.behaviour = table.get<std::string>("behaviour", "generic");
    constexpr std::array<std::string_view, 6> kBehaviours{"generic",     "servo-y",      "drive-c",
                                                          "can-gateway", "analog-input", "sync-bridge"};
    if (std::ranges::find(kBehaviours, slave.behaviour) == kBehaviours.end()) {
      table.fail_at("behaviour", "must be \"generic\", \"servo-y\", \"drive-c\", \"can-gateway\", \"analog-input\" or \"sync-bridge\"");
    }
    if (position > 0) {
      slave.parent = static_cast<std::uint16_t>(table.get<std::int64_t>("parent", static_cast<std::int64_t>(position - 1)));
      if (*slave.parent >= position) table.fail_at("parent", "must be the number of a slave before this one");
      slave.parent_port = port_number(table, table.get<std::string>("port", "B"));
    }
    slave.cable_m = table.get<double>("cable_m", 1.0);
    if (slave.cable_m < 0 || slave.cable_m > 20'000) table.fail_at("cable_m", "must be 0 to 20000");
    slave.alias = table.get<std::uint16_t>("alias", slave.alias);
    slave.serial_no = table.get<std::uint32_t>("serial_no", slave.serial_no);
    slave.device_id = table.get<std::uint16_t>("device_id", 0);
    slave.foe_password = table.get<std::uint32_t>("foe_password", 0);
    // The host's clock is true time here: an error of the host is the opposite one of every slave.
    if (const double ppm = table.get<double>("external_ppm", 0); slave.behaviour == "sync-bridge") {
      constexpr double kMostPpm = 10'000;
      if (!(std::abs(ppm) <= kMostPpm)) table.fail_at("external_ppm", "must be within -10000 and 10000");
      slave.external_time = [ppm](Nanoseconds time) {
        const auto passed = static_cast<double>(time - VirtualClock::kDefaultStart);
        return std::optional(time + static_cast<Nanoseconds>(std::llround(passed * ppm * 1e-6)));
      };
    }
    slave.oscillator.ppm = table.get<double>("ppm", 0) - host_ppm_;
    slave.oscillator.wander_ppm = table.get<double>("wander_ppm", 0);
    slave.oscillator.start_offset = static_cast<Nanoseconds>(table.get<double>("start_offset_ms", 0) * 1e6);
    slave.dc = dc_of(table, table.get<std::string>("dc", "64"));
    slave.sii.read_time = static_cast<Nanoseconds>(table.get<double>("sii_read_ms", 0) * 1e6);
    slave.sii.write_time = static_cast<Nanoseconds>(table.get<double>("sii_write_ms", 0) * 1e6);
    const auto sii_bytes = table.get<std::int64_t>("sii_read_bytes", 8);
    if (sii_bytes != 4 && sii_bytes != 8) table.fail_at("sii_read_bytes", "must be 4 or 8");
    slave.sii.eight_bytes = sii_bytes == 8;
    if (slave.sii.read_time < 0 || slave.sii.write_time < 0) table.fail_at("sii_read_ms", "must not be negative");
    slave.processing_delay_ns = table.get<std::uint32_t>("processing_delay_ns", 300);
    slave.forwarding_delay_ns = table.get<std::uint32_t>("forwarding_delay_ns", 260);
    read_esc(table, slave);
    const auto count = table.get<std::int64_t>("count", 1);
    if (count < 1 || count + static_cast<std::int64_t>(position) > kMostSlaves) {
      table.fail_at("count", fmt::format("must be 1 or more, and a segment has at most {} slaves", kMostSlaves));
    }
    const auto spread_ppm = table.get<double>("spread_ppm", 0);
    table.reject_unknown_keys();
    if (!error_) repeat(slave, count, spread_ppm);
  }

  /// What the slave's ESC has and lacks.
  void read_esc(Table& table, SimSlaveConfig& slave) {
    const auto number = [&table](std::string_view key, std::uint8_t fallback, std::int64_t most) {
      const auto value = table.get<std::int64_t>(key, fallback);
      if (value < 1 || value > most) table.fail_at(key, fmt::format("must be 1 to {}", most));
      return static_cast<std::uint8_t>(value);
    };
    slave.fmmu_count = number("fmmus", slave.fmmu_count, 16);
    slave.sync_manager_count = number("sync_managers", slave.sync_manager_count, 16);
    slave.ram_kbytes = number("ram_kbytes", slave.ram_kbytes, 60);
    slave.logical_read_write = table.get<bool>("lrw", true);
    slave.physical_read_write = table.get<bool>("read_write", true);
  }

  void read_device(Table& table, SimSlaveConfig& slave) {
    const auto esi = table.get<std::string>("esi", "");
    const auto sii = table.get<std::string>("sii", "");
    DeviceQuery query;
    query.type = table.get<std::string>("type", "");
    if (table.has("product_code")) query.product_code = table.get<std::uint32_t>("product_code", 0);
    if (table.has("revision_no")) query.revision_no = table.get<std::uint32_t>("revision_no", 0);
    if (esi.empty() == sii.empty()) {
      table.fail_at(sii.empty() ? "esi" : "sii", "either esi = an ESI file or sii = an EEPROM image names the device, "
                                                 "relative to the scenario");
      return;
    }
    query.kind = sii.empty() ? DeviceQuery::Kind::kEsi : DeviceQuery::Kind::kSii;
    query.path = (fs::path(path_).parent_path() / (sii.empty() ? esi : sii)).lexically_normal().string();
    auto found = devices_(query);
    if (!found) {
      if (!error_) error_ = found.error();
      return;
    }
    slave.device = std::move(found->device);
    slave.sii_image = std::move(found->sii_image);
    slave.serial_no = slave.device.identity.serial_no;
    if (const auto image = sii::decode(slave.sii_image)) slave.alias = image->alias;
  }

  /// A line of `count` such slaves: numbered names, aliases and serial numbers that count up, quartzes that
  /// differ by up to `spread_ppm`.
  void repeat(const SimSlaveConfig& first, std::int64_t count, double spread_ppm) {
    const auto position = config_.slaves.size();
    Random random(config_.seed ^ (0x7370'7265'6164'0000U + position));
    for (std::int64_t i = 0; i < count; ++i) {
      auto slave = first;
      if (spread_ppm != 0) slave.oscillator.ppm += spread_ppm * random.uniform(-1, 1);
      if (count > 1) slave.name += fmt::format(" {}", i + 1);
      if (i > 0) {
        slave.parent = static_cast<std::uint16_t>(config_.slaves.size() - 1);
        slave.parent_port = 1;
        if (slave.alias != 0) slave.alias = static_cast<std::uint16_t>(slave.alias + i);
        if (slave.serial_no != 0) slave.serial_no += static_cast<std::uint32_t>(i);
      }
      config_.slaves.push_back(std::move(slave));
    }
  }

  void read_fault(const toml::table& node) {
    Table table(node, path_, error_);
    FaultConfig fault;
    const auto kind = table.get<std::string>("kind", "");
    const auto found = std::ranges::find(kFaults, std::string_view(kind), &std::pair<std::string_view, FaultKind>::first);
    if (found == kFaults.end()) {
      table.fail_at("kind", "must be lose-frames, cable-break, slave-off, clock-step, refuse-state, mailbox-silence, "
                            "slow-mailbox, slow-application, stop-application, bit-errors or host-stall");
    } else {
      fault.kind = found->second;
    }
    fault.slave = static_cast<int>(table.get<std::int64_t>("slave", -1));
    const bool of_host = fault.kind == FaultKind::kHostStall;
    if (of_host && table.has("slave")) table.fail_at("slave", "does not go with this kind: it is the host's");
    const bool needs_slave = !of_host && (fault.kind != FaultKind::kLoseFrames || table.has("slave"));
    if (needs_slave && (fault.slave < 0 || static_cast<std::size_t>(fault.slave) >= config_.slaves.size())) {
      table.fail_at("slave", "must be the position of a slave of this scenario");
    }
    const bool by_firmware = fault.kind == FaultKind::kRefuseState || fault.kind == FaultKind::kStopApplication;
    if (!error_ && by_firmware &&
        config_.slaves[static_cast<std::size_t>(fault.slave)].device.device_emulation()) {
      table.fail_at("kind", "this slave has no firmware that could refuse or stop (device emulation)");
    }
    fault.at = static_cast<Nanoseconds>(table.get<double>("at_ms", 0) * 1e6);
    fault.until = static_cast<Nanoseconds>(table.get<double>("until_ms", 0) * 1e6);
    fault.count = table.get<std::uint32_t>("count", 1);
    fault.port = port_number(table, table.get<std::string>("port", "A"), true);
    fault.value_ns = table.get<std::int64_t>("value_ns", 0);
    if (of_host && (fault.value_ns <= 0 || fault.value_ns > kLongestStall)) {
      table.fail_at("value_ns", "must be 1 to 60000000000: how long the host does nothing");
    }
    fault.code = table.get<std::uint16_t>("code", 0);
    const auto state = table.get<std::string>("state", "");
    if (!state.empty()) {
      if (const auto wanted = al_state_from_name(state)) {
        fault.state = *wanted;
      } else {
        table.fail_at("state", "must be INIT, PREOP, SAFEOP or OP");
      }
    }
    table.reject_unknown_keys();
    config_.faults.push_back(fault);
  }

  /// One [[latch]]: pulses at an input of a slave.
  void read_latch(const toml::table& node) {
    Table table(node, path_, error_);
    constexpr double kMostMs = 86'400'000;  // a day
    const auto time = [&](std::string_view key, double fallback) {
      const auto ms = table.get<double>(key, fallback);
      if (!(ms >= 0 && ms <= kMostMs)) table.fail_at(key, "must be 0 to 86400000 ms");
      return error_ ? Nanoseconds{0} : static_cast<Nanoseconds>(ms * 1e6);
    };
    LatchPulses pulses;
    const auto slave = table.get<std::int64_t>("slave", -1);
    if (slave < 0 || static_cast<std::size_t>(slave) >= config_.slaves.size()) {
      table.fail_at("slave", "must be the position of a slave of this scenario");
    }
    const auto input = table.get<std::int64_t>("input", 0);
    if (input != 0 && input != 1) table.fail_at("input", "must be 0 or 1");
    const auto count = table.get<std::int64_t>("count", 1);
    if (count < 1 || count > 100'000) table.fail_at("count", "must be 1 to 100000");
    pulses.slave = static_cast<std::uint16_t>(slave);
    pulses.input = static_cast<std::uint8_t>(input);
    pulses.count = static_cast<std::uint32_t>(count);
    pulses.at = time("at_ms", 0);
    pulses.period = time("period_ms", 1);
    pulses.width = time("width_ms", 0.1);
    if (static_cast<double>(count) * static_cast<double>(pulses.period) > kMostMs * 1e6) {
      table.fail_at("period_ms", "all pulses must come within a day");
    }
    if (pulses.width <= 0 || pulses.width >= pulses.period) table.fail_at("width_ms", "must be above 0 and below period_ms");
    table.reject_unknown_keys();
    if (!error_) config_.latch_pulses.push_back(pulses);
  }

  const std::string& path_;
  const DeviceSource& devices_;
  SimConfig config_;
  double host_ppm_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<SimConfig> load_scenario(const std::string& path, const DeviceSource& devices) {
  return Loader(path, devices).load();
}

}  // namespace syncline::sim
