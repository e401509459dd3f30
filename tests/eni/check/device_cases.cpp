// SPDX-License-Identifier: Apache-2.0
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"

namespace syncline::test {
namespace {

constexpr Identity kYaskawa{0x539, 0x0220'0001, 0x10002, 0}, kCopley{0xAB, 0x10B0, 0x10002, 0},
    kGateway{0x2, 0x1A5F'3052, 0x10002, 0};

/// The last drive becomes another one, with the reads of its identity.
SlaveConfig& become(NetworkConfig& c, const Identity& identity) {
  SlaveConfig& slave = c.slaves[kLastDrive];
  const std::uint32_t old[] = {slave.identity.vendor_id, slave.identity.product_code};
  const std::uint32_t now[] = {identity.vendor_id, identity.product_code};
  for (InitCmd& cmd : slave.init_cmds) {
    if (!cmd.validate || cmd.validate->data.size() != 4) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      if (load_le<std::uint32_t>(cmd.validate->data) == old[i]) {
        cmd.validate->data = le_bytes(now[i]);
        break;
      }
    }
  }
  slave.identity = identity;
  return slave;
}

void write_object(SlaveConfig& slave, std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t> data) {
  CoeInitCmd cmd;
  cmd.command.transitions = {Transition::kPS};
  cmd.command.index = index;
  cmd.command.sub_index = sub_index;
  cmd.command.data = std::move(data);
  slave.mailbox->coe_commands.push_back(std::move(cmd));
}

void set_sync0(NetworkConfig& c, std::uint32_t cycle) {
  c.slaves[kLastDrive].dc->cycle_time0 = cycle;
  store_le(std::span<std::uint8_t>(command(c, kLastDrive, Transition::kPS, reg::kSync0CycleTime).data), cycle);
}

void switch_sync_off(NetworkConfig& c) {
  SlaveConfig& slave = c.slaves[kLastDrive];
  std::erase_if(slave.init_cmds, [](const InitCmd& cmd) { return cmd.ado >= 0x0980 && cmd.ado <= 0x09AF; });
  *slave.dc = SlaveDcConfig{};
}

/// So many entries of a TxPDO that nobody maps into memory: the SyncManager keeps its length by entries of no bits.
void map_objects(SlaveConfig& slave, std::size_t count) {
  for (ConfiguredPdo& pdo : slave.pdos) {
    if (pdo.direction == PdoDirection::kTx && pdo.pdo.sync_manager) {
      std::vector<PdoEntry> entries;
      for (std::size_t i = 0; i < count; ++i)
        entries.push_back({0x6064, 0, static_cast<std::uint16_t>(i < 4 ? 16 : 0), "Object", "INT"});
      pdo.pdo.entries = std::move(entries);
      std::erase_if(slave.mailbox->coe_commands,
                    [&](const CoeInitCmd& cmd) { return cmd.command.index == pdo.pdo.index; });
    }
  }
}

}  // namespace

std::vector<RuleCase> device_cases() {
  return {
      {"ENI-DEV-01",
       [](NetworkConfig& c) {
         become(c, kYaskawa);
         set_sync0(c, 5'000'000);
       }},
      {"ENI-DEV-02",
       [](NetworkConfig& c) {
         become(c, kCopley);
         set_sync0(c, 125'000);
       }},
      {"ENI-DEV-03", [](NetworkConfig& c) { map_objects(become(c, kYaskawa), 17); }},
      {"ENI-DEV-04",
       [](NetworkConfig& c) {
         write_object(become(c, kYaskawa), 0x10F1, 2, {16, 0});
       }},
      {"ENI-DEV-05",
       [](NetworkConfig& c) {
         write_object(become(c, kYaskawa), 0x10F1, 2, {0, 0});
       }},
      {"ENI-DEV-06",
       [](NetworkConfig& c) {
         switch_sync_off(c);
         write_object(c.slaves[kLastDrive], 0x6060, 0, {9});
       },
       {"ENI-DC-06"}},
      {"ENI-DEV-07",
       [](NetworkConfig& c) {
         write_object(become(c, kYaskawa), 0x1C32, 1, {2, 0});
       }},
      {"ENI-DEV-08",
       [](NetworkConfig& c) {
         write_object(become(c, kCopley), 0x1C33, 1, {0, 0});
       }},
      {"ENI-DEV-09",
       [](NetworkConfig& c) { write_object(become(c, kGateway), 0xF800, 4, le_bytes<std::uint32_t>(1'500'000)); }},
      {"ENI-DEV-10",
       [](NetworkConfig& c) {
         switch_sync_off(c);
         write_object(become(c, kGateway), 0xF800, 4, le_bytes<std::uint32_t>(2'000'000));
       },
       {"ENI-DC-06"}},
  };
}

}  // namespace syncline::test
