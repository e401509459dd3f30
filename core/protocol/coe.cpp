// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe.h"

#include <fmt/format.h>

#include <algorithm>

#include "reasons/brief_reason.h"
#include "support/brief_error.h"
#include "support/byte_order.h"

namespace syncline::coe {
namespace {

// Command byte: bits 7..5 specifier, 4 complete access or toggle, the rest by service.
constexpr std::uint8_t kSizeIndicated = 0x01;
constexpr std::uint8_t kExpedited = 0x02;
constexpr std::uint8_t kToggle = 0x10;
constexpr std::uint8_t kLastSegment = 0x01;
constexpr std::size_t kExpeditedMax = 4;
// A segment shorter than this is padded to it and says in its command byte how much is padding.
constexpr std::size_t kMinSegment = 7;

enum RequestSpecifier : std::uint8_t {
  kDownloadSegment = 0,
  kDownload = 1,
  kUpload = 2,
  kUploadSegment = 3,
  kAbort = 4,
};
enum ResponseSpecifier : std::uint8_t {
  kUploadSegmentDone = 0,
  kDownloadSegmentDone = 1,
  kUploadDone = 2,
  kDownloadDone = 3,
};

constexpr std::uint8_t command(std::uint8_t specifier, bool bit4 = false) {
  return static_cast<std::uint8_t>((specifier << 5) | (bit4 ? 0x10 : 0));
}

class Encoder {
 public:
  Encoder(std::vector<std::uint8_t>& out, Service service) : writer_(out) {
    writer_.u16(static_cast<std::uint16_t>(static_cast<unsigned>(service) << 12));
  }
  Encoder& head(std::uint8_t command_byte, const ObjectAddress& object) {
    writer_.u8(command_byte).u16(object.index).u8(object.sub_index);
    return *this;
  }
  Encoder& u32(std::uint32_t value) {
    writer_.u32(value);
    return *this;
  }
  /// The initiate services with data: expedited where wanted and possible, else size and data.
  Encoder& transfer(std::uint8_t command_byte, const ObjectAddress& object, bool expedited, std::uint32_t complete_size,
                    std::span<const std::uint8_t> data) {
    if (expedited && !data.empty() && data.size() <= kExpeditedMax) {
      const auto unused = static_cast<unsigned>(kExpeditedMax - data.size());
      head(static_cast<std::uint8_t>(command_byte | kSizeIndicated | kExpedited | (unused << 2)), object);
      writer_.bytes(data).zeros(unused);
    } else {
      head(static_cast<std::uint8_t>(command_byte | kSizeIndicated), object);
      writer_.u32(std::max(complete_size, static_cast<std::uint32_t>(data.size()))).bytes(data);
    }
    return *this;
  }
  Encoder& segment(bool toggle, bool last, std::span<const std::uint8_t> data) {
    const auto unused = static_cast<unsigned>(data.size() < kMinSegment ? kMinSegment - data.size() : 0);
    writer_.u8(static_cast<std::uint8_t>((toggle ? kToggle : 0) | (unused << 1) | (last ? kLastSegment : 0)));
    writer_.bytes(data).zeros(unused);
    return *this;
  }
  Encoder& command_only(std::uint8_t command_byte) {
    writer_.u8(command_byte).zeros(7);
    return *this;
  }
  Encoder& emergency(const Emergency& emergency) {
    writer_.u16(emergency.error_code).u8(emergency.error_register).bytes(emergency.data);
    return *this;
  }

 private:
  ByteWriter writer_;
};

tl::unexpected<BriefError> malformed(BriefReason why) {
  return tl::unexpected(BriefError{.code = ErrorCode::kMalformedData, .why = why});
}
tl::unexpected<BriefError> too_short(std::size_t size) { return malformed(brief("only {bytes} bytes", size)); }
tl::unexpected<Error> in_words(const BriefError& error) { return fail(error.about("CoE message")); }

ObjectAddress read_object(ByteReader& reader) {
  ObjectAddress object;
  object.index = reader.u16();
  object.sub_index = reader.u8();
  return object;
}

struct Transfer {
  bool expedited = false;
  std::uint32_t complete_size = 0;
  std::span<const std::uint8_t> data;
};

Transfer read_transfer(ByteReader& reader, std::uint8_t command_byte) {
  Transfer transfer;
  transfer.expedited = (command_byte & kExpedited) != 0;
  if (transfer.expedited) {
    // Without the size bit the number of bytes is up to the object; all four are kept then.
    const auto unused = (command_byte & kSizeIndicated) != 0 ? (command_byte >> 2) & 0x03U : 0U;
    const auto bytes = reader.take(kExpeditedMax);
    if (reader.ok()) transfer.data = bytes.first(kExpeditedMax - unused);
    transfer.complete_size = static_cast<std::uint32_t>(transfer.data.size());
    return transfer;
  }
  transfer.complete_size = reader.u32();
  transfer.data = reader.take(std::min<std::size_t>(reader.remaining(), transfer.complete_size));
  return transfer;
}

std::span<const std::uint8_t> read_segment(ByteReader& reader, std::uint8_t command_byte) {
  std::size_t length = reader.remaining();
  if (length <= kMinSegment) length = std::min(length, kMinSegment - ((command_byte >> 1) & 0x07U));
  return reader.take(length);
}

std::vector<std::uint8_t> copy_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

struct RequestEncoder {
  std::vector<std::uint8_t>& out;

  void operator()(const DownloadRequest& r) const {
    append_download(out, r.object, r.complete_access, r.expedited, r.complete_size, r.data);
  }
  void operator()(const DownloadSegmentRequest& r) const { append_download_segment(out, r.toggle, r.last, r.data); }
  void operator()(const UploadRequest& r) const { append(out, r); }
  void operator()(const UploadSegmentRequest& r) const { append(out, r); }
  void operator()(const Abort& r) const { append(out, r); }
};

struct ResponseEncoder {
  std::vector<std::uint8_t>& out;

  void operator()(const DownloadResponse& r) const {
    Encoder(out, Service::kSdoResponse).head(command(kDownloadDone), r.object).u32(0);
  }
  void operator()(const DownloadSegmentResponse& r) const {
    Encoder(out, Service::kSdoResponse).command_only(command(kDownloadSegmentDone, r.toggle));
  }
  void operator()(const UploadResponse& r) const {
    Encoder(out, Service::kSdoResponse)
        .transfer(command(kUploadDone, r.complete_access), r.object, r.expedited, r.complete_size, r.data);
  }
  void operator()(const UploadSegmentResponse& r) const {
    Encoder(out, Service::kSdoResponse).segment(r.toggle, r.last, r.data);
  }
  void operator()(const Abort& r) const { append(out, r); }
  void operator()(const Emergency& r) const { Encoder(out, Service::kEmergency).emergency(r); }
};

tl::expected<Abort, BriefError> read_abort(ByteReader& reader, std::size_t size) {
  Abort abort;
  abort.object = read_object(reader);
  abort.code = reader.u32();
  if (!reader.ok()) return too_short(size);
  return abort;
}

tl::expected<ResponseView, BriefError> view_abort(ByteReader& reader, std::size_t size) {
  const auto abort = read_abort(reader, size);
  if (!abort) return tl::unexpected(abort.error());
  ResponseView view{.kind = ResponseView::Kind::kAbort, .object = abort->object};
  view.abort_code = abort->code;
  return view;
}

tl::expected<ResponseView, BriefError> view_emergency(ByteReader& reader, std::size_t size) {
  ResponseView view{.kind = ResponseView::Kind::kEmergency};
  view.emergency.error_code = reader.u16();
  view.emergency.error_register = reader.u8();
  const auto data = reader.take(view.emergency.data.size());
  if (!reader.ok()) return too_short(size);
  std::ranges::copy(data, view.emergency.data.begin());
  return view;
}

Result<Request> read_request(ByteReader& reader, std::uint8_t byte) {
  const bool bit4 = (byte & 0x10) != 0;
  switch (byte >> 5) {
    case kDownloadSegment:
      return DownloadSegmentRequest{bit4, (byte & kLastSegment) != 0, copy_of(read_segment(reader, byte))};
    case kDownload: {
      const auto object = read_object(reader);
      const auto transfer = read_transfer(reader, byte);
      return DownloadRequest{object, bit4, transfer.expedited, transfer.complete_size, copy_of(transfer.data)};
    }
    case kUpload: {
      const auto object = read_object(reader);
      return UploadRequest{object, bit4};
    }
    case kUploadSegment:
      return UploadSegmentRequest{bit4};
    default:
      return in_words(malformed(brief("SDO command 0x{command} is not a request", hex_number(byte, 2))).value());
  }
}

tl::expected<ResponseView, BriefError> view_answer(ByteReader& reader, std::uint8_t byte) {
  using Kind = ResponseView::Kind;
  ResponseView view;
  view.toggle = view.complete_access = (byte & 0x10) != 0;
  switch (byte >> 5) {
    case kUploadSegmentDone:
      view.kind = Kind::kUploadSegment;
      view.last = (byte & kLastSegment) != 0;
      view.data = read_segment(reader, byte);
      return view;
    case kDownloadSegmentDone:
      view.kind = Kind::kDownloadSegment;
      return view;
    case kUploadDone: {
      view.kind = Kind::kUpload;
      view.object = read_object(reader);
      const auto transfer = read_transfer(reader, byte);
      view.expedited = transfer.expedited;
      view.complete_size = transfer.complete_size;
      view.data = transfer.data;
      return view;
    }
    case kDownloadDone:
      view.kind = Kind::kDownload;
      view.object = read_object(reader);
      return view;
    default:
      return malformed(brief("SDO command 0x{command} is not a response", hex_number(byte, 2)));
  }
}

Response to_response(const ResponseView& view) {
  using Kind = ResponseView::Kind;
  switch (view.kind) {
    case Kind::kDownload:
      return DownloadResponse{view.object};
    case Kind::kDownloadSegment:
      return DownloadSegmentResponse{view.toggle};
    case Kind::kUpload:
      return UploadResponse{view.object, view.complete_access, view.expedited, view.complete_size, copy_of(view.data)};
    case Kind::kUploadSegment:
      return UploadSegmentResponse{view.toggle, view.last, copy_of(view.data)};
    case Kind::kEmergency:
      return view.emergency;
    case Kind::kAbort:
      break;
  }
  return Abort{view.object, view.abort_code};
}

}  // namespace

void append_download(std::vector<std::uint8_t>& out, ObjectAddress object, bool complete_access, bool expedited,
                     std::uint32_t complete_size, std::span<const std::uint8_t> data) {
  Encoder(out, Service::kSdoRequest)
      .transfer(command(kDownload, complete_access), object, expedited, complete_size, data);
}

void append_download_segment(std::vector<std::uint8_t>& out, bool toggle, bool last,
                             std::span<const std::uint8_t> data) {
  Encoder(out, Service::kSdoRequest).segment(toggle, last, data);
}

void append(std::vector<std::uint8_t>& out, const UploadRequest& request) {
  Encoder(out, Service::kSdoRequest).head(command(kUpload, request.complete_access), request.object).u32(0);
}

void append(std::vector<std::uint8_t>& out, const UploadSegmentRequest& request) {
  Encoder(out, Service::kSdoRequest).command_only(command(kUploadSegment, request.toggle));
}

void append(std::vector<std::uint8_t>& out, const Abort& abort) {
  // ETG.1000.6 carries an abort of either side in an SDO request.
  Encoder(out, Service::kSdoRequest).head(command(kAbort), abort.object).u32(abort.code);
}

std::vector<std::uint8_t> encode(const Request& request) {
  std::vector<std::uint8_t> bytes;
  std::visit(RequestEncoder{bytes}, request);
  return bytes;
}

std::vector<std::uint8_t> encode(const Response& response) {
  std::vector<std::uint8_t> bytes;
  std::visit(ResponseEncoder{bytes}, response);
  return bytes;
}

tl::expected<Service, BriefError> view_service(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const auto service = reader.u16() >> 12;
  if (!reader.ok()) return too_short(data.size());
  if (service < 1 || service > 8) return malformed(brief("service {number} does not exist", service));
  return static_cast<Service>(service);
}

Result<Service> service_of(std::span<const std::uint8_t> data) {
  const auto service = view_service(data);
  if (!service) return in_words(service.error());
  return *service;
}

Result<Request> decode_request(std::span<const std::uint8_t> data) {
  const auto service = service_of(data);
  if (!service) return tl::unexpected(service.error());
  if (*service != Service::kSdoRequest) return in_words(malformed(brief("it is not an SDO request")).value());
  ByteReader reader(data);
  reader.skip(2);
  const auto byte = reader.u8();
  if (!reader.ok()) return in_words(too_short(data.size()).value());
  if (byte >> 5 == kAbort) {
    const auto abort = read_abort(reader, data.size());
    if (!abort) return in_words(abort.error());
    return *abort;
  }
  auto request = read_request(reader, byte);
  if (request && !reader.ok()) return in_words(too_short(data.size()).value());
  return request;
}

tl::expected<ResponseView, BriefError> view_response(std::span<const std::uint8_t> data) {
  const auto service = view_service(data);
  if (!service) return tl::unexpected(service.error());
  ByteReader reader(data);
  reader.skip(2);
  if (*service == Service::kEmergency) return view_emergency(reader, data.size());
  const auto byte = reader.u8();
  if (!reader.ok()) return too_short(data.size());
  const bool sdo = *service == Service::kSdoResponse || *service == Service::kSdoRequest;
  if (sdo && byte >> 5 == kAbort) return view_abort(reader, data.size());
  if (*service != Service::kSdoResponse) return malformed(brief("it is not an SDO response"));
  auto response = view_answer(reader, byte);
  if (response && !reader.ok()) return too_short(data.size());
  return response;
}

Result<Response> decode_response(std::span<const std::uint8_t> data) {
  const auto view = view_response(data);
  if (!view) return in_words(view.error());
  return to_response(*view);
}

}  // namespace syncline::coe
