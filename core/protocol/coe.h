// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/emergency.h"
#include "support/result.h"

namespace syncline {
struct BriefError;
}  // namespace syncline

/// CANopen over EtherCAT (ETG.1000.6, 5.6): the bytes behind the mailbox header, both directions,
/// for the master's client and the simulated devices' server.
namespace syncline::coe {

enum class Service : std::uint8_t {
  kEmergency = 1,
  kSdoRequest = 2,
  kSdoResponse = 3,
  kTxPdo = 4,
  kRxPdo = 5,
  kTxPdoRemote = 6,
  kRxPdoRemote = 7,
  kSdoInformation = 8,
};

struct ObjectAddress {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  bool operator==(const ObjectAddress&) const = default;
};

// Requests (service 2)
/// Download; expedited when data has 1..4 bytes and `expedited`, else normal with the complete size
/// and as much data as is given here (the rest follows in segments).
struct DownloadRequest {
  ObjectAddress object;
  bool complete_access = false;
  bool expedited = true;
  std::uint32_t complete_size = 0;  // bytes; equals data.size() when not segmented
  std::vector<std::uint8_t> data;
  bool operator==(const DownloadRequest&) const = default;
};
struct DownloadSegmentRequest {
  bool toggle = false;
  bool last = false;
  std::vector<std::uint8_t> data;
  bool operator==(const DownloadSegmentRequest&) const = default;
};
struct UploadRequest {
  ObjectAddress object;
  bool complete_access = false;
  bool operator==(const UploadRequest&) const = default;
};
struct UploadSegmentRequest {
  bool toggle = false;
  bool operator==(const UploadSegmentRequest&) const = default;
};
/// Either direction.
struct Abort {
  ObjectAddress object;
  std::uint32_t code = 0;
  bool operator==(const Abort&) const = default;
};

// Responses (service 3)
struct DownloadResponse {
  ObjectAddress object;
  bool operator==(const DownloadResponse&) const = default;
};
struct DownloadSegmentResponse {
  bool toggle = false;
  bool operator==(const DownloadSegmentResponse&) const = default;
};
struct UploadResponse {
  ObjectAddress object;
  bool complete_access = false;
  bool expedited = true;
  std::uint32_t complete_size = 0;
  std::vector<std::uint8_t> data;
  bool operator==(const UploadResponse&) const = default;
};
struct UploadSegmentResponse {
  bool toggle = false;
  bool last = false;
  std::vector<std::uint8_t> data;
  bool operator==(const UploadSegmentResponse&) const = default;
};

using Request = std::variant<DownloadRequest, DownloadSegmentRequest, UploadRequest, UploadSegmentRequest, Abort>;
using Response =
    std::variant<DownloadResponse, DownloadSegmentResponse, UploadResponse, UploadSegmentResponse, Abort, Emergency>;

/// Bytes behind the mailbox header (CoE header, SDO header, data).
[[nodiscard]] std::vector<std::uint8_t> encode(const Request& request);
[[nodiscard]] std::vector<std::uint8_t> encode(const Response& response);
[[nodiscard]] Result<Request> decode_request(std::span<const std::uint8_t> data);
[[nodiscard]] Result<Response> decode_response(std::span<const std::uint8_t> data);
/// The same behind what `out` holds; allocates only where `out` has no room.
void append_download(std::vector<std::uint8_t>& out, ObjectAddress object, bool complete_access, bool expedited,
                     std::uint32_t complete_size, std::span<const std::uint8_t> data);
void append_download_segment(std::vector<std::uint8_t>& out, bool toggle, bool last,
                             std::span<const std::uint8_t> data);
void append(std::vector<std::uint8_t>& out, const UploadRequest& request);
void append(std::vector<std::uint8_t>& out, const UploadSegmentRequest& request);
void append(std::vector<std::uint8_t>& out, const Abort& abort);

/// A response as it lies in the mailbox, for a client that must not allocate.
struct ResponseView {
  enum class Kind : std::uint8_t { kDownload, kDownloadSegment, kUpload, kUploadSegment, kAbort, kEmergency };
  Kind kind = Kind::kAbort;
  ObjectAddress object{};             // of kDownload, kUpload, kAbort
  bool complete_access = false;       // kUpload
  bool expedited = false;             // kUpload
  bool toggle = false, last = false;  // of segments
  std::uint32_t complete_size = 0;    // kUpload, bytes
  std::uint32_t abort_code = 0;
  std::span<const std::uint8_t> data{};  // kUpload, kUploadSegment
  Emergency emergency{};
};
/// kMalformedData.
[[nodiscard]] tl::expected<ResponseView, BriefError> view_response(std::span<const std::uint8_t> data);
[[nodiscard]] tl::expected<Service, BriefError> view_service(std::span<const std::uint8_t> data);
[[nodiscard]] Result<Service> service_of(std::span<const std::uint8_t> data);

/// Data bytes that the first (normal) message and each following segment can carry in a mailbox of
/// `mailbox_size` bytes.
[[nodiscard]] constexpr std::size_t first_message_capacity(std::size_t mailbox_size) {
  return mailbox_size > 16 ? mailbox_size - 16 : 0;
}
[[nodiscard]] constexpr std::size_t segment_capacity(std::size_t mailbox_size) {
  return mailbox_size > 9 ? mailbox_size - 9 : 0;
}

[[nodiscard]] std::string_view abort_code_text(std::uint32_t code);

}  // namespace syncline::coe
