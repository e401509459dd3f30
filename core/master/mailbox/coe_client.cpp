// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/coe_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

namespace syncline {
namespace {

constexpr std::size_t kExpeditedMax = 4;
constexpr std::uint32_t kToggleError = 0x05030000, kGeneralError = 0x08000000, kLengthError = 0x06070010,
                        kMemoryError = 0x05040005;
/// Stale answers in front of the one that was asked for.
constexpr int kMostStale = 16;

/// The object of a response; segments carry none.
template <class Response>
constexpr bool kNamesObject = requires(const Response& r) {
  r.object;
};

}  // namespace

std::string CoeClient::subject(coe::ObjectAddress object) const {
  return fmt::format("{}, object 0x{:04X}:{:02X}", mailbox_.port().name, object.index, object.sub_index);
}

/// Ends the transfer on the slave's side too, so that it does not wait for its next part.
tl::unexpected<Error> CoeClient::refuse(coe::ObjectAddress object, std::uint32_t abort_code, std::string why) {
  (void)mailbox_.tell(MailboxType::kCoe, coe::encode(coe::Request(coe::Abort{object, abort_code})));
  return fail(ErrorCode::kMailboxProtocol, subject(object), std::move(why));
}

template <class Expected>
Result<Expected> CoeClient::ask_for(const coe::Request& request, coe::ObjectAddress object) {
  auto bytes = mailbox_.ask(MailboxType::kCoe, coe::encode(request));
  for (int stale = 0; bytes; ++stale) {
    auto response = coe::decode_response(*bytes);
    if (!response) return fail(ErrorCode::kMailboxProtocol, subject(object), response.error().detail);
    if (const auto* abort = std::get_if<coe::Abort>(&*response)) {
      if (abort->object == object || abort->object.index == 0) {
        Error error{ErrorCode::kSdoAbort, subject(object)};
        error.received = abort->code;
        return fail(std::move(error));
      }
    } else if (auto* expected = std::get_if<Expected>(&*response)) {
      if constexpr (kNamesObject<Expected>) {
        if (expected->object == object) return std::move(*expected);
      } else {
        return std::move(*expected);
      }
    } else if (!std::holds_alternative<coe::UploadResponse>(*response) &&
               !std::holds_alternative<coe::DownloadResponse>(*response)) {
      return refuse(object, kGeneralError, "the answer belongs to another request");
    }
    // The late answer to a request that was given up: the right one is still to come.
    if (stale == kMostStale) return refuse(object, kGeneralError, "only answers to other requests come");
    bytes = mailbox_.receive_instead(MailboxType::kCoe);
  }
  return tl::unexpected(bytes.error());
}

Status CoeClient::download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access) {
  coe::DownloadRequest request;
  request.object = object;
  request.complete_access = complete_access;
  request.expedited = !complete_access && !data.empty() && data.size() <= kExpeditedMax;
  request.complete_size = static_cast<std::uint32_t>(data.size());
  const auto first = std::min(data.size(), coe::first_message_capacity(mailbox_.port().send.length));
  request.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(first));
  if (auto response = ask_for<coe::DownloadResponse>(request, object); !response) {
    return tl::unexpected(response.error());
  }
  return download_segments(object, data.subspan(first));
}

Status CoeClient::download_segments(coe::ObjectAddress object, std::span<const std::uint8_t> rest) {
  for (bool toggle = false; !rest.empty(); toggle = !toggle) {
    const auto size = std::min(rest.size(), coe::segment_capacity(mailbox_.port().send.length));
    if (size == 0) return refuse(object, kGeneralError, "the mailbox holds no segment");
    coe::DownloadSegmentRequest request{toggle, size == rest.size(), {}};
    request.data.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
    const auto response = ask_for<coe::DownloadSegmentResponse>(request, object);
    if (!response) return tl::unexpected(response.error());
    if (response->toggle != toggle) return refuse(object, kToggleError, "the toggle bit did not alternate");
    rest = rest.subspan(size);
  }
  return {};
}

Result<std::vector<std::uint8_t>> CoeClient::upload(coe::ObjectAddress object, bool complete_access) {
  auto first = ask_for<coe::UploadResponse>(coe::UploadRequest{object, complete_access}, object);
  if (!first) return tl::unexpected(first.error());
  auto data = std::move(first->data);
  if (first->expedited || data.size() == first->complete_size) return data;
  if (first->complete_size > kLargestObject) {
    return refuse(object, kMemoryError, fmt::format("the slave announces {} bytes", first->complete_size));
  }
  if (auto status = upload_segments(object, first->complete_size, data); !status) return tl::unexpected(status.error());
  return data;
}

/// Every segment brings at least a byte and none more than was announced, so that a slave cannot keep it up for ever.
Status CoeClient::upload_segments(coe::ObjectAddress object, std::uint32_t complete_size,
                                  std::vector<std::uint8_t>& data) {
  for (bool toggle = false;; toggle = !toggle) {
    const auto segment = ask_for<coe::UploadSegmentResponse>(coe::UploadSegmentRequest{toggle}, object);
    if (!segment) return tl::unexpected(segment.error());
    if (segment->toggle != toggle) return refuse(object, kToggleError, "the toggle bit did not alternate");
    data.insert(data.end(), segment->data.begin(), segment->data.end());
    if (data.size() > complete_size) {
      return refuse(object, kLengthError, fmt::format("more than the {} bytes that were announced", complete_size));
    }
    if (segment->last) break;
    if (segment->data.empty()) return refuse(object, kGeneralError, "an empty segment that is not the last");
  }
  if (data.size() == complete_size) return {};
  return fail(ErrorCode::kMailboxProtocol, subject(object),
              fmt::format("{} bytes where {} were announced", data.size(), complete_size));
}

}  // namespace syncline
