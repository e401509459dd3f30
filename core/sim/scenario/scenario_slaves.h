// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "config/sim_config.h"
#include "sim/scenario/scenario_loader.h"

namespace syncline::sim {

class Table;

/// Reads the [[slave]]s of a scenario in frame order.
class ScenarioSlaves {
 public:
  /// References outlive it. `seed`: of the scenario. `host_ppm`: error of the host's clock, which all slaves get the
  /// other way round.
  ScenarioSlaves(const DeviceSource& devices, const std::string& file, std::uint64_t seed, double host_ppm,
                 std::optional<Error>& error)
      : devices_(devices), file_(file), seed_(seed), host_ppm_(host_ppm), error_(error) {}
  /// One [[slave]]: `count` of them in a line, the first where the keys say.
  void read(const toml::table& node);
  /// After the last one, while the tables that were read are still there.
  void check_wiring();
  [[nodiscard]] std::vector<SimSlaveConfig> take() { return std::move(slaves_); }

 private:
  void read_device(Table& table, SimSlaveConfig& slave);
  void read_place(Table& table, SimSlaveConfig& slave);
  void read_clock(Table& table, SimSlaveConfig& slave);
  void read_bridge(Table& table, SimSlaveConfig& slave);
  void check_count(Table& table, const SimSlaveConfig& slave, std::int64_t count);
  void repeat(const toml::table& node, const SimSlaveConfig& first, std::int64_t count, double spread_ppm);

  const DeviceSource& devices_;
  const std::string& file_;
  std::uint64_t seed_;
  double host_ppm_;
  std::optional<Error>& error_;
  std::vector<SimSlaveConfig> slaves_;
  std::vector<const toml::table*> nodes_;  // of each slave
};

}  // namespace syncline::sim
