// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "protocol/sii.h"
#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline::sii {
namespace {

constexpr std::size_t kFixedPart = 2 * kCategoriesWord;
constexpr std::size_t kGeneralMinimum = 14;  // up to the EBUS current; older images end early
constexpr std::size_t kSyncMBytes = 8;
constexpr std::size_t kDcModeBytes = 24;

struct Category {
  std::uint16_t type = 0;
  std::size_t word_offset = 0;  // of its header
  std::span<const std::uint8_t> data;
};

tl::unexpected<Error> broken(const Category& category, Reason what) {
  return fail(ErrorCode::kSii, "slave",
              because("category {category} at word 0x{word} {reason}", category.type,
                      fmt::format("{:04X}", category.word_offset), std::move(what)));
}

Result<std::vector<Category>> split(std::span<const std::uint8_t> bytes) {
  std::vector<Category> categories;
  ByteReader reader(bytes);
  reader.skip(kFixedPart);
  while (reader.remaining() >= 2) {
    Category category;
    category.word_offset = reader.position() / 2;
    category.type = reader.u16();
    if (category.type == static_cast<std::uint16_t>(CategoryType::kEnd)) break;
    const std::size_t words = reader.u16();
    if (category.type == 0 && words == 0) break;  // never written: zeros to the end
    category.data = reader.take(2 * words);
    if (!reader.ok()) return broken(category, because("of {words} words reaches beyond the image", words));
    if (category.type != 0) categories.push_back(category);  // type 0 fills space
  }
  return categories;
}

class StringTable {
 public:
  Status read(const Category& category) {
    ByteReader reader(category.data);
    const auto count = reader.u8();
    for (unsigned i = 0; i < count; ++i) {
      const auto length = reader.u8();
      const auto text = reader.take(length);
      if (!reader.ok()) return broken(category, because("ends inside string {number} of {count}", i + 1, count));
      strings_.emplace_back(text.begin(), text.end());
    }
    return {};
  }
  /// Real images hold indexes of names that are not there; they mean no name.
  [[nodiscard]] std::string at(std::uint8_t index) const {
    return index == 0 || index > strings_.size() ? std::string() : strings_[index - 1U];
  }

 private:
  std::vector<std::string> strings_;
};

Result<General> read_general(const Category& category, const StringTable& strings) {
  if (category.data.size() < kGeneralMinimum) return broken(category, because("is too short for general information"));
  ByteReader reader(category.data);
  General general;
  general.group = strings.at(reader.u8());
  general.image = strings.at(reader.u8());
  general.order = strings.at(reader.u8());
  general.name = strings.at(reader.u8());
  reader.skip(1);
  general.coe_details = reader.u8();
  general.foe_details = reader.u8();
  general.eoe_details = reader.u8();
  reader.skip(3);
  general.flags = reader.u8();
  general.ebus_current_ma = static_cast<std::int16_t>(reader.u16());
  reader.skip(2);
  general.physical_ports = reader.u16();
  general.physical_memory_address = reader.u16();
  return general;
}

Status read_sync_managers(const Category& category, std::vector<SyncM>& out) {
  ByteReader reader(category.data);
  if (category.data.size() % kSyncMBytes != 0) return broken(category, because("holds a part of a SyncManager"));
  while (reader.remaining() > 0) {
    SyncM sm;
    sm.start = reader.u16();
    sm.length = reader.u16();
    sm.control = reader.u8();
    sm.status = reader.u8();
    sm.enable = reader.u8();
    sm.type = reader.u8();
    out.push_back(sm);
  }
  return {};
}

PdoEntry read_entry(ByteReader& reader, const StringTable& strings) {
  PdoEntry entry;
  entry.index = reader.u16();
  entry.sub_index = reader.u8();
  entry.name = strings.at(reader.u8());
  entry.data_type = reader.u8();
  entry.bit_length = reader.u8();
  entry.flags = reader.u16();
  return entry;
}

Status read_pdos(const Category& category, const StringTable& strings, std::vector<Pdo>& out) {
  ByteReader reader(category.data);
  while (reader.remaining() > 0) {
    Pdo pdo;
    pdo.index = reader.u16();
    const auto entries = reader.u8();
    pdo.sync_manager = reader.u8();
    pdo.synchronization = reader.u8();
    pdo.name = strings.at(reader.u8());
    pdo.flags = reader.u16();
    for (unsigned i = 0; i < entries && reader.ok(); ++i) pdo.entries.push_back(read_entry(reader, strings));
    if (!reader.ok()) return broken(category, because("ends inside PDO 0x{index}", fmt::format("{:04X}", pdo.index)));
    out.push_back(std::move(pdo));
  }
  return {};
}

Status read_dc_modes(const Category& category, const StringTable& strings, std::vector<DcMode>& out) {
  ByteReader reader(category.data);
  if (category.data.size() % kDcModeBytes != 0) return broken(category, because("holds a part of a DC mode"));
  while (reader.remaining() > 0) {
    DcMode mode;
    mode.cycle_time_sync0 = reader.u32();
    mode.shift_time_sync0 = reader.u32();
    mode.shift_time_sync1 = reader.u32();
    mode.cycle_factor_sync1 = static_cast<std::int16_t>(reader.u16());
    mode.assign_activate = reader.u16();
    mode.cycle_factor_sync0 = static_cast<std::int16_t>(reader.u16());
    mode.name = strings.at(reader.u8());
    mode.description = strings.at(reader.u8());
    reader.skip(4);
    out.push_back(std::move(mode));
  }
  return {};
}

std::vector<std::uint8_t> read_fmmus(const Category& category) {
  std::vector<std::uint8_t> fmmus(category.data.begin(), category.data.end());
  if (!fmmus.empty() && fmmus.back() == 0xFF) fmmus.pop_back();  // filled up to a whole word
  return fmmus;
}

MailboxArea read_mailbox(ByteReader& reader) {
  MailboxArea mailbox;
  mailbox.receive_offset = reader.u16();
  mailbox.receive_size = reader.u16();
  mailbox.send_offset = reader.u16();
  mailbox.send_size = reader.u16();
  return mailbox;
}

Image read_fixed(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  Image image;
  image.pdi_control = reader.u16();
  image.pdi_configuration = reader.u16();
  image.sync_impulse_length = reader.u16();
  image.pdi_configuration2 = reader.u16();
  image.alias = reader.u16();
  for (auto& word : image.reserved) word = reader.u16();
  image.checksum_ok = (reader.u16() & 0xFF) == checksum(bytes.first(14));
  image.vendor_id = reader.u32();
  image.product_code = reader.u32();
  image.revision_no = reader.u32();
  image.serial_no = reader.u32();
  reader.skip(8);
  image.bootstrap_mailbox = read_mailbox(reader);
  image.mailbox = read_mailbox(reader);
  image.mailbox_protocols = reader.u16();
  image.size_bytes = static_cast<std::uint32_t>(told_size(bytes));
  return image;
}

Status read_category(const Category& category, const StringTable& strings, Image& image) {
  switch (static_cast<CategoryType>(category.type)) {
    case CategoryType::kStrings:
      return {};  // read before
    case CategoryType::kGeneral: {
      auto general = read_general(category, strings);
      if (!general) return tl::unexpected(general.error());
      image.general = std::move(*general);
      return {};
    }
    case CategoryType::kFmmu:
      image.fmmus = read_fmmus(category);
      return {};
    case CategoryType::kSyncM:
      return read_sync_managers(category, image.sync_managers);
    case CategoryType::kTxPdo:
      return read_pdos(category, strings, image.tx_pdos);
    case CategoryType::kRxPdo:
      return read_pdos(category, strings, image.rx_pdos);
    case CategoryType::kDc:
      return read_dc_modes(category, strings, image.dc_modes);
    default:
      image.other.push_back({category.type, {category.data.begin(), category.data.end()}});
      return {};
  }
}

}  // namespace

Result<Image> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kFixedPart) {
    return fail(ErrorCode::kSii, "slave",
                because("{bytes} bytes are fewer than the {least} of its fixed part", bytes.size(), kFixedPart));
  }
  auto image = read_fixed(bytes);
  const auto categories = split(bytes);
  if (!categories) return tl::unexpected(categories.error());
  StringTable strings;
  for (const auto& category : *categories) {
    if (category.type != static_cast<std::uint16_t>(CategoryType::kStrings)) continue;
    if (auto status = strings.read(category); !status) return tl::unexpected(status.error());
  }
  for (const auto& category : *categories) {
    if (auto status = read_category(category, strings, image); !status) return tl::unexpected(status.error());
  }
  return image;
}

}  // namespace syncline::sii
