// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "config/network_config.h"
#include "config/slave_config.h"
#include "exports/csv_row.h"
#include "exports/exports.h"

namespace syncline::exports {
namespace {

void append_variables(std::string& out, const char* direction, const std::vector<Variable>& variables) {
  for (const auto& variable : variables) {
    out += CsvRow()
               .text(direction)
               .text(variable.name)
               .text(variable.data_type)
               .number(variable.bit_size)
               .number(variable.bit_offset / 8)
               .number(variable.bit_offset % 8)
               .text(variable.comment)
               .end();
  }
}

/// Where the assigned PDOs lie: one behind the other in the order of the SyncManagers, in the slave's part of the
/// image.
class Places {
 public:
  explicit Places(const SlaveConfig& slave) {
    for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) place(slave, direction);
  }
  [[nodiscard]] std::optional<std::uint32_t> of(PdoDirection direction, std::uint16_t pdo) const {
    const auto found = starts_.find({direction, pdo});
    return found == starts_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  void place(const SlaveConfig& slave, PdoDirection direction) {
    const auto& range = direction == PdoDirection::kRx ? slave.send : slave.receive;
    if (!range) return;
    const auto& parts = direction == PdoDirection::kRx ? slave.send_parts : slave.receive_parts;
    const auto type = direction == PdoDirection::kRx ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
    std::uint32_t bit = range->bit_start;
    for (const auto& manager : slave.sync_managers) {
      if (manager.description.type != type) continue;
      for (const auto& part : parts) {
        if ((part.sync_managers >> manager.number & 1) != 0) bit = part.bit_start;
      }
      for (const std::uint16_t index : manager.pdos) {
        const auto pdo = std::ranges::find_if(slave.pdos, [&](const ConfiguredPdo& configured) {
          return configured.direction == direction && configured.pdo.index == index;
        });
        if (pdo == slave.pdos.end()) continue;
        starts_[{direction, index}] = bit;
        bit += pdo->pdo.bit_length();
      }
    }
  }

  std::map<std::pair<PdoDirection, std::uint16_t>, std::uint32_t> starts_;
};

std::string protocols(const std::optional<MailboxConfig>& mailbox) {
  if (!mailbox) return {};
  std::string text;
  const std::pair<bool, const char*> all[] = {{mailbox->aoe, "AoE"}, {mailbox->eoe, "EoE"}, {mailbox->coe, "CoE"},
                                              {mailbox->soe, "SoE"}, {mailbox->foe, "FoE"}, {mailbox->voe, "VoE"}};
  for (const auto& [supported, name] : all) {
    if (supported) text += (text.empty() ? "" : " ") + std::string(name);
  }
  return text;
}

std::string dc_text(const SlaveConfig& slave) {
  if (!slave.dc) return "no";
  return slave.dc->reference_clock ? "reference clock" : slave.dc->assign_activate != 0 ? "yes" : "clock only";
}

void append_entries(std::string& out, std::size_t position, const SlaveConfig& slave) {
  const Places places(slave);
  for (const auto& [direction, pdo] : slave.pdos) {
    auto bit = places.of(direction, pdo.index);
    for (const auto& entry : pdo.entries) {
      CsvRow row;
      row.number(position).text(slave.name).text(direction == PdoDirection::kRx ? "output" : "input");
      row.hex(pdo.index, 4).text(pdo.name);
      pdo.sync_manager ? row.number(*pdo.sync_manager) : row.empty();
      row.hex(entry.index, 4).number(entry.sub_index).number(entry.bit_length).text(entry.name).text(entry.data_type);
      bit ? row.number(*bit / 8).number(*bit % 8) : row.empty().empty();
      out += row.end();
      if (bit) *bit += entry.bit_length;
    }
  }
}

void append_slave(std::string& out, std::size_t position, const SlaveConfig& slave) {
  CsvRow row;
  row.number(position).text(slave.name).number(slave.station_address).number(slave.alias);
  row.hex(slave.identity.vendor_id, 8).hex(slave.identity.product_code, 8).hex(slave.identity.revision_no, 8);
  row.number(slave.identity.serial_no).text(slave.physics);
  if (slave.previous) {
    row.number(slave.previous->position).text(std::string(1, static_cast<char>('A' + slave.previous->port)));
  } else {
    row.empty().empty();
  }
  row.number(slave.send ? slave.send->bit_length : 0U).number(slave.receive ? slave.receive->bit_length : 0U);
  row.text(protocols(slave.mailbox)).text(dc_text(slave)).text(slave.hot_connect ? slave.hot_connect->group : "");
  out += row.end();
}

}  // namespace

std::string image_csv(const NetworkConfig& config) {
  std::string out = "direction,name,data_type,bits,byte,bit,comment\r\n";
  append_variables(out, "input", config.image.inputs);
  append_variables(out, "output", config.image.outputs);
  return out;
}

std::string pdo_csv(const NetworkConfig& config) {
  std::string out =
      "slave,slave_name,direction,pdo,pdo_name,sync_manager,index,sub_index,bits,name,data_type,image_byte,image_"
      "bit\r\n";
  for (std::size_t i = 0; i < config.slaves.size(); ++i) append_entries(out, i, config.slaves[i]);
  return out;
}

std::string slaves_csv(const NetworkConfig& config) {
  std::string out =
      "position,name,station_address,alias,vendor_id,product_code,revision_no,serial_no,physics,previous,previous_port,"
      "output_bits,input_bits,mailbox,dc,hot_connect\r\n";
  for (std::size_t i = 0; i < config.slaves.size(); ++i) append_slave(out, i, config.slaves[i]);
  return out;
}

}  // namespace syncline::exports
