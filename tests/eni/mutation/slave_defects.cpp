// SPDX-License-Identifier: Apache-2.0
#include "eni/mutation/defects.h"

namespace syncline::test {
namespace {

SlaveConfig* any_slave(NetworkConfig& config, Random& random) {
  return pick_if(config.slaves, random, [](const SlaveConfig& slave) { return !slave.init_cmds.empty(); });
}

bool move_station(NetworkConfig& config, Random& random) {
  SlaveConfig* slave = any_slave(config, random);
  if (slave == nullptr) return false;
  slave->station_address = static_cast<std::uint16_t>(slave->station_address + 100 + pick(random, 100));
  return true;
}

bool share_station_address(NetworkConfig& config, Random& random) {
  if (config.slaves.size() < 2) return false;
  const std::size_t i = pick(random, config.slaves.size());
  config.slaves[i].station_address = config.slaves[(i + 1) % config.slaves.size()].station_address;
  return true;
}

bool change_place(NetworkConfig& config, Random& random) {
  SlaveConfig* slave = any_slave(config, random);
  if (slave != nullptr)
    slave->auto_increment_address = static_cast<std::uint16_t>(slave->auto_increment_address - 1 - pick(random, 4));
  return slave != nullptr;
}

bool change_identity(NetworkConfig& config, Random& random) {
  SlaveConfig* slave = any_slave(config, random);
  if (slave == nullptr) return false;
  std::uint32_t& value = random.next() % 2 == 0 ? slave->identity.vendor_id : slave->identity.product_code;
  value ^= 1U << pick(random, 16);
  return true;
}

bool hang_on_itself(NetworkConfig& config, Random& random) {
  std::vector<std::size_t> hanging;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (config.slaves[i].previous) hanging.push_back(i);
  }
  if (hanging.empty()) return false;
  const std::size_t i = hanging[pick(random, hanging.size())];
  config.slaves[i].previous->position = static_cast<std::uint16_t>(i);
  return true;
}

bool share_port(NetworkConfig& config, Random& random) {
  if (config.slaves.size() < 3) return false;
  const std::size_t i = 2 + pick(random, config.slaves.size() - 2);
  if (!config.slaves[i].previous || config.slaves[i].previous == config.slaves[i - 1].previous) return false;
  config.slaves[i].previous = config.slaves[i - 1].previous;
  return config.slaves[i].previous.has_value();
}

bool give_alias(NetworkConfig& config, Random& random) {
  config.slaves[pick(random, config.slaves.size())].alias ^= static_cast<std::uint16_t>(1 + pick(random, 1000));
  return true;
}

ConfiguredSyncManager* manager_with_pdos(NetworkConfig& config, Random& random, std::size_t least = 1) {
  std::vector<ConfiguredSyncManager*> found;
  for (SlaveConfig& slave : config.slaves) {
    for (auto& manager : slave.sync_managers) {
      if (manager.pdos.size() >= least && !slave.init_cmds.empty()) found.push_back(&manager);
    }
  }
  return found.empty() ? nullptr : found[pick(random, found.size())];
}

bool lose_pdo(NetworkConfig& config, Random& random) {
  ConfiguredSyncManager* manager = manager_with_pdos(config, random);
  if (manager != nullptr)
    manager->pdos.erase(manager->pdos.begin() + static_cast<std::ptrdiff_t>(pick(random, manager->pdos.size())));
  return manager != nullptr;
}

bool assign_unknown_pdo(NetworkConfig& config, Random& random) {
  ConfiguredSyncManager* manager = manager_with_pdos(config, random);
  if (manager != nullptr) manager->pdos[pick(random, manager->pdos.size())] = 0x17F0;
  return manager != nullptr;
}

bool assign_pdo_twice(NetworkConfig& config, Random& random) {
  ConfiguredSyncManager* manager = manager_with_pdos(config, random);
  if (manager != nullptr) manager->pdos.push_back(manager->pdos[pick(random, manager->pdos.size())]);
  return manager != nullptr;
}

bool move_manager(NetworkConfig& config, Random& random) {
  ConfiguredSyncManager* manager = manager_with_pdos(config, random);
  if (manager != nullptr)
    manager->description.start_address =
        static_cast<std::uint16_t>(manager->description.start_address + 2 + 2 * pick(random, 60));
  return manager != nullptr;
}

bool turn_manager(NetworkConfig& config, Random& random) {
  ConfiguredSyncManager* manager = manager_with_pdos(config, random);
  if (manager != nullptr)
    manager->description.type =
        manager->description.type == SyncManagerType::kInputs ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
  return manager != nullptr;
}

/// Entry of a PDO that is assigned gets another length.
bool lengthen_entry(NetworkConfig& config, Random& random) {
  std::vector<PdoEntry*> found;
  for (SlaveConfig& slave : config.slaves) {
    for (auto& pdo : slave.pdos) {
      if (!pdo.pdo.sync_manager || slave.init_cmds.empty()) continue;
      for (PdoEntry& entry : pdo.pdo.entries) found.push_back(&entry);
    }
  }
  if (found.empty()) return false;
  PdoEntry& entry = *found[pick(random, found.size())];
  entry.bit_length = static_cast<std::uint16_t>(entry.bit_length + 16);
  return true;
}

std::optional<ImageRange>* range_of(NetworkConfig& config, Random& random) {
  std::vector<std::optional<ImageRange>*> found;
  for (SlaveConfig& slave : config.slaves) {
    for (auto* range : {&slave.send, &slave.receive}) {
      if (*range && (*range)->bit_length > 0 && slave.send_parts.empty() && slave.receive_parts.empty())
        found.push_back(range);
    }
  }
  return found.empty() ? nullptr : found[pick(random, found.size())];
}

bool move_range(NetworkConfig& config, Random& random) {
  auto* range = range_of(config, random);
  if (range != nullptr) (*range)->bit_start += static_cast<std::uint32_t>(8 * (1 + pick(random, 8)));
  return range != nullptr;
}

bool lengthen_range(NetworkConfig& config, Random& random) {
  auto* range = range_of(config, random);
  if (range != nullptr) (*range)->bit_length += static_cast<std::uint32_t>(8 * (1 + pick(random, 8)));
  return range != nullptr;
}

constexpr DefectKind kSlaveKinds[] = {{"another station address", true, move_station},
                                      {"the station address of another", true, share_station_address},
                                      {"another auto-increment address", true, change_place},
                                      {"another identity", true, change_identity},
                                      {"a slave that hangs on itself", true, hang_on_itself},
                                      {"two slaves at one port", true, share_port},
                                      {"a PDO is missing in a SyncManager's list", true, lose_pdo},
                                      {"a PDO that nobody describes", true, assign_unknown_pdo},
                                      {"a PDO twice in a list", true, assign_pdo_twice},
                                      {"a SyncManager elsewhere", true, move_manager},
                                      {"a SyncManager in the other direction", true, turn_manager},
                                      {"the length of an entry", true, lengthen_entry},
                                      {"a slave's data elsewhere in the image", true, move_range},
                                      {"the size of a slave's data", true, lengthen_range},
                                      {"another alias", false, give_alias}};

}  // namespace

std::span<const DefectKind> slave_defects() { return kSlaveKinds; }

}  // namespace syncline::test
