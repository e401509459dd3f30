// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario/scenario_slaves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "config/port_kind.h"
#include "protocol/sii.h"
#include "sim/esc/esc_types.h"
#include "sim/scenario/scenario_faults.h"
#include "sim/scenario/scenario_table.h"
#include "support/clock.h"
#include "support/random.h"

namespace syncline::sim {
namespace {

namespace fs = std::filesystem;

/// Auto-increment addressing has 16 bits; station addresses start at 1001.
constexpr std::int64_t kMostSlaves = 64'000;
constexpr double kMostCable = 20'000;            // m
constexpr std::uint32_t kMostDelay = 1'000'000;  // ns, inside an ESC

SimDcConfig dc_of(Table& table) {
  const auto text = table.text("dc", "64");
  if (text == "64") return {true, true, true};
  if (text == "32") return {true, true, false};
  if (text == "times") return {false, true, false};
  if (text == "none") return {false, false, false};
  table.fail_at("dc", "must be \"64\", \"32\", \"times\" or \"none\"");
  return {};
}

void read_behaviour(Table& table, SimSlaveConfig& slave) {
  slave.behaviour = table.text("behaviour", "generic");
  constexpr std::array<std::string_view, 6> kBehaviours{"generic",     "servo-y",      "drive-c",
                                                        "can-gateway", "analog-input", "sync-bridge"};
  if (std::ranges::find(kBehaviours, slave.behaviour) == kBehaviours.end()) {
    table.fail_at(
        "behaviour",
        "must be \"generic\", \"servo-y\", \"drive-c\", \"can-gateway\", \"analog-input\" or \"sync-bridge\"");
  }
}

void read_eeprom(Table& table, SimSlaveConfig& slave) {
  constexpr double kMostMs = 10'000;
  slave.sii.read_time = static_cast<Nanoseconds>(table.number("sii_read_ms", 0, 0, kMostMs) * 1e6);
  slave.sii.write_time = static_cast<Nanoseconds>(table.number("sii_write_ms", 0, 0, kMostMs) * 1e6);
  const auto bytes = table.integer("sii_read_bytes", 8, 4, 8);
  if (bytes != 4 && bytes != 8) table.fail_at("sii_read_bytes", "must be 4 or 8");
  slave.sii.eight_bytes = bytes == 8;
}

/// How long a frame takes through the ESC: by its type, by the numbers, or by the ports it leaves by.
void read_delays(Table& table, SimSlaveConfig& slave) {
  const auto type = table.text("esc", "");
  if (!type.empty()) {
    if (const auto* known = find_esc_type(type)) {
      slave.delays = known->delays;
      slave.esc_type = known->type_register;
    } else {
      table.fail_at("esc", "must be one of {names}", esc_type_names());
    }
  }
  constexpr std::array<std::string_view, 3> kNumbers{"processing_delay_ns", "forwarding_delay_ns", "tdiff_ns"};
  for (const auto key : kNumbers) {
    if (!type.empty() && table.has(key)) table.fail_at(key, "goes without esc, whose delays are known");
  }
  if (table.has("tdiff_ns") && table.has("processing_delay_ns")) {
    table.fail_at("tdiff_ns", "is processing_delay_ns less forwarding_delay_ns: one of the two");
  }
  if (std::ranges::none_of(kNumbers, [&](auto key) { return table.has(key); })) return;
  const auto number = [&table](std::string_view key, std::uint32_t fallback) {
    return static_cast<std::uint32_t>(table.integer(key, fallback, 0, kMostDelay));
  };
  const auto usual = port_kind(slave.device, slave.entry_port) == PortKind::kEbus ? kEbusDelays : kCableDelays;
  EscDelays delays;
  delays.forwarding = number("forwarding_delay_ns", usual.forwarding);
  delays.processing = table.has("tdiff_ns") ? delays.forwarding + number("tdiff_ns", 0)
                                            : number("processing_delay_ns", usual.processing);
  slave.delays = delays;
}

/// What the slave's ESC has and lacks.
void read_esc(Table& table, SimSlaveConfig& slave) {
  const auto number = [&table](std::string_view key, std::uint8_t fallback, std::int64_t most) {
    return static_cast<std::uint8_t>(table.integer(key, fallback, 1, most));
  };
  slave.fmmu_count = number("fmmus", slave.fmmu_count, 16);
  slave.sync_manager_count = number("sync_managers", slave.sync_manager_count, 16);
  slave.ram_kbytes = number("ram_kbytes", slave.ram_kbytes, 60);
  slave.logical_read_write = table.flag("lrw", true);
  slave.physical_read_write = table.flag("read_write", true);
  const auto sign = table.text("deviation_sign", "newer");
  if (sign != "older" && sign != "newer") table.fail_at("deviation_sign", "must be \"older\" or \"newer\"");
  slave.dc.sign_of_older_edition = sign == "older";
}

}  // namespace

void ScenarioSlaves::read(const toml::table& node) {
  Table table(node, file_, error_);
  SimSlaveConfig slave;
  read_device(table, slave);
  slave.name = table.text("name", slave.device.type);
  read_behaviour(table, slave);
  read_place(table, slave);
  slave.alias = table.get<std::uint16_t>("alias", slave.alias);
  slave.serial_no = table.get<std::uint32_t>("serial_no", slave.serial_no);
  slave.device_id = table.get<std::uint16_t>("device_id", 0);
  slave.foe_password = table.get<std::uint32_t>("foe_password", 0);
  read_bridge(table, slave);
  slave.dc = dc_of(table);
  read_clock(table, slave);
  read_eeprom(table, slave);
  read_delays(table, slave);
  read_esc(table, slave);
  const auto count = table.integer("count", 1, 1, kMostSlaves);
  check_count(table, slave, count);
  const auto spread_ppm = table.number("spread_ppm", 0, 0, kMostPpm);
  table.reject_unknown_keys();
  if (!error_) repeat(node, slave, count, spread_ppm);
}

/// What counts up from slave to slave has room, and the line a port to go on by.
void ScenarioSlaves::check_count(Table& table, const SimSlaveConfig& slave, std::int64_t count) {
  const auto before = static_cast<std::int64_t>(slaves_.size());
  if (before + count > kMostSlaves) {
    table.fail_at("count", "makes {count} slaves where a segment has {most} at most", before + count, kMostSlaves);
  }
  if (count == 1) return;
  const auto counts_beyond = [count](std::int64_t first, std::int64_t most) {
    return first != 0 && first + count - 1 > most;
  };
  if (counts_beyond(slave.alias, UINT16_MAX)) {
    table.fail_at(table.has("alias") ? "alias" : "count", "counts up to {last}, beyond 65535", slave.alias + count - 1);
  }
  if (counts_beyond(slave.serial_no, UINT32_MAX)) {
    table.fail_at(table.has("serial_no") ? "serial_no" : "count", "counts up beyond 4294967295");
  }
  constexpr std::uint8_t kPortB = 1;
  if (slave.entry_port == kPortB)
    table.fail_at("entry", "is where the next of these slaves would be wired to; give them one by one");
}

void ScenarioSlaves::read_place(Table& table, SimSlaveConfig& slave) {
  const auto position = slaves_.size();
  slave.entry_port = port_number(table, "entry", 'A');
  const auto parent = table.integer("parent", static_cast<std::int64_t>(position) - 1, -1, UINT16_MAX);
  if (parent >= 0) {
    slave.parent = static_cast<std::uint16_t>(parent);
    slave.parent_port = port_number(table, "port", 'B');
    if (*slave.parent == position) table.fail_at("parent", "must be the number of another slave");
    const auto other = std::ranges::find_if(
        slaves_, [&](const auto& one) { return one.parent == slave.parent && one.parent_port == slave.parent_port; });
    if (other != slaves_.end()) {
      table.fail_at("port", "this port of slave {slave} has slave {other} already", *slave.parent,
                    other - slaves_.begin());
    }
  }
  slave.cable_m = table.number("cable_m", 1.0, 0, kMostCable);
  slave.asymmetry_ns =
      table.number("asymmetry_ns", 0, -2 * kMostCable * kCableNsPerMetre, 2 * kMostCable * kCableNsPerMetre);
  if (std::abs(slave.asymmetry_ns) > 2 * slave.cable_m * kCableNsPerMetre) {
    table.fail_at("asymmetry_ns", "is more than there and back over {length} m together", slave.cable_m);
  }
}

/// What can be said of the wiring only when all slaves are known: a slave may hang at one that frames come to later.
void ScenarioSlaves::check_wiring() {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < slaves_.size() && !error_; ++i) {
    const auto& slave = slaves_[i];
    Table table(*nodes_[i], file_, error_);
    if (!slave.parent) {
      if (first) table.fail_at("parent", "is needed: slave {slave} is the one that is wired to the master", *first);
      first = i;
    } else if (*slave.parent >= slaves_.size()) {
      table.fail_at("parent", "must be the number of a slave; there are {count}", slaves_.size());
    } else if (slaves_[*slave.parent].entry_port == slave.parent_port) {
      table.fail_at(table.has("port") ? "port" : "parent",
                    "{port} is where slave {slave} is wired to the one before it",
                    static_cast<char>('A' + slave.parent_port), *slave.parent);
    }
  }
  // Each hangs at another one then, and some in a circle.
  if (!first && !slaves_.empty() && !error_)
    Table(*nodes_.front(), file_, error_).fail_at("parent", "no frame reaches it; check parent and port");
}

void ScenarioSlaves::read_clock(Table& table, SimSlaveConfig& slave) {
  constexpr double kMostOffset = 1e12;  // ms
  slave.oscillator.ppm = table.number("ppm", 0, -kMostPpm, kMostPpm) - host_ppm_;
  slave.oscillator.wander_ppm = table.number("wander_ppm", 0, 0, kMostPpm);
  slave.oscillator.start_offset = static_cast<Nanoseconds>(table.number("start_offset_ms", 0, 0, kMostOffset) * 1e6);
}

void ScenarioSlaves::read_bridge(Table& table, SimSlaveConfig& slave) {
  // The host's clock is true time here: an error of the host is the opposite one of every slave.
  const double ppm = table.number("external_ppm", 0, -kMostPpm, kMostPpm);
  if (slave.behaviour != "sync-bridge") {
    if (table.has("external_ppm")) table.fail_at("external_ppm", "goes with behaviour = \"sync-bridge\" only");
    return;
  }
  slave.external_time = [ppm](Nanoseconds time) {
    const auto passed = static_cast<double>(time - VirtualClock::kDefaultStart);
    return std::optional(time + static_cast<Nanoseconds>(std::llround(passed * ppm * 1e-6)));
  };
}

void ScenarioSlaves::read_device(Table& table, SimSlaveConfig& slave) {
  const auto esi = table.text("esi", "");
  const auto sii = table.text("sii", "");
  DeviceQuery query;
  query.type = table.text("type", "");
  if (table.has("product_code")) query.product_code = table.get<std::uint32_t>("product_code", 0);
  if (table.has("revision_no")) query.revision_no = table.get<std::uint32_t>("revision_no", 0);
  if (esi.empty() == sii.empty()) {
    table.fail_at(sii.empty() ? "esi" : "sii",
                  "either esi = an ESI file or sii = an EEPROM image names the device, "
                  "relative to the scenario");
    return;
  }
  query.kind = sii.empty() ? DeviceQuery::Kind::kEsi : DeviceQuery::Kind::kSii;
  query.path = (fs::path(file_).parent_path() / (sii.empty() ? esi : sii)).lexically_normal().string();
  if (error_) return;
  auto found = devices_(query);
  if (!found) {
    table.fail_with_file(sii.empty() ? "esi" : "sii", found.error());
    return;
  }
  slave.device = std::move(found->device);
  slave.sii_image = std::move(found->sii_image);
  slave.serial_no = slave.device.identity.serial_no;
  if (const auto image = sii::decode(slave.sii_image)) slave.alias = image->alias;
}

/// A line of `count` such slaves: numbered names, aliases and serial numbers that count up, quartzes that
/// differ by up to `spread_ppm`.
void ScenarioSlaves::repeat(const toml::table& node, const SimSlaveConfig& first, std::int64_t count,
                            double spread_ppm) {
  Random random(seed_ ^ (0x7370'7265'6164'0000U + slaves_.size()));
  for (std::int64_t i = 0; i < count; ++i) {
    auto slave = first;
    if (spread_ppm != 0) slave.oscillator.ppm += spread_ppm * random.uniform(-1, 1);
    if (count > 1) slave.name += fmt::format(" {}", i + 1);
    if (i > 0) {
      slave.parent = static_cast<std::uint16_t>(slaves_.size() - 1);
      slave.parent_port = 1;
      slave.entry_port = 0;
      if (slave.alias != 0) slave.alias = static_cast<std::uint16_t>(slave.alias + i);
      if (slave.serial_no != 0) slave.serial_no += static_cast<std::uint32_t>(i);
    }
    slaves_.push_back(std::move(slave));
    nodes_.push_back(&node);
  }
}

}  // namespace syncline::sim
