// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe.h"

#include <fmt/format.h>

#include <algorithm>

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
  explicit Encoder(Service service) : writer_(bytes_) {
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
                    const std::vector<std::uint8_t>& data) {
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
  Encoder& segment(bool toggle, bool last, const std::vector<std::uint8_t>& data) {
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
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
  ByteWriter writer_;
};

tl::unexpected<Error> malformed(std::string detail) {
  return fail(ErrorCode::kMalformedData, "CoE message", std::move(detail));
}

tl::unexpected<Error> too_short(std::size_t size) { return malformed(fmt::format("only {} bytes", size)); }

ObjectAddress read_object(ByteReader& reader) {
  ObjectAddress object;
  object.index = reader.u16();
  object.sub_index = reader.u8();
  return object;
}

struct Transfer {
  bool expedited = false;
  std::uint32_t complete_size = 0;
  std::vector<std::uint8_t> data;
};

Transfer read_transfer(ByteReader& reader, std::uint8_t command_byte) {
  Transfer transfer;
  transfer.expedited = (command_byte & kExpedited) != 0;
  if (transfer.expedited) {
    // Without the size bit the number of bytes is up to the object; all four are kept then.
    const auto unused = (command_byte & kSizeIndicated) != 0 ? (command_byte >> 2) & 0x03U : 0U;
    const auto bytes = reader.take(kExpeditedMax);
    if (reader.ok()) transfer.data.assign(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(unused));
    transfer.complete_size = static_cast<std::uint32_t>(transfer.data.size());
    return transfer;
  }
  transfer.complete_size = reader.u32();
  const auto bytes = reader.take(std::min<std::size_t>(reader.remaining(), transfer.complete_size));
  transfer.data.assign(bytes.begin(), bytes.end());
  return transfer;
}

std::vector<std::uint8_t> read_segment(ByteReader& reader, std::uint8_t command_byte) {
  std::size_t length = reader.remaining();
  if (length <= kMinSegment) length = std::min(length, kMinSegment - ((command_byte >> 1) & 0x07U));
  const auto bytes = reader.take(length);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::uint8_t> encode_abort(const Abort& abort) {
  // ETG.1000.6 carries an abort of either side in an SDO request.
  return Encoder(Service::kSdoRequest).head(command(kAbort), abort.object).u32(abort.code).take();
}

struct RequestEncoder {
  std::vector<std::uint8_t> operator()(const DownloadRequest& r) const {
    return Encoder(Service::kSdoRequest)
        .transfer(command(kDownload, r.complete_access), r.object, r.expedited, r.complete_size, r.data)
        .take();
  }
  std::vector<std::uint8_t> operator()(const DownloadSegmentRequest& r) const {
    return Encoder(Service::kSdoRequest).segment(r.toggle, r.last, r.data).take();
  }
  std::vector<std::uint8_t> operator()(const UploadRequest& r) const {
    return Encoder(Service::kSdoRequest).head(command(kUpload, r.complete_access), r.object).u32(0).take();
  }
  std::vector<std::uint8_t> operator()(const UploadSegmentRequest& r) const {
    return Encoder(Service::kSdoRequest).command_only(command(kUploadSegment, r.toggle)).take();
  }
  std::vector<std::uint8_t> operator()(const Abort& r) const { return encode_abort(r); }
};

struct ResponseEncoder {
  std::vector<std::uint8_t> operator()(const DownloadResponse& r) const {
    return Encoder(Service::kSdoResponse).head(command(kDownloadDone), r.object).u32(0).take();
  }
  std::vector<std::uint8_t> operator()(const DownloadSegmentResponse& r) const {
    return Encoder(Service::kSdoResponse).command_only(command(kDownloadSegmentDone, r.toggle)).take();
  }
  std::vector<std::uint8_t> operator()(const UploadResponse& r) const {
    return Encoder(Service::kSdoResponse)
        .transfer(command(kUploadDone, r.complete_access), r.object, r.expedited, r.complete_size, r.data)
        .take();
  }
  std::vector<std::uint8_t> operator()(const UploadSegmentResponse& r) const {
    return Encoder(Service::kSdoResponse).segment(r.toggle, r.last, r.data).take();
  }
  std::vector<std::uint8_t> operator()(const Abort& r) const { return encode_abort(r); }
  std::vector<std::uint8_t> operator()(const Emergency& r) const {
    return Encoder(Service::kEmergency).emergency(r).take();
  }
};

Result<Abort> read_abort(ByteReader& reader, std::size_t size) {
  Abort abort;
  abort.object = read_object(reader);
  abort.code = reader.u32();
  if (!reader.ok()) return too_short(size);
  return abort;
}

Result<Response> read_emergency(ByteReader& reader, std::size_t size) {
  Emergency emergency;
  emergency.error_code = reader.u16();
  emergency.error_register = reader.u8();
  const auto data = reader.take(emergency.data.size());
  if (!reader.ok()) return too_short(size);
  std::copy(data.begin(), data.end(), emergency.data.begin());
  return emergency;
}

Result<Request> read_request(ByteReader& reader, std::uint8_t byte) {
  const bool bit4 = (byte & 0x10) != 0;
  switch (byte >> 5) {
    case kDownloadSegment:
      return DownloadSegmentRequest{bit4, (byte & kLastSegment) != 0, read_segment(reader, byte)};
    case kDownload: {
      const auto object = read_object(reader);
      auto transfer = read_transfer(reader, byte);
      return DownloadRequest{object, bit4, transfer.expedited, transfer.complete_size, std::move(transfer.data)};
    }
    case kUpload: {
      const auto object = read_object(reader);
      return UploadRequest{object, bit4};
    }
    case kUploadSegment:
      return UploadSegmentRequest{bit4};
    default:
      return malformed(fmt::format("SDO command 0x{:02X} is not a request", byte));
  }
}

Result<Response> read_response(ByteReader& reader, std::uint8_t byte) {
  const bool bit4 = (byte & 0x10) != 0;
  switch (byte >> 5) {
    case kUploadSegmentDone:
      return UploadSegmentResponse{bit4, (byte & kLastSegment) != 0, read_segment(reader, byte)};
    case kDownloadSegmentDone:
      return DownloadSegmentResponse{bit4};
    case kUploadDone: {
      const auto object = read_object(reader);
      auto transfer = read_transfer(reader, byte);
      return UploadResponse{object, bit4, transfer.expedited, transfer.complete_size, std::move(transfer.data)};
    }
    case kDownloadDone:
      return DownloadResponse{read_object(reader)};
    default:
      return malformed(fmt::format("SDO command 0x{:02X} is not a response", byte));
  }
}

}  // namespace

std::vector<std::uint8_t> encode(const Request& request) { return std::visit(RequestEncoder{}, request); }
std::vector<std::uint8_t> encode(const Response& response) { return std::visit(ResponseEncoder{}, response); }

Result<Service> service_of(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const auto service = reader.u16() >> 12;
  if (!reader.ok()) return too_short(data.size());
  if (service < 1 || service > 8) return malformed(fmt::format("service {} does not exist", service));
  return static_cast<Service>(service);
}

Result<Request> decode_request(std::span<const std::uint8_t> data) {
  const auto service = service_of(data);
  if (!service) return tl::unexpected(service.error());
  if (*service != Service::kSdoRequest) return malformed("it is not an SDO request");
  ByteReader reader(data);
  reader.skip(2);
  const auto byte = reader.u8();
  if (!reader.ok()) return too_short(data.size());
  if (byte >> 5 == kAbort) return read_abort(reader, data.size()).map([](const Abort& a) { return Request(a); });
  auto request = read_request(reader, byte);
  if (request && !reader.ok()) return too_short(data.size());
  return request;
}

Result<Response> decode_response(std::span<const std::uint8_t> data) {
  const auto service = service_of(data);
  if (!service) return tl::unexpected(service.error());
  ByteReader reader(data);
  reader.skip(2);
  if (*service == Service::kEmergency) return read_emergency(reader, data.size());
  const auto byte = reader.u8();
  if (!reader.ok()) return too_short(data.size());
  const bool sdo = *service == Service::kSdoResponse || *service == Service::kSdoRequest;
  if (sdo && byte >> 5 == kAbort) {
    return read_abort(reader, data.size()).map([](const Abort& a) { return Response(a); });
  }
  if (*service != Service::kSdoResponse) return malformed("it is not an SDO response");
  auto response = read_response(reader, byte);
  if (response && !reader.ok()) return too_short(data.size());
  return response;
}

}  // namespace syncline::coe
