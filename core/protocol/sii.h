// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/result.h"

/// Slave information interface, the EEPROM's content (ETG.1000.6, 5.4; ETG.2010).
namespace syncline::sii {

inline constexpr std::uint16_t kVendorIdWord = 0x0008;  // then product code, revision, serial number
inline constexpr std::uint16_t kSizeWord = 0x003E;      // in Kbit, minus 1
inline constexpr std::size_t kSizeStep = 128;           // bytes of a Kbit
inline constexpr std::uint16_t kCategoriesWord = 0x0040;
inline constexpr std::size_t kLongestImage = 128 * 1024;  // bytes; 1 Mbit, the largest EEPROM in use
enum class CategoryType : std::uint16_t {
  kStrings = 10,
  kDataTypes = 20,
  kGeneral = 30,
  kFmmu = 40,
  kSyncM = 41,
  kFmmuExtended = 42,
  kSyncUnit = 43,
  kTxPdo = 50,
  kRxPdo = 51,
  kDc = 60,
  kEnd = 0xFFFF,
};

struct MailboxArea {
  std::uint16_t receive_offset = 0;  // master to slave (SM0)
  std::uint16_t receive_size = 0;
  std::uint16_t send_offset = 0;  // slave to master (SM1)
  std::uint16_t send_size = 0;
  bool operator==(const MailboxArea&) const = default;
};
inline constexpr std::uint16_t kProtocolAoe = 0x01;
inline constexpr std::uint16_t kProtocolEoe = 0x02;
inline constexpr std::uint16_t kProtocolCoe = 0x04;
inline constexpr std::uint16_t kProtocolFoe = 0x08;
inline constexpr std::uint16_t kProtocolSoe = 0x10;
inline constexpr std::uint16_t kProtocolVoe = 0x20;

struct General {
  std::string group, image, order, name;
  std::uint8_t coe_details = 0;  // .0 SDO .1 info .2 PDO assign .3 PDO config .4 upload .5 complete access
  std::uint8_t foe_details = 0;
  std::uint8_t eoe_details = 0;
  std::uint8_t flags = 0;
  std::int16_t ebus_current_ma = 0;
  std::uint16_t physical_ports = 0;
  std::uint16_t physical_memory_address = 0;
  bool operator==(const General&) const = default;
};
struct SyncM {
  std::uint16_t start = 0;
  std::uint16_t length = 0;
  std::uint8_t control = 0;
  std::uint8_t status = 0;
  std::uint8_t enable = 0;  // .0 enable .1 fixed .2 virtual .3 OpOnly
  std::uint8_t type = 0;    // 0 unused 1 mailbox out 2 mailbox in 3 outputs 4 inputs
  bool operator==(const SyncM&) const = default;
};
struct PdoEntry {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::string name;
  std::uint8_t data_type = 0;
  std::uint8_t bit_length = 0;
  std::uint16_t flags = 0;
  bool operator==(const PdoEntry&) const = default;
};
struct Pdo {
  std::uint16_t index = 0;
  std::uint8_t sync_manager = 0xFF;  // 0xFF: not assigned
  std::uint8_t synchronization = 0;
  std::string name;
  std::uint16_t flags = 0;
  std::vector<PdoEntry> entries;
  bool operator==(const Pdo&) const = default;
};
struct DcMode {
  std::uint32_t cycle_time_sync0 = 0;  // ns
  std::uint32_t shift_time_sync0 = 0;
  std::uint32_t shift_time_sync1 = 0;
  std::int16_t cycle_factor_sync1 = 0;
  std::uint16_t assign_activate = 0;
  std::int16_t cycle_factor_sync0 = 0;
  std::string name, description;
  bool operator==(const DcMode&) const = default;
};
/// A category that we do not interpret, kept as it is.
struct RawCategory {
  std::uint16_t type = 0;
  std::vector<std::uint8_t> data;
  bool operator==(const RawCategory&) const = default;
};

struct Image {
  std::uint16_t pdi_control = 0;
  std::uint16_t pdi_configuration = 0;
  std::uint16_t sync_impulse_length = 0;  // 10 ns units
  std::uint16_t pdi_configuration2 = 0;
  std::uint16_t alias = 0;
  std::array<std::uint16_t, 2> reserved{};
  std::uint32_t vendor_id = 0, product_code = 0, revision_no = 0, serial_no = 0;
  MailboxArea bootstrap_mailbox, mailbox;
  std::uint16_t mailbox_protocols = 0;
  std::uint32_t size_bytes = 2048;  // of the EEPROM
  std::optional<General> general;
  std::vector<std::uint8_t> fmmus;  // 0 unused 1 outputs 2 inputs 3 mailbox state
  std::vector<SyncM> sync_managers;
  std::vector<Pdo> tx_pdos, rx_pdos;
  std::vector<DcMode> dc_modes;
  std::vector<RawCategory> other;
  bool checksum_ok = true;  // of the image that was decoded
  bool operator==(const Image&) const = default;
};

/// CRC-8, polynomial 0x07, start 0xFF, over the first 14 bytes.
[[nodiscard]] std::uint8_t checksum(std::span<const std::uint8_t> first_14_bytes);
/// Bytes that the size word says, 128 to 8 Mi. `bytes`: the image's beginning, the size word included.
[[nodiscard]] std::size_t told_size(std::span<const std::uint8_t> bytes);
/// The same where an EEPROM can have it; 2048 where it is none (below the header, above kLongestImage).
[[nodiscard]] std::size_t image_size(std::span<const std::uint8_t> bytes);
/// EEPROM bytes, filled up with 0xFF to size_bytes (grown when the content needs more).
[[nodiscard]] std::vector<std::uint8_t> encode(const Image& image);
/// Never reads outside; a wrong checksum is told in the image, broken categories are an error
/// (ErrorCode::kSii) that names the category and its word offset.
[[nodiscard]] Result<Image> decode(std::span<const std::uint8_t> bytes);

}  // namespace syncline::sii
