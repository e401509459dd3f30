// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario/scenario_loader.h"

#include <filesystem>
#include <string_view>

#include "sim/scenario/host_profile_file.h"
#include "sim/scenario/scenario_faults.h"
#include "sim/scenario/scenario_slaves.h"
#include "sim/scenario/scenario_table.h"

namespace syncline::sim {
namespace {

namespace fs = std::filesystem;

JitterProfile jitter_of(Table& table) {
  const auto text = table.text("jitter", "none");
  if (text == "none") return JitterProfile::none();
  if (text == "quiet") return JitterProfile::quiet();
  if (text == "desktop") return JitterProfile::desktop();
  if (text == "bad") return JitterProfile::bad();
  table.fail_at("jitter", "must be \"none\", \"quiet\", \"desktop\" or \"bad\"");
  return {};
}

class Loader {
 public:
  Loader(const std::string& path, const DeviceSource& devices) : path_(path), devices_(devices) {}

  Result<SimConfig> load(const Result<toml::table>& root) {
    if (!root) return tl::unexpected(root.error());
    config_.files.push_back(path_);
    Table table(*root, path_, error_);
    const auto machine = table.text("machine", "");
    if (!machine.empty()) read_machine(table, machine);
    config_.name = table.text("name", fs::path(path_).stem().string());
    config_.seed = table.get<std::uint64_t>("seed", config_.seed);
    config_.networks = static_cast<unsigned>(table.integer("networks", config_.networks, 1, 256));
    double host_ppm = 0;
    if (const auto* host = table.table("host")) host_ppm = read_host(*host);
    if (const auto* bus = table.table("bus")) read_bus(*bus);
    if (machine.empty()) read_slaves(table, host_ppm);
    read_faults(table);
    if (const auto* latches = table.tables("latch")) {
      for (const auto& node : *latches) read_latch(*node.as_table());
    }
    table.reject_unknown_keys();
    if (error_) return tl::unexpected(*error_);
    return std::move(config_);
  }

 private:
  /// The machine of another scenario, to which this one does something.
  void read_machine(Table& table, const std::string& file) {
    if (of_machine_) return table.fail_at("machine", "the file of a machine is a scenario of its own");
    if (table.has("slave")) table.fail_at("slave", "the slaves are those of the machine");
    if (error_) return;
    const auto path = (fs::path(path_).parent_path() / file).lexically_normal().string();
    Loader loader(path, devices_);
    loader.of_machine_ = true;
    if (auto machine = loader.load(parse_toml(path))) {
      const auto own = std::move(config_.files);
      config_ = std::move(*machine);
      config_.files.insert(config_.files.end(), own.begin(), own.end());
    } else {
      table.fail_with_file("machine", machine.error());
    }
  }

  /// Error of the host's clock, ppm.
  double read_host(const toml::table& node) {
    Table table(node, path_, error_);
    if (!of_machine_ && !config_.slaves.empty() && table.has("ppm"))
      table.fail_at("ppm", "stands in the file of the machine");
    config_.host_jitter = jitter_of(table);
    const double ppm = table.number("ppm", 0, -kMostPpm, kMostPpm);
    const auto profile = table.text("profile", "");
    if (!profile.empty()) read_profile(table, profile);
    table.reject_unknown_keys();
    return ppm;
  }

  void read_profile(Table& table, const std::string& file) {
    if (table.has("jitter")) table.fail_at("profile", "goes without jitter: one of the two");
    if (error_) return;
    config_.files.push_back((fs::path(path_).parent_path() / file).lexically_normal().string());
    auto profile = read_host_profile(config_.files.back());
    if (profile) {
      config_.host_jitter = std::move(*profile);
    } else {
      table.fail_with_file("profile", profile.error());
    }
  }

  void read_bus(const toml::table& node) {
    constexpr double kMostNoise = 1000, kMostForeign = 5000;
    Table table(node, path_, error_);
    config_.bus.loss = table.number("loss", 0, 0, 1);
    config_.bus.latch_noise_ns = table.number("latch_noise_ns", 0, 0, kMostNoise);
    config_.bus.foreign_per_second = table.number("foreign_per_s", 0, 0, kMostForeign);
    table.reject_unknown_keys();
  }

  void read_slaves(Table& table, double host_ppm) {
    const auto* nodes = table.tables("slave");
    if (nodes == nullptr) return table.fail_at("slave", "a scenario needs at least one [[slave]]");
    ScenarioSlaves slaves(devices_, path_, config_.seed, host_ppm, error_);
    for (const auto& node : *nodes) slaves.read(*node.as_table());
    slaves.check_wiring();
    config_.slaves = slaves.take();
  }

  void read_faults(Table& table) {
    const auto* nodes = table.tables("fault");
    if (nodes == nullptr || error_) return;
    ScenarioFaults faults(config_.slaves, path_, error_, std::move(config_.faults));
    for (const auto& node : *nodes) faults.read(*node.as_table());
    config_.faults = faults.take();
  }

  /// One [[latch]]: pulses at an input of a slave.
  void read_latch(const toml::table& node) {
    constexpr double kDayNs = 86'400e9;
    Table table(node, path_, error_);
    LatchPulses pulses;
    const auto slave = table.integer("slave", -1, 0, static_cast<std::int64_t>(config_.slaves.size()) - 1);
    if (slave < 0) table.fail_at("slave", "must be the position of a slave of this scenario");
    pulses.slave = static_cast<std::uint16_t>(slave);
    pulses.input = static_cast<std::uint8_t>(table.integer("input", 0, 0, 1));
    pulses.count = static_cast<std::uint32_t>(table.integer("count", 1, 1, 100'000));
    pulses.at = table.time_ms("at_ms", 0);
    pulses.period = table.time_ms("period_ms", 1);
    pulses.width = table.time_ms("width_ms", 0.1);
    if (static_cast<double>(pulses.count) * static_cast<double>(pulses.period) > kDayNs) {
      table.fail_at("period_ms", "all pulses must come within a day");
    }
    if (pulses.width <= 0 || pulses.width >= pulses.period)
      table.fail_at("width_ms", "must be above 0 and below period_ms");
    table.reject_unknown_keys();
    if (!error_) config_.latch_pulses.push_back(pulses);
  }

  const std::string& path_;
  const DeviceSource& devices_;
  SimConfig config_;
  bool of_machine_ = false;  // read for another scenario
  std::optional<Error> error_;
};

}  // namespace

Result<SimConfig> load_scenario(const std::string& path, const DeviceSource& devices) {
  return Loader(path, devices).load(parse_toml(path));
}

Result<SimConfig> parse_scenario(std::string_view text, const std::string& path, const DeviceSource& devices) {
  return Loader(path, devices).load(parse_toml_text(text, path));
}

}  // namespace syncline::sim
