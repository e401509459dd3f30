// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/slave_config.h"
#include "eni/format/eni_element.h"
#include "eni/format/eni_reader.h"
#include "protocol/registers.h"
#include "protocol/station_address.h"
#include "support/types.h"

namespace syncline::eni {
namespace {

void read_identification(const EniElement& element, SlaveConfig& slave) {
  if (!element) {
    return;
  }
  const Identification found{element.number_of<std::uint16_t>("Ado"),
                             element.number_attribute<std::uint32_t>("Value").value_or(0)};
  if (found.ado == reg::kStationAlias && found.value <= UINT16_MAX) {
    slave.alias = static_cast<std::uint16_t>(found.value);
  } else {
    slave.identification = found;
  }
}

void read_info(const EniElement& info, SlaveConfig& slave, std::uint16_t position) {
  slave.name = info.text_of("Name");
  slave.station_address = info.number_of<std::uint16_t>("PhysAddr", usual_station_address(position));
  slave.auto_increment_address =
      info.number_of<std::uint16_t>("AutoIncAddr", Position{position}.auto_increment_address());
  read_identification(info.child("Identification"), slave);
  slave.physics = info.text_of("Physics");
  slave.identity = {info.number_of<std::uint32_t>("VendorId"), info.number_of<std::uint32_t>("ProductCode"),
                    info.number_of<std::uint32_t>("RevisionNo"), info.number_of<std::uint32_t>("SerialNo")};
  slave.product_revision = info.text_of("ProductRevision");
}

std::vector<ImageRange> read_ranges(const EniElement& process_data, const char* name) {
  std::vector<ImageRange> ranges;
  for (const EniElement& element : process_data.children(name)) {
    ImageRange range{element.number_of<std::uint32_t>("BitStart"), element.number_of<std::uint32_t>("BitLength")};
    for (int number = 0; number < kMaxSyncManagers; ++number) {
      if (element.boolean_attribute(("Sm" + std::to_string(number)).c_str())) {
        range.sync_managers = static_cast<std::uint16_t>(range.sync_managers | 1U << number);
      }
    }
    if (range.bit_length > UINT32_MAX - range.bit_start) {
      element.report(ErrorCode::kXmlBadValue, element.text_of("BitLength"));
      range = {};
    }
    ranges.push_back(range);
  }
  return ranges;
}

/// One element a SyncManager is allowed; the slave's part of the image spans them.
void take_ranges(std::vector<ImageRange> ranges, std::optional<ImageRange>& whole, std::vector<ImageRange>& parts) {
  if (ranges.empty()) {
    return;
  }
  if (ranges.size() == 1) {
    whole = ranges.front();
    return;
  }
  std::uint32_t first = UINT32_MAX;
  std::uint32_t end = 0;
  for (const ImageRange& range : ranges) {
    first = std::min(first, range.bit_start);
    end = std::max(end, range.bit_start + range.bit_length);
  }
  whole = ImageRange{first, end - first};
  parts = std::move(ranges);
}

SyncManagerType read_type(const EniElement& element) {
  const std::string word = element.text();
  if (const auto type = sync_manager_type(word)) return *type;
  if (element) element.report(ErrorCode::kXmlBadValue, word);
  return SyncManagerType::kUnused;
}

ConfiguredSyncManager read_sync_manager(const EniElement& element, int number) {
  ConfiguredSyncManager manager;
  manager.number = static_cast<std::uint8_t>(number);
  SyncManagerDescription& description = manager.description;
  description.type = read_type(element.child("Type"));
  description.start_address = element.number_of<std::uint16_t>("StartAddress");
  description.min_size = element.optional_number_of<std::uint16_t>("MinSize");
  description.max_size = element.optional_number_of<std::uint16_t>("MaxSize");
  description.default_size = element.optional_number_of<std::uint16_t>("DefaultSize");
  description.control_byte = element.number_of<std::uint8_t>("ControlByte");
  description.enable = element.boolean_of("Enable");
  description.is_virtual = element.boolean_of("Virtual");
  manager.watchdog = element.optional_number_of<std::uint32_t>("Watchdog");
  manager.pdos = read_each(element.children("Pdo"), [](const EniElement& pdo) { return pdo.number<std::uint16_t>(); });
  return manager;
}

/// "1" to "3" and the words of xs:boolean.
std::uint8_t read_swap(const EniElement& data_type) {
  const std::string text = data_type.attribute("SwapData");
  if (text == "true" || text == "false") {
    return text == "true" ? 1 : 0;
  }
  return data_type.number_attribute<std::uint8_t>("SwapData").value_or(0);
}

PdoEntry read_entry(const EniElement& element) {
  PdoEntry entry;
  entry.index = element.number_of<std::uint16_t>("Index");
  entry.sub_index = element.number_of<std::uint8_t>("SubIndex");
  entry.bit_length = element.number_of<std::uint16_t>("BitLen");
  entry.name = element.text_of("Name");
  entry.fixed = element.boolean_attribute("Fixed");
  entry.comment = element.text_of("Comment");
  const EniElement data_type = element.child("DataType");
  entry.data_type = data_type.text();
  entry.scale = data_type.attribute("DScale");
  entry.swap = read_swap(data_type);
  return entry;
}

ConfiguredPdo read_pdo(const EniElement& element) {
  ConfiguredPdo out;
  out.direction = element.name() == "TxPdo" ? PdoDirection::kTx : PdoDirection::kRx;
  Pdo& pdo = out.pdo;
  pdo.index = element.number_of<std::uint16_t>("Index");
  pdo.name = element.text_of("Name");
  pdo.sync_manager = element.number_attribute<std::uint8_t>("Sm");
  pdo.fixed = element.boolean_attribute("Fixed");
  pdo.mandatory = element.boolean_attribute("Mandatory");
  pdo.is_virtual = element.boolean_attribute("Virtual");
  pdo.sync_unit = element.number_attribute<std::uint8_t>("Su");
  pdo.order = element.number_attribute<int>("PdoOrder");
  pdo.os_factor = element.number_attribute<std::uint16_t>("OSFac");
  pdo.os_min = element.number_attribute<std::uint16_t>("OSMin");
  pdo.os_max = element.number_attribute<std::uint16_t>("OSMax");
  pdo.os_index_increment = element.number_attribute<std::uint16_t>("OSIndexInc");
  pdo.overwritten_by_module = element.boolean_attribute("OverwrittenByModule");
  pdo.exclude = read_each(element.children("Exclude"),
                          [](const EniElement& excluded) { return excluded.number<std::uint16_t>(); });
  pdo.entries = read_each(element.children("Entry"), [](const EniElement& entry) { return read_entry(entry); });
  return out;
}

void read_process_data(const EniElement& process_data, SlaveConfig& slave) {
  take_ranges(read_ranges(process_data, "Send"), slave.send, slave.send_parts);
  take_ranges(read_ranges(process_data, "Recv"), slave.receive, slave.receive_parts);
  for (int number = 0; number < kMaxSyncManagers; ++number) {
    const std::string name = "Sm" + std::to_string(number);
    if (const EniElement element = process_data.child(name.c_str())) {
      slave.sync_managers.push_back(read_sync_manager(element, number));
    }
  }
  slave.pdos.reserve(process_data.children("TxPdo").size() + process_data.children("RxPdo").size());
  for (const char* name : {"TxPdo", "RxPdo"}) {
    for (const EniElement& pdo : process_data.children(name)) {
      slave.pdos.push_back(read_pdo(pdo));
    }
  }
}

std::optional<HotConnectConfig> read_hot_connect(const EniElement& element) {
  if (!element) {
    return std::nullopt;
  }
  HotConnectConfig group;
  group.group = element.text_of("GroupName");
  group.member_count = std::max<std::uint16_t>(1, element.number_of<std::uint16_t>("GroupMemberCnt", 1));
  group.identify_cmds =
      read_each(element.children("IdentifyCmd"), [](const EniElement& cmd) { return read_init_cmd(cmd); });
  return group;
}

std::optional<SlaveDcConfig> read_dc(const EniElement& element) {
  SlaveDcConfig dc;
  dc.potential_reference_clock = element.boolean_of("PotentialReferenceClock");
  // A DC element that says only "no potential reference clock" is how tools mark a slave without DC.
  if (!element.child("ReferenceClock") && !element.child("CycleTime0") && !dc.potential_reference_clock) {
    return std::nullopt;
  }
  dc.reference_clock = element.boolean_of("ReferenceClock");
  dc.cycle_time0 = element.number_of<std::int64_t>("CycleTime0");
  dc.cycle_time1 = element.number_of<std::int64_t>("CycleTime1");
  dc.shift_time = element.number_of<std::int64_t>("ShiftTime");
  return dc;
}

}  // namespace

SlaveConfig read_slave(const EniElement& element, std::uint16_t position) {
  SlaveConfig slave;
  read_info(element.required("Info"), slave, position);
  read_process_data(element.child("ProcessData"), slave);
  slave.mailbox = read_mailbox(element.child("Mailbox"));
  slave.init_cmds = read_init_cmds(element.child("InitCmds"));
  slave.hot_connect = read_hot_connect(element.child("HotConnect"));
  slave.dc = read_dc(element.child("DC"));
  derive_slave(slave);
  return slave;
}

}  // namespace syncline::eni
