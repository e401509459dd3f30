// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/sim_config.h"
#include "support/result.h"

namespace syncline::sim {

class Table;

/// Reads the [[fault]]s of a scenario, whose slaves are known already. What a fault cannot have, what contradicts the
/// machine, and what contradicts another fault are errors of the file.
class ScenarioFaults {
 public:
  /// Slaves, file and error outlive it; `before` is what happens to the machine anyway.
  ScenarioFaults(std::span<const SimSlaveConfig> slaves, const std::string& file, std::optional<Error>& error,
                 std::vector<FaultConfig> before)
      : slaves_(slaves), file_(file), error_(error), faults_(std::move(before)) {}
  void read(const toml::table& node);
  [[nodiscard]] std::vector<FaultConfig> take() { return std::move(faults_); }

 private:
  void check_slave(Table& table, const FaultConfig& fault);
  void check_port(Table& table, const FaultConfig& fault);
  void check_time(Table& table, const FaultConfig& fault);
  void check_stalls(Table& table, const FaultConfig& fault, std::string_view name);
  [[nodiscard]] bool has_cable(int slave, std::uint8_t port) const;

  std::span<const SimSlaveConfig> slaves_;
  const std::string& file_;
  std::optional<Error>& error_;
  std::vector<FaultConfig> faults_;
};

/// "A" to "D" of `key`; without it `fallback`.
[[nodiscard]] std::uint8_t port_number(Table& table, std::string_view key, char fallback);

}  // namespace syncline::sim
