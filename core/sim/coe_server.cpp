// SPDX-License-Identifier: Apache-2.0
#include "sim/coe_server.h"

#include <algorithm>

namespace syncline::sim {
namespace {

coe::Response abort_with(const coe::ObjectAddress& object, std::uint32_t code) { return coe::Abort{object, code}; }

MailboxMessage mailbox_error(MailboxErrorDetail detail) {
  MailboxMessage message;
  message.type = MailboxType::kError;
  ByteWriter(message.data).u16(1).u16(static_cast<std::uint16_t>(detail));
  return message;
}

}  // namespace

void CoeServer::reset() {
  transfer_.reset();
  last_counter_ = 0;
}

std::optional<MailboxMessage> CoeServer::answer(const MailboxMessage& request, std::size_t mailbox_size, bool in_preop) {
  // The same counter again: the master repeats a message whose answer it has not seen.
  if (request.counter != 0 && request.counter == last_counter_) return std::nullopt;
  last_counter_ = request.counter;
  mailbox_size_ = mailbox_size;
  in_preop_ = in_preop;

  MailboxMessage reply;
  if (request.type != MailboxType::kCoe) {
    reply = mailbox_error(MailboxErrorDetail::kUnsupportedProtocol);
  } else if (const auto service = coe::service_of(request.data); !service) {
    reply = mailbox_error(MailboxErrorDetail::kSizeTooShort);
  } else if (*service != coe::Service::kSdoRequest) {
    reply = mailbox_error(MailboxErrorDetail::kServiceNotSupported);
  } else if (const auto decoded = coe::decode_request(request.data); !decoded) {
    reply.data = coe::encode(abort_with({}, abort::kCommand));
  } else {
    if (std::holds_alternative<coe::Abort>(*decoded)) {
      transfer_.reset();
      return std::nullopt;
    }
    reply.data = coe::encode(respond(*decoded));
  }
  reply.counter = counter_ = next_mailbox_counter(counter_);
  return reply;
}

coe::Response CoeServer::respond(const coe::Request& request) {
  if (const auto* r = std::get_if<coe::UploadRequest>(&request)) return upload(*r);
  if (const auto* r = std::get_if<coe::UploadSegmentRequest>(&request)) return upload_segment(*r);
  if (const auto* r = std::get_if<coe::DownloadRequest>(&request)) return download(*r);
  if (const auto* r = std::get_if<coe::DownloadSegmentRequest>(&request)) return download_segment(*r);
  return abort_with({}, abort::kCommand);
}

coe::Response CoeServer::upload(const coe::UploadRequest& request) {
  transfer_.reset();
  if (request.complete_access) return abort_with(request.object, abort::kNoCompleteAccess);
  std::vector<std::uint8_t> data;
  if (const auto code = dictionary_.read(request.object.index, request.object.sub_index, data); code != abort::kNone) {
    return abort_with(request.object, code);
  }
  coe::UploadResponse response;
  response.object = request.object;
  response.complete_size = static_cast<std::uint32_t>(data.size());
  response.expedited = !data.empty() && data.size() <= 4;
  const auto first = response.expedited ? data.size() : std::min(data.size(), coe::first_message_capacity(mailbox_size_));
  response.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(first));
  if (first < data.size()) transfer_ = Segmented{request.object, std::move(data), first, 0, false, false};
  return response;
}

coe::Response CoeServer::upload_segment(const coe::UploadSegmentRequest& request) {
  if (!transfer_ || transfer_->download) return abort_with({}, abort::kCommand);
  auto& t = *transfer_;
  if (request.toggle != t.toggle) {
    const auto object = t.object;
    transfer_.reset();
    return abort_with(object, abort::kToggle);
  }
  const auto count = std::min(t.data.size() - t.position, coe::segment_capacity(mailbox_size_));
  coe::UploadSegmentResponse response;
  response.toggle = t.toggle;
  const auto begin = t.data.begin() + static_cast<std::ptrdiff_t>(t.position);
  response.data.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
  t.position += count;
  t.toggle = !t.toggle;
  response.last = t.position == t.data.size();
  if (response.last) transfer_.reset();
  return response;
}

coe::Response CoeServer::store(const coe::ObjectAddress& object, std::span<const std::uint8_t> data) {
  const auto code = dictionary_.write(object.index, object.sub_index, data, in_preop_);
  if (code != abort::kNone) return abort_with(object, code);
  return coe::DownloadResponse{object};
}

coe::Response CoeServer::download(const coe::DownloadRequest& request) {
  transfer_.reset();
  if (request.complete_access) return abort_with(request.object, abort::kNoCompleteAccess);
  if (request.expedited || request.data.size() >= request.complete_size) return store(request.object, request.data);
  constexpr std::size_t kLargest = 64 * 1024;
  if (request.complete_size > kLargest) return abort_with(request.object, abort::kLength);
  transfer_ = Segmented{request.object, request.data, 0, request.complete_size, false, true};
  return coe::DownloadResponse{request.object};
}

coe::Response CoeServer::download_segment(const coe::DownloadSegmentRequest& request) {
  if (!transfer_ || !transfer_->download) return abort_with({}, abort::kCommand);
  auto& t = *transfer_;
  const auto object = t.object;
  if (request.toggle != t.toggle) {
    transfer_.reset();
    return abort_with(object, abort::kToggle);
  }
  t.data.insert(t.data.end(), request.data.begin(), request.data.end());
  t.toggle = !t.toggle;
  if (t.data.size() > t.size || (request.last && t.data.size() != t.size)) {
    transfer_.reset();
    return abort_with(object, abort::kLength);
  }
  if (request.last) {
    const auto data = std::move(t.data);
    transfer_.reset();
    if (const auto stored = store(object, data); std::holds_alternative<coe::Abort>(stored)) return stored;
  }
  return coe::DownloadSegmentResponse{request.toggle};
}

}  // namespace syncline::sim
