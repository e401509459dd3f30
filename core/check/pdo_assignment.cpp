// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "check/network_view.h"
#include "config/network_config.h"
#include "config/slave_config.h"

namespace syncline::checker {
namespace {

class PdoCheck {
 public:
  PdoCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : slave_(slave), config_(view.config.slaves[slave]), findings_(findings) {
    for (const auto& manager : config_.sync_managers) {
      for (const std::uint16_t pdo : manager.pdos) manager_of_.emplace(pdo, manager.number);
    }
    for (const auto& pdo : config_.pdos) described_.insert(pdo.pdo.index);
  }

  void run() {
    for (std::size_t m = 0; m < config_.sync_managers.size(); ++m) {
      check_described(m);
    }
    for (std::size_t p = 0; p < config_.pdos.size(); ++p) {
      const ConfiguredPdo& pdo = config_.pdos[p];
      const auto assigned = manager_of_.find(pdo.pdo.index);
      check_attribute(p, assigned == manager_of_.end() ? std::nullopt : std::optional(assigned->second));
      check_excluded(p);
      if (pdo.pdo.mandatory && assigned == manager_of_.end()) {
        findings_.add("ENI-PDO-04", {PlaceKind::kPdo, slave_, p}, fig::hex<"pdo">(pdo.pdo.index));
      }
      if (!seen_.insert(pdo.pdo.index).second) {
        findings_.add("ENI-PDO-05", {PlaceKind::kPdo, slave_, p}, fig::hex<"pdo">(pdo.pdo.index));
      }
    }
  }

 private:
  void check_described(std::size_t m) {
    const ConfiguredSyncManager& manager = config_.sync_managers[m];
    for (const std::uint16_t pdo : manager.pdos) {
      if (!described_.contains(pdo)) {
        findings_.add("ENI-PDO-01", {PlaceKind::kSyncManager, slave_, m}, fig::number<"manager">(manager.number),
                      fig::hex<"pdo">(pdo));
      }
    }
  }

  void check_attribute(std::size_t p, std::optional<std::uint8_t> assigned) {
    const Pdo& pdo = config_.pdos[p].pdo;
    if (pdo.sync_manager == assigned) return;
    findings_.add("ENI-PDO-02", {PlaceKind::kPdo, slave_, p}, fig::hex<"pdo">(pdo.index),
                  manager<"said">(pdo.sync_manager), manager<"assigned">(assigned));
  }
  template <FigureName kName>
  static Named<kName> manager(std::optional<std::uint8_t> number) {
    return number ? fig::text<kName>(fmt::format("SM{}", *number)) : fig::phrase<kName>("no SyncManager");
  }

  void check_excluded(std::size_t p) {
    const Pdo& pdo = config_.pdos[p].pdo;
    if (!manager_of_.contains(pdo.index)) return;
    for (const std::uint16_t other : pdo.exclude) {
      // Both sides may exclude each other: one finding for the pair.
      if (other == pdo.index || !manager_of_.contains(other) || !pairs_.insert(pair_of(pdo.index, other)).second)
        continue;
      findings_.add("ENI-PDO-03", {PlaceKind::kPdo, slave_, p}, fig::hex<"pdo">(pdo.index), fig::hex<"other">(other));
    }
  }

  static std::uint32_t pair_of(std::uint16_t a, std::uint16_t b) {
    return std::uint32_t{std::min(a, b)} << 16 | std::max(a, b);
  }

  std::size_t slave_;
  const SlaveConfig& config_;
  Findings& findings_;
  std::unordered_map<std::uint16_t, std::uint8_t> manager_of_;
  std::unordered_set<std::uint16_t> described_, seen_;
  std::unordered_set<std::uint32_t> pairs_;
};

}  // namespace

void check_pdo_assignment(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    PdoCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
