// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "protocol/sii.h"
#include "support/byte_order.h"

namespace syncline::sii {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kFixedBytes = 2 * kCategoriesWord;
constexpr std::size_t kChecksumBytes = 14;
constexpr std::size_t kMaxStrings = 255;
constexpr std::size_t kMaxStringLength = 255;

/// Names are stored once and referred to by a 1-based index; 0 is the empty name. What does not
/// fit (more than 255 names) becomes the empty name, as the format knows no more.
class StringPool {
 public:
  std::uint8_t index_of(const std::string& text) {
    if (text.empty()) return 0;
    const auto cut = text.substr(0, kMaxStringLength);
    const auto found = std::find(strings_.begin(), strings_.end(), cut);
    if (found != strings_.end()) return static_cast<std::uint8_t>(found - strings_.begin() + 1);
    if (strings_.size() >= kMaxStrings) return 0;
    strings_.push_back(cut);
    return static_cast<std::uint8_t>(strings_.size());
  }
  [[nodiscard]] Bytes encode() const {
    Bytes bytes{static_cast<std::uint8_t>(strings_.size())};
    for (const auto& text : strings_) {
      bytes.push_back(static_cast<std::uint8_t>(text.size()));
      bytes.insert(bytes.end(), text.begin(), text.end());
    }
    return bytes;
  }
  [[nodiscard]] bool empty() const { return strings_.empty(); }

 private:
  std::vector<std::string> strings_;
};

void append_category(Bytes& out, std::uint16_t type, Bytes data, std::uint8_t padding = 0) {
  if (data.size() % 2 != 0) data.push_back(padding);
  ByteWriter(out).u16(type).u16(static_cast<std::uint16_t>(data.size() / 2)).bytes(data);
}

void append_category(Bytes& out, CategoryType type, Bytes data, std::uint8_t padding = 0) {
  append_category(out, static_cast<std::uint16_t>(type), std::move(data), padding);
}

Bytes encode_general(const General& general, StringPool& strings) {
  Bytes bytes;
  const auto group = strings.index_of(general.group);
  const auto image = strings.index_of(general.image);
  const auto order = strings.index_of(general.order);
  const auto name = strings.index_of(general.name);
  ByteWriter(bytes)
      .u8(group)
      .u8(image)
      .u8(order)
      .u8(name)
      .u8(0)
      .u8(general.coe_details)
      .u8(general.foe_details)
      .u8(general.eoe_details)
      .zeros(3)  // SoE channels, DS402 channels, sysman class
      .u8(general.flags)
      .u16(static_cast<std::uint16_t>(general.ebus_current_ma))
      .u8(group)
      .u8(0)
      .u16(general.physical_ports)
      .u16(general.physical_memory_address)
      .zeros(12);
  return bytes;
}

Bytes encode_sync_managers(const std::vector<SyncM>& sync_managers) {
  Bytes bytes;
  ByteWriter writer(bytes);
  for (const auto& sm : sync_managers) {
    writer.u16(sm.start).u16(sm.length).u8(sm.control).u8(sm.status).u8(sm.enable).u8(sm.type);
  }
  return bytes;
}

Bytes encode_pdos(const std::vector<Pdo>& pdos, StringPool& strings) {
  Bytes bytes;
  ByteWriter writer(bytes);
  for (const auto& pdo : pdos) {
    writer.u16(pdo.index)
        .u8(static_cast<std::uint8_t>(pdo.entries.size()))
        .u8(pdo.sync_manager)
        .u8(pdo.synchronization)
        .u8(strings.index_of(pdo.name))
        .u16(pdo.flags);
    for (const auto& entry : pdo.entries) {
      writer.u16(entry.index)
          .u8(entry.sub_index)
          .u8(strings.index_of(entry.name))
          .u8(entry.data_type)
          .u8(entry.bit_length)
          .u16(entry.flags);
    }
  }
  return bytes;
}

Bytes encode_dc_modes(const std::vector<DcMode>& modes, StringPool& strings) {
  Bytes bytes;
  ByteWriter writer(bytes);
  for (const auto& mode : modes) {
    const auto name = strings.index_of(mode.name);
    const auto description = strings.index_of(mode.description);
    writer.u32(mode.cycle_time_sync0)
        .u32(mode.shift_time_sync0)
        .u32(mode.shift_time_sync1)
        .u16(static_cast<std::uint16_t>(mode.cycle_factor_sync1))
        .u16(mode.assign_activate)
        .u16(static_cast<std::uint16_t>(mode.cycle_factor_sync0))
        .u8(name)
        .u8(description)
        .zeros(4);
  }
  return bytes;
}

void write_mailbox(ByteWriter& writer, const MailboxArea& mailbox) {
  writer.u16(mailbox.receive_offset).u16(mailbox.receive_size).u16(mailbox.send_offset).u16(mailbox.send_size);
}

Bytes encode_fixed(const Image& image) {
  Bytes bytes;
  ByteWriter writer(bytes);
  writer.u16(image.pdi_control)
      .u16(image.pdi_configuration)
      .u16(image.sync_impulse_length)
      .u16(image.pdi_configuration2)
      .u16(image.alias)
      .u16(image.reserved[0])
      .u16(image.reserved[1]);
  writer.u16(checksum(std::span<const std::uint8_t>(bytes).first(kChecksumBytes)));
  writer.u32(image.vendor_id).u32(image.product_code).u32(image.revision_no).u32(image.serial_no);
  writer.zeros(8);
  write_mailbox(writer, image.bootstrap_mailbox);
  write_mailbox(writer, image.mailbox);
  writer.u16(image.mailbox_protocols);
  writer.zeros(kFixedBytes - bytes.size());
  return bytes;
}

Bytes encode_categories(const Image& image) {
  // The names' category stands first but is known last, so the others are made before it.
  StringPool strings;
  Bytes rest;
  if (image.general) append_category(rest, CategoryType::kGeneral, encode_general(*image.general, strings));
  if (!image.fmmus.empty()) append_category(rest, CategoryType::kFmmu, image.fmmus, 0xFF);
  if (!image.sync_managers.empty()) {
    append_category(rest, CategoryType::kSyncM, encode_sync_managers(image.sync_managers));
  }
  if (!image.tx_pdos.empty()) append_category(rest, CategoryType::kTxPdo, encode_pdos(image.tx_pdos, strings));
  if (!image.rx_pdos.empty()) append_category(rest, CategoryType::kRxPdo, encode_pdos(image.rx_pdos, strings));
  if (!image.dc_modes.empty()) append_category(rest, CategoryType::kDc, encode_dc_modes(image.dc_modes, strings));
  for (const auto& raw : image.other) append_category(rest, raw.type, raw.data);

  Bytes bytes;
  if (!strings.empty()) append_category(bytes, CategoryType::kStrings, strings.encode());
  ByteWriter(bytes).bytes(rest).u16(static_cast<std::uint16_t>(CategoryType::kEnd));
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> encode(const Image& image) {
  auto bytes = encode_fixed(image);
  const auto categories = encode_categories(image);
  bytes.insert(bytes.end(), categories.begin(), categories.end());
  const std::size_t wanted = std::max<std::size_t>(bytes.size(), image.size_bytes);
  const std::size_t size = (wanted + kSizeStep - 1) / kSizeStep * kSizeStep;
  const std::span<std::uint8_t> all(bytes);
  store_le(all.subspan(std::size_t{2} * kSizeWord), static_cast<std::uint16_t>(size / kSizeStep - 1));
  store_le(all.subspan(2 * 0x3F), std::uint16_t{1});  // version
  bytes.resize(size, 0xFF);
  return bytes;
}

}  // namespace syncline::sii
