// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/sdo_server.h"

#include <algorithm>

#include "sim/mailbox/complete_access.h"

namespace syncline::sim {
namespace {

/// Longest value that the device has room for.
constexpr std::size_t kLargestObject = 64 * 1024;

coe::Response abort_with(const coe::ObjectAddress& object, std::uint32_t code) { return coe::Abort{object, code}; }

}  // namespace

coe::Response SdoServer::respond(const coe::Request& request, std::size_t mailbox_size, bool in_preop) {
  mailbox_size_ = mailbox_size;
  in_preop_ = in_preop;
  if (const auto* r = std::get_if<coe::UploadRequest>(&request)) return upload(*r);
  if (const auto* r = std::get_if<coe::UploadSegmentRequest>(&request)) return upload_segment(*r);
  if (const auto* r = std::get_if<coe::DownloadRequest>(&request)) return download(*r);
  if (const auto* r = std::get_if<coe::DownloadSegmentRequest>(&request)) return download_segment(*r);
  return abort_with({}, abort::kCommand);
}

std::uint32_t SdoServer::check_complete_access(const coe::ObjectAddress& object) const {
  if (!options_.complete_access) return abort::kNoCompleteAccess;
  return object.sub_index > 1 ? abort::kUnsupportedAccess : abort::kNone;
}

coe::Response SdoServer::upload(const coe::UploadRequest& request) {
  transfer_.reset();
  const auto& object = request.object;
  std::vector<std::uint8_t> data;
  auto code = abort::kNone;
  if (request.complete_access) {
    code = check_complete_access(object);
    if (code == abort::kNone) code = read_complete(dictionary_, object, data);
  } else {
    code = dictionary_.read(object.index, object.sub_index, data);
  }
  if (code != abort::kNone) return abort_with(object, code);

  coe::UploadResponse response;
  response.object = object;
  response.complete_access = request.complete_access;
  response.complete_size = static_cast<std::uint32_t>(data.size());
  response.expedited = !data.empty() && data.size() <= 4;
  const auto first =
      response.expedited ? data.size() : std::min(data.size(), coe::first_message_capacity(mailbox_size_));
  response.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(first));
  if (first < data.size())
    transfer_ = Transfer{object, request.complete_access, std::move(data), first, 0, false, false};
  return response;
}

coe::Response SdoServer::upload_segment(const coe::UploadSegmentRequest& request) {
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

std::uint32_t SdoServer::store(const Transfer& transfer) {
  const auto& object = transfer.object;
  if (transfer.complete_access) return write_complete(dictionary_, object, transfer.data, in_preop_);
  return dictionary_.write(object.index, object.sub_index, transfer.data, in_preop_);
}

coe::Response SdoServer::download(const coe::DownloadRequest& request) {
  transfer_.reset();
  const auto& object = request.object;
  if (request.complete_access) {
    if (const auto code = check_complete_access(object); code != abort::kNone) return abort_with(object, code);
  }
  Transfer transfer{object, request.complete_access, request.data, 0, request.complete_size, false, true};
  if (request.expedited || request.data.size() >= request.complete_size) {
    const auto code = store(transfer);
    if (code != abort::kNone) return abort_with(object, code);
    return coe::DownloadResponse{object};
  }
  if (request.complete_size > kLargestObject) return abort_with(object, abort::kOutOfMemory);
  transfer_ = std::move(transfer);
  return coe::DownloadResponse{object};
}

coe::Response SdoServer::download_segment(const coe::DownloadSegmentRequest& request) {
  if (!transfer_ || !transfer_->download) return abort_with({}, abort::kCommand);
  auto& t = *transfer_;
  const auto object = t.object;
  const auto refuse = [&](std::uint32_t code) {
    transfer_.reset();
    return abort_with(object, code);
  };
  if (request.toggle != t.toggle) return refuse(abort::kToggle);
  t.data.insert(t.data.end(), request.data.begin(), request.data.end());
  t.toggle = !t.toggle;
  if (t.data.size() > t.size) return refuse(abort::kTooLong);
  if (!request.last) return coe::DownloadSegmentResponse{request.toggle};
  if (t.data.size() != t.size) return refuse(abort::kTooShort);
  const auto transfer = std::move(t);
  transfer_.reset();
  if (const auto code = store(transfer); code != abort::kNone) return abort_with(object, code);
  return coe::DownloadSegmentResponse{request.toggle};
}

}  // namespace syncline::sim
