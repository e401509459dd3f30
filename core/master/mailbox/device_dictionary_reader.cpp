// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/device_dictionary_reader.h"

#include <algorithm>
#include <set>

#include "config/device_description.h"
#include "config/device_dictionary.h"
#include "master/mailbox/coe_client.h"
#include "master/mailbox/object_dictionary_reader.h"
#include "protocol/coe.h"
#include "protocol/coe_data_type.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kRxBegin = 0x1600, kRxEnd = 0x1800, kTxBegin = 0x1A00, kTxEnd = 0x1C00;
constexpr std::uint16_t kAssignRx = 0x1C12, kAssignTx = 0x1C13;

ObjectEntry entry_of(const coe::EntryDescription& from) {
  ObjectEntry entry;
  entry.sub_index = from.sub_index;
  entry.name = from.name;
  entry.data_type = coe::esi_type_name(from.data_type, from.bit_length);
  entry.bit_length = from.bit_length;
  entry.readable = (from.access & coe::access::kRead) != 0;
  entry.writable = (from.access & coe::access::kWrite) != 0;
  entry.rx_mappable = (from.access & coe::access::kRxPdo) != 0;
  entry.tx_mappable = (from.access & coe::access::kTxPdo) != 0;
  entry.backup = (from.access & coe::access::kBackup) != 0;
  entry.setting = (from.access & coe::access::kSettings) != 0;
  entry.default_data = from.default_value;
  entry.min_data = from.minimum;
  entry.max_data = from.maximum;
  return entry;
}

class DictionaryReader {
 public:
  DictionaryReader(MailboxClient& mailbox, const DeviceDescription& known)
      : mailbox_(mailbox), known_(known), coe_(mailbox) {}

  Result<DeviceDictionary> run() {
    const bool describes = known_.mailbox && known_.mailbox->coe && known_.mailbox->coe->sdo_info;
    if (describes) {
      if (auto status = read_objects(); !status) return tl::unexpected(status.error());
    }
    for (const auto assign : {kAssignRx, kAssignTx}) {
      if (auto status = read_direction(assign); !status) return tl::unexpected(status.error());
    }
    return std::move(dictionary_);
  }

 private:
  Status read_objects() {
    const auto objects = ObjectDictionaryReader(mailbox_).read();
    if (!objects) return tl::unexpected(objects.error());
    for (const auto& [object, entries, error] : *objects) {
      if (error) continue;
      ObjectDescription out;
      out.index = object.index;
      out.name = object.name;
      out.code = static_cast<ObjectCode>(object.code);
      std::uint32_t offset = 0;
      for (const auto& entry : entries) {
        out.entries.push_back(entry_of(entry));
        out.entries.back().bit_offset = offset;
        offset += entry.sub_index == 0 && object.code != coe::ObjectCode::kVariable ? 16U : entry.bit_length;
      }
      dictionary_.objects.push_back(std::move(out));
    }
    return {};
  }

  /// A number of the dictionary; nothing when the device refuses it.
  Result<std::optional<std::uint32_t>> number(std::uint16_t index, std::uint8_t sub_index) {
    const auto bytes = coe_.upload({index, sub_index});
    if (!bytes && bytes.error().code != ErrorCode::kSdoAbort) return tl::unexpected(bytes.error());
    if (!bytes || bytes->empty() || bytes->size() > 4) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes->size(); ++i) value |= std::uint32_t{(*bytes)[i]} << (8 * i);
    return value;
  }
  /// Sub-index 1 to the count in sub-index 0.
  Result<std::vector<std::uint32_t>> list(std::uint16_t index) {
    std::vector<std::uint32_t> values;
    const auto count = number(index, 0);
    if (!count) return tl::unexpected(count.error());
    for (std::uint32_t sub = 1; sub <= std::min(count->value_or(0), 254U); ++sub) {
      const auto value = number(index, static_cast<std::uint8_t>(sub));
      if (!value) return tl::unexpected(value.error());
      if (*value) values.push_back(**value);
    }
    return values;
  }

  Status read_direction(std::uint16_t assign) {
    const bool rx = assign == kAssignRx;
    auto& assigned = rx ? dictionary_.assigned_rx : dictionary_.assigned_tx;
    auto& pdos = rx ? dictionary_.rx_pdos : dictionary_.tx_pdos;
    const auto indices = list(assign);
    if (!indices) return tl::unexpected(indices.error());
    std::set<std::uint16_t> all;
    for (const auto index : *indices) {
      if (index == 0) continue;
      assigned.push_back(static_cast<std::uint16_t>(index));
      all.insert(assigned.back());
    }
    for (const auto& pdo : known_.pdos(rx ? PdoDirection::kRx : PdoDirection::kTx)) all.insert(pdo.index);
    for (const auto& object : dictionary_.objects) {
      if (object.index >= (rx ? kRxBegin : kTxBegin) && object.index < (rx ? kRxEnd : kTxEnd)) all.insert(object.index);
    }
    for (const auto index : all) {
      auto mapped = list(index);
      if (!mapped) return tl::unexpected(mapped.error());
      const bool is_assigned = std::ranges::find(assigned, index) != assigned.end();
      if (mapped->empty() && !is_assigned) continue;
      pdos.push_back({index, name_of(index), std::move(*mapped), is_writable(index)});
    }
    return {};
  }

  [[nodiscard]] std::string name_of(std::uint16_t index) const {
    const auto object = std::ranges::find(dictionary_.objects, index, &ObjectDescription::index);
    if (object != dictionary_.objects.end() && !object->name.empty()) return object->name;
    for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
      const auto pdo = std::ranges::find(known_.pdos(direction), index, &Pdo::index);
      if (pdo != known_.pdos(direction).end()) return pdo->name;
    }
    return {};
  }
  [[nodiscard]] bool is_writable(std::uint16_t index) const {
    const auto object = std::ranges::find(dictionary_.objects, index, &ObjectDescription::index);
    return object != dictionary_.objects.end() && !object->entries.empty() && object->entries.front().writable;
  }

  MailboxClient& mailbox_;
  const DeviceDescription& known_;
  CoeClient coe_;
  DeviceDictionary dictionary_;
};

}  // namespace

Result<DeviceDictionary> read_device_dictionary(MailboxClient& mailbox, const DeviceDescription& known) {
  return DictionaryReader(mailbox, known).run();
}

}  // namespace syncline
