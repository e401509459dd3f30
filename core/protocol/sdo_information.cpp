// SPDX-License-Identifier: Apache-2.0
#include "protocol/sdo_information.h"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/coe.h"
#include "protocol/mailbox.h"
#include "reasons/because.h"
#include "reasons/brief_reason.h"
#include "support/brief_error.h"
#include "support/byte_order.h"
#include "support/text_bytes.h"

namespace syncline::coe {
namespace {

enum Opcode : std::uint8_t {
  kListRequest = 1,
  kListResponse = 2,
  kObjectRequest = 3,
  kObjectResponse = 4,
  kEntryRequest = 5,
  kEntryResponse = 6,
  kError = 7,
};
constexpr std::uint8_t kOpcodeMask = 0x7F;
constexpr std::uint8_t kIncomplete = 0x80;
constexpr std::size_t kHeaderSize = 6;  // CoE header and SDO information header

tl::unexpected<Error> malformed_information(Reason detail) {
  return fail(ErrorCode::kMalformedData, "SDO information", std::move(detail));
}

void write_header(ByteWriter& out, std::uint8_t opcode, bool incomplete, std::uint16_t fragments_left) {
  out.u16(static_cast<std::uint16_t>(static_cast<unsigned>(Service::kSdoInformation) << 12));
  out.u8(static_cast<std::uint8_t>(opcode | (incomplete ? kIncomplete : 0))).u8(0).u16(fragments_left);
}

std::string read_text(ByteReader& reader) {
  const auto bytes = reader.take(reader.remaining());
  // Some devices end the name with a zero, the specification does not.
  const auto end = std::find(bytes.begin(), bytes.end(), std::uint8_t{0});
  return {bytes.begin(), end};
}

struct ResponseWriter {
  ByteWriter& out;

  std::uint8_t operator()(const ObjectList& r) const {
    out.u16(static_cast<std::uint16_t>(r.list));
    for (const auto index : r.indices) out.u16(index);
    return kListResponse;
  }
  std::uint8_t operator()(const ObjectDescription& r) const {
    out.u16(r.index).u16(r.data_type).u8(r.max_sub_index).u8(static_cast<std::uint8_t>(r.code)).bytes(bytes_of(r.name));
    return kObjectResponse;
  }
  std::uint8_t operator()(const EntryDescription& r) const {
    out.u16(r.index).u8(r.sub_index).u8(r.value_info).u16(r.data_type).u16(r.bit_length).u16(r.access);
    if ((r.value_info & value_info::kUnitType) != 0) out.u16(r.unit_type);
    if ((r.value_info & value_info::kDefault) != 0) out.bytes(r.default_value);
    if ((r.value_info & value_info::kMinimum) != 0) out.bytes(r.minimum);
    if ((r.value_info & value_info::kMaximum) != 0) out.bytes(r.maximum);
    out.bytes(bytes_of(r.name));
    return kEntryResponse;
  }
  std::uint8_t operator()(const InformationError& r) const {
    out.u32(r.abort_code);
    return kError;
  }
};

struct RequestWriter {
  ByteWriter& out;

  void operator()(const ObjectListRequest& r) const {
    write_header(out, kListRequest, false, 0);
    out.u16(static_cast<std::uint16_t>(r.list));
  }
  void operator()(const ObjectDescriptionRequest& r) const {
    write_header(out, kObjectRequest, false, 0);
    out.u16(r.index);
  }
  void operator()(const EntryDescriptionRequest& r) const {
    write_header(out, kEntryRequest, false, 0);
    out.u16(r.index).u8(r.sub_index).u8(r.value_info);
  }
};

Result<InformationResponse> read_object_list(ByteReader& reader) {
  ObjectList list;
  list.list = static_cast<ObjectListType>(reader.u16());
  while (reader.ok() && reader.remaining() >= 2) list.indices.push_back(reader.u16());
  if (!reader.ok()) return malformed_information(because("the object list is too short"));
  return list;
}

Result<InformationResponse> read_object_description(ByteReader& reader) {
  ObjectDescription object;
  object.index = reader.u16();
  object.data_type = reader.u16();
  object.max_sub_index = reader.u8();
  object.code = static_cast<ObjectCode>(reader.u8());
  if (!reader.ok()) return malformed_information(because("the object description is too short"));
  object.name = read_text(reader);
  return object;
}

Result<InformationResponse> read_entry(ByteReader& reader) {
  EntryDescription entry;
  entry.index = reader.u16();
  entry.sub_index = reader.u8();
  entry.value_info = reader.u8();
  entry.data_type = reader.u16();
  entry.bit_length = reader.u16();
  entry.access = reader.u16();
  const std::size_t size = (entry.bit_length + 7U) / 8;
  if ((entry.value_info & value_info::kUnitType) != 0) entry.unit_type = reader.u16();
  const auto value = [&](std::uint8_t bit, std::vector<std::uint8_t>& into) {
    if ((entry.value_info & bit) == 0) return;
    const auto bytes = reader.take(size);
    into.assign(bytes.begin(), bytes.end());
  };
  value(value_info::kDefault, entry.default_value);
  value(value_info::kMinimum, entry.minimum);
  value(value_info::kMaximum, entry.maximum);
  if (!reader.ok())
    return malformed_information(because("the description of 0x{index}:{sub} is too short",
                                         fmt::format("{:04X}", entry.index), fmt::format("{:02X}", entry.sub_index)));
  entry.name = read_text(reader);
  return entry;
}

}  // namespace

void append(std::vector<std::uint8_t>& out, const InformationRequest& request) {
  ByteWriter writer(out);
  std::visit(RequestWriter{writer}, request);
}

std::vector<std::uint8_t> encode(const InformationRequest& request) {
  std::vector<std::uint8_t> bytes;
  append(bytes, request);
  return bytes;
}

std::vector<std::vector<std::uint8_t>> encode(const InformationResponse& response, std::size_t mailbox_size) {
  std::vector<std::uint8_t> data;
  ByteWriter writer(data);
  const auto opcode = std::visit(ResponseWriter{writer}, response);
  const std::size_t overhead = MailboxMessage::kHeaderSize + kHeaderSize;
  const std::size_t room = mailbox_size > overhead + 1 ? mailbox_size - overhead : 2;
  const std::size_t count = std::max<std::size_t>(1, (data.size() + room - 1) / room);
  std::vector<std::vector<std::uint8_t>> messages(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto left = count - 1 - i;
    ByteWriter out(messages[i]);
    write_header(out, opcode, left > 0, static_cast<std::uint16_t>(left));
    out.bytes(std::span(data).subspan(i * room, std::min(room, data.size() - i * room)));
  }
  return messages;
}

tl::expected<InformationFragmentView, BriefError> view_information_fragment(std::span<const std::uint8_t> data) {
  const auto bad = [](BriefReason why) {
    return tl::unexpected(BriefError{.code = ErrorCode::kMalformedData, .why = why});
  };
  ByteReader reader(data);
  const auto service = reader.u16() >> 12;
  const auto opcode = reader.u8();
  reader.skip(1);
  InformationFragmentView fragment;
  fragment.fragments_left = reader.u16();
  if (!reader.ok()) return bad(brief("only {bytes} bytes", data.size()));
  if (service != static_cast<unsigned>(Service::kSdoInformation))
    return bad(brief("it is CoE service {number}", service));
  fragment.opcode = opcode & kOpcodeMask;
  fragment.incomplete = (opcode & kIncomplete) != 0;
  fragment.data = reader.take(reader.remaining());
  return fragment;
}

Result<InformationFragment> decode_information_fragment(std::span<const std::uint8_t> data) {
  const auto view = view_information_fragment(data);
  if (!view) return fail(view.error().about("SDO information"));
  return InformationFragment{
      view->opcode, view->fragments_left, view->incomplete, {view->data.begin(), view->data.end()}};
}

bool concerns(std::uint8_t opcode, std::span<const std::uint8_t> data, const InformationRequest& request) {
  ByteReader reader(data);
  const auto index = reader.u16();
  const auto sub_index = reader.remaining() > 0 ? reader.u8() : std::uint8_t{0};
  if (!reader.ok()) return true;  // whoever reads the answer says what is wrong with it
  if (opcode == kObjectResponse) {
    const auto* asked = std::get_if<ObjectDescriptionRequest>(&request);
    return asked != nullptr && asked->index == index;
  }
  if (opcode != kEntryResponse) return true;
  const auto* asked = std::get_if<EntryDescriptionRequest>(&request);
  return asked != nullptr && asked->index == index && asked->sub_index == sub_index;
}

std::optional<std::uint32_t> information_abort_code(std::uint8_t opcode, std::span<const std::uint8_t> data) {
  if (opcode != kError || data.size() < 4) return std::nullopt;
  return load_le<std::uint32_t>(data);
}

Result<InformationRequest> decode_information_request(std::span<const std::uint8_t> data) {
  const auto fragment = decode_information_fragment(data);
  if (!fragment) return tl::unexpected(fragment.error());
  ByteReader reader(fragment->data);
  InformationRequest request;
  switch (fragment->opcode) {
    case kListRequest:
      request = ObjectListRequest{static_cast<ObjectListType>(reader.u16())};
      break;
    case kObjectRequest:
      request = ObjectDescriptionRequest{reader.u16()};
      break;
    case kEntryRequest: {
      EntryDescriptionRequest entry;
      entry.index = reader.u16();
      entry.sub_index = reader.u8();
      entry.value_info = reader.u8();
      request = entry;
      break;
    }
    default:
      return malformed_information(because("opcode {number} is not a request", fragment->opcode));
  }
  if (!reader.ok()) return malformed_information(because("the request is too short"));
  return request;
}

Result<InformationResponse> decode_information_response(std::uint8_t opcode, std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  switch (opcode) {
    case kListResponse:
      return read_object_list(reader);
    case kObjectResponse:
      return read_object_description(reader);
    case kEntryResponse:
      return read_entry(reader);
    case kError: {
      const InformationError error{reader.u32()};
      if (!reader.ok()) return malformed_information(because("the error is too short"));
      return error;
    }
    default:
      return malformed_information(because("opcode {number} is not a response", opcode));
  }
}

std::uint8_t response_opcode(const InformationRequest& request) {
  constexpr std::uint8_t kResponses[] = {kListResponse, kObjectResponse, kEntryResponse};
  return kResponses[request.index()];
}

bool answers(std::uint8_t opcode, const InformationRequest& request) {
  return opcode == kError || opcode == response_opcode(request);
}

}  // namespace syncline::coe
