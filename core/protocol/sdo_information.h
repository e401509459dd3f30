// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "support/result.h"

namespace syncline {
struct BriefError;
}  // namespace syncline

/// SDO information services of CoE (ETG.1000.6, 5.6.3): a device tells which objects it has and what they are.
/// Both directions, for the master's client and the simulated devices' server.
namespace syncline::coe {

enum class ObjectListType : std::uint16_t {
  kLengths = 0,  // how many objects each of the other lists has
  kAll = 1,
  kRxPdo = 2,
  kTxPdo = 3,
  kStored = 4,  // to be kept when a device is replaced
  kStartup = 5,
};
enum class ObjectCode : std::uint8_t {
  kNull = 0,
  kDomain = 2,
  kDefType = 5,
  kDefStruct = 6,
  kVariable = 7,
  kArray = 8,
  kRecord = 9
};

/// Bits of an entry's access word (ETG.1000.6, table 48): reading and writing in PREOP, SAFEOP, OP, and what
/// it may be mapped into.
namespace access {
inline constexpr std::uint16_t kReadPreop = 0x01, kReadSafeop = 0x02, kReadOp = 0x04;
inline constexpr std::uint16_t kWritePreop = 0x08, kWriteSafeop = 0x10, kWriteOp = 0x20;
inline constexpr std::uint16_t kRead = 0x07, kWrite = 0x38;
inline constexpr std::uint16_t kRxPdo = 0x40, kTxPdo = 0x80, kBackup = 0x100, kSettings = 0x200;
}  // namespace access

/// Bits of the value info of an entry description.
namespace value_info {
inline constexpr std::uint8_t kUnitType = 0x08, kDefault = 0x10, kMinimum = 0x20, kMaximum = 0x40;
}  // namespace value_info

// Requests
struct ObjectListRequest {
  ObjectListType list = ObjectListType::kAll;
  bool operator==(const ObjectListRequest&) const = default;
};
struct ObjectDescriptionRequest {
  std::uint16_t index = 0;
  bool operator==(const ObjectDescriptionRequest&) const = default;
};
struct EntryDescriptionRequest {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t value_info = 0;  // what is wanted besides type, size, access and name
  bool operator==(const EntryDescriptionRequest&) const = default;
};
using InformationRequest = std::variant<ObjectListRequest, ObjectDescriptionRequest, EntryDescriptionRequest>;

// Responses
struct ObjectList {
  ObjectListType list = ObjectListType::kAll;
  std::vector<std::uint16_t> indices;  // five numbers of objects for kLengths
  bool operator==(const ObjectList&) const = default;
};
struct ObjectDescription {
  std::uint16_t index = 0;
  std::uint16_t data_type = 0;
  std::uint8_t max_sub_index = 0;
  ObjectCode code = ObjectCode::kVariable;
  std::string name;
  bool operator==(const ObjectDescription&) const = default;
};
struct EntryDescription {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t value_info = 0;  // which of the next four are there
  std::uint16_t data_type = 0;
  std::uint16_t bit_length = 0;
  std::uint16_t access = 0;
  std::uint16_t unit_type = 0;
  std::vector<std::uint8_t> default_value, minimum, maximum;  // as long as the entry, rounded up to bytes
  std::string name;
  bool operator==(const EntryDescription&) const = default;
};
struct InformationError {
  std::uint32_t abort_code = 0;
  bool operator==(const InformationError&) const = default;
};
using InformationResponse = std::variant<ObjectList, ObjectDescription, EntryDescription, InformationError>;

/// One mailbox's part of a response.
struct InformationFragment {
  std::uint8_t opcode = 0;
  std::uint16_t fragments_left = 0;
  bool incomplete = false;         // says the device itself; more follows
  std::vector<std::uint8_t> data;  // of the service, behind the SDO information header
  bool operator==(const InformationFragment&) const = default;
};

/// The same as it lies in the mailbox, for a client that must not allocate.
struct InformationFragmentView {
  std::uint8_t opcode = 0;
  std::uint16_t fragments_left = 0;
  bool incomplete = false;
  std::span<const std::uint8_t> data;
};

/// Bytes behind the mailbox header.
[[nodiscard]] std::vector<std::uint8_t> encode(const InformationRequest& request);
/// The same behind what `out` holds; allocates only where `out` has no room.
void append(std::vector<std::uint8_t>& out, const InformationRequest& request);
[[nodiscard]] Result<InformationRequest> decode_information_request(std::span<const std::uint8_t> data);

/// The response in as many messages as a mailbox of `mailbox_size` bytes needs, each without mailbox header.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> encode(const InformationResponse& response,
                                                            std::size_t mailbox_size);
/// One message. kMalformedData.
[[nodiscard]] Result<InformationFragment> decode_information_fragment(std::span<const std::uint8_t> data);
[[nodiscard]] tl::expected<InformationFragmentView, BriefError> view_information_fragment(
    std::span<const std::uint8_t> data);
/// The data of all fragments in order, put together. kMalformedData.
[[nodiscard]] Result<InformationResponse> decode_information_response(std::uint8_t opcode,
                                                                      std::span<const std::uint8_t> data);

/// True when `opcode` is the answer to `request` or an error.
[[nodiscard]] bool answers(std::uint8_t opcode, const InformationRequest& request);
/// Of the answer to `request` that is no error.
[[nodiscard]] std::uint8_t response_opcode(const InformationRequest& request);
/// The data of all fragments of such an answer are about the object or entry that was asked for; of an error and of a
/// list: always.
[[nodiscard]] bool concerns(std::uint8_t opcode, std::span<const std::uint8_t> data, const InformationRequest& request);
/// Of an error's data; nothing when the answer is none.
[[nodiscard]] std::optional<std::uint32_t> information_abort_code(std::uint8_t opcode,
                                                                  std::span<const std::uint8_t> data);

}  // namespace syncline::coe
