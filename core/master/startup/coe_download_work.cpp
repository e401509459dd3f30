// SPDX-License-Identifier: Apache-2.0
#include "master/startup/coe_download_work.h"

#include <fmt/format.h>

#include <algorithm>

#include "master/mailbox/mailbox_client.h"

namespace syncline {
namespace {

constexpr std::size_t kExpeditedMax = 4;
constexpr int kMostUnasked = 64;

}  // namespace

CoeDownloadWork::CoeDownloadWork(MailboxPort port, std::vector<const StartupCommand*> commands, std::uint8_t& counter,
                                 EmergencyHandler on_emergency)
    : transfer_(std::move(port), counter),
      response_timeout_(transfer_.port().response_timeout),
      commands_(std::move(commands)),
      on_emergency_(std::move(on_emergency)) {}

std::string CoeDownloadWork::subject() const {
  return fmt::format("{}, object 0x{:04X}:{:02X}", transfer_.port().name, command().index, command().sub_index);
}

Error CoeDownloadWork::error(ErrorCode code, std::string detail) const {
  return Error{code, subject(), std::move(detail)};
}

void CoeDownloadWork::fail_with(Error error) {
  failed_ = true;
  result_ = fail(std::move(error));
}

void CoeDownloadWork::begin_command(Nanoseconds now) {
  const auto& data = command().data;
  coe::DownloadRequest request;
  request.object = {command().index, command().sub_index};
  request.complete_access = command().complete_access;
  request.expedited = !command().complete_access && !data.empty() && data.size() <= kExpeditedMax;
  request.complete_size = static_cast<std::uint32_t>(data.size());
  sent_ = std::min(data.size(), coe::first_message_capacity(transfer_.port().send.length));
  request.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(sent_));
  segmented_ = toggle_ = false;
  begun_ = true;
  transfer_.set_response_timeout(command().timeout_ms == 0 ? response_timeout_ : command().timeout_ms * kMillisecond);
  ask(request, now);
}

void CoeDownloadWork::ask(const coe::Request& request, Nanoseconds now) {
  unasked_ = 0;
  transfer_.send(MailboxType::kCoe, coe::encode(request), now);
}

Datagram* CoeDownloadWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  if (!begun_) begin_command(now);
  auto* datagram = transfer_.next(now);
  if (transfer_.over() && !transfer_.result()) {  // no message can come of it
    auto failure = transfer_.result().error();
    failure.subject = subject();
    fail_with(std::move(failure));
  }
  return datagram;
}

void CoeDownloadWork::take(Nanoseconds now) {
  transfer_.take(now);
  if (!transfer_.over()) return;
  if (transfer_.result()) return take_message(*transfer_.result(), now);
  auto failure = transfer_.result().error();
  failure.subject = subject();
  fail_with(std::move(failure));
}

void CoeDownloadWork::take_message(const MailboxMessage& message, Nanoseconds now) {
  if (message.type == MailboxType::kError) return fail_with(mailbox_error(subject(), message));
  const auto emergency = emergency_in(message);
  if (emergency && on_emergency_) on_emergency_(*emergency);
  if (emergency || message.type != MailboxType::kCoe) {
    if (++unasked_ > kMostUnasked)
      return fail_with(error(ErrorCode::kMailboxProtocol, "messages without end, but no answer"));
    return transfer_.await_further(now);
  }
  const auto response = coe::decode_response(message.data);
  if (!response) return fail_with(error(ErrorCode::kMailboxProtocol, response.error().detail));
  take_response(*response, now);
}

void CoeDownloadWork::take_response(const coe::Response& response, Nanoseconds now) {
  if (const auto* abort = std::get_if<coe::Abort>(&response)) {
    auto failure = error(ErrorCode::kSdoAbort);
    failure.received = abort->code;
    return fail_with(std::move(failure));
  }
  const auto* segment = std::get_if<coe::DownloadSegmentResponse>(&response);
  if (segmented_ ? segment == nullptr : std::get_if<coe::DownloadResponse>(&response) == nullptr) {
    return fail_with(error(ErrorCode::kMailboxProtocol, "the answer belongs to another request"));
  }
  if (segment != nullptr && segment->toggle != toggle_) {
    return fail_with(error(ErrorCode::kMailboxProtocol, "the toggle bit did not alternate"));
  }
  if (sent_ < command().data.size()) return send_segment(now);
  ++index_;
  begun_ = false;
}

void CoeDownloadWork::send_segment(Nanoseconds now) {
  const auto rest = std::span(command().data).subspan(sent_);
  const auto size = std::min(rest.size(), coe::segment_capacity(transfer_.port().send.length));
  if (size == 0) return fail_with(error(ErrorCode::kMailboxProtocol, "the mailbox holds no segment"));
  toggle_ = segmented_ && !toggle_;
  segmented_ = true;
  coe::DownloadSegmentRequest request{toggle_, size == rest.size(), {}};
  request.data.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
  sent_ += size;
  ask(request, now);
}

}  // namespace syncline
