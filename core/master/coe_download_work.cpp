// SPDX-License-Identifier: Apache-2.0
#include "master/coe_download_work.h"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr Nanoseconds kRequestTimeout = 1 * kSecond;   // until the slave has emptied its mailbox
constexpr Nanoseconds kResponseTimeout = 2 * kSecond;  // ESI default
constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;
constexpr std::uint16_t kSm1Activate = kSm1Status + 1;
constexpr std::uint8_t kRepeatRequest = 0x02;
constexpr std::size_t kExpeditedMax = 4;

}  // namespace

CoeDownloadWork::CoeDownloadWork(const SlaveConfig& slave, std::vector<const StartupCommand*> commands,
                                 std::uint8_t& counter, EmergencyHandler on_emergency)
    : slave_(slave),
      mailbox_(*slave.mailbox),
      commands_(std::move(commands)),
      counter_(counter),
      on_emergency_(std::move(on_emergency)) {}

std::string CoeDownloadWork::subject() const {
  return fmt::format("{}, object 0x{:04X}:{:02X}", slave_.name, command().index, command().sub_index);
}

Error CoeDownloadWork::mailbox_error(ErrorCode code, std::string detail) const {
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
  sent_ = std::min(data.size(), coe::first_message_capacity(mailbox_.send.length));
  request.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(sent_));
  segmented_ = toggle_ = false;
  ask(request, now);
}

void CoeDownloadWork::ask(const coe::Request& request, Nanoseconds now) {
  counter_ = next_mailbox_counter(counter_);
  MailboxMessage message;
  message.counter = counter_;
  message.data = coe::encode(request);
  request_ = message.encode(mailbox_.send.length);
  if (request_.size() > mailbox_.send.length) {
    return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, "the request is longer than the mailbox"));
  }
  end_ = now + kRequestTimeout;
  step_ = Step::kWrite;
}

Datagram* CoeDownloadWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  if (step_ == Step::kBegin) begin_command(now);
  if (over()) return nullptr;
  const auto station = slave_.station_address;
  status_.fill(0);
  switch (step_) {
    case Step::kBegin:
    case Step::kWrite:
      bytes_ = request_;
      datagram_ = {Command::kFpwr, device_address(station, mailbox_.send.start), bytes_};
      break;
    case Step::kPoll:
      datagram_ = {Command::kFprd, device_address(station, kSm1Status), status_};
      break;
    case Step::kRead:
      bytes_.assign(mailbox_.receive.length, 0);
      datagram_ = {Command::kFprd, device_address(station, mailbox_.receive.start), bytes_};
      break;
    case Step::kReadRepeat:
      datagram_ = {Command::kFprd, device_address(station, kSm1Activate), status_};
      break;
    case Step::kWriteRepeat:
      bytes_.resize(1);
      datagram_ = {Command::kFpwr, device_address(station, kSm1Activate), bytes_};
      break;
  }
  return &datagram_;
}

void CoeDownloadWork::take(Nanoseconds now) {
  switch (step_) {
    case Step::kBegin:
      break;
    case Step::kWrite:
      return take_write(now);
    case Step::kPoll:
      return take_poll(now);
    case Step::kRead:
      // The frame that emptied the mailbox was lost: the slave is asked to fill it again.
      if (datagram_.wkc == 0) {
        step_ = Step::kReadRepeat;
        return;
      }
      return take_message(now);
    case Step::kReadRepeat:
      bytes_.assign(1, static_cast<std::uint8_t>(status_[0] ^ kRepeatRequest));
      step_ = Step::kWriteRepeat;
      break;
    case Step::kWriteRepeat:
      step_ = Step::kPoll;
      break;
  }
}

void CoeDownloadWork::take_write(Nanoseconds now) {
  // A mailbox that is full after a repetition holds the request: only the answer of the first frame was lost.
  if (datagram_.wkc > 0 || datagram_.times_sent > 1) {
    end_ = now + (command().timeout_ms == 0 ? kResponseTimeout : command().timeout_ms * kMillisecond);
    step_ = Step::kPoll;
  } else if (now >= end_) {
    fail_with(mailbox_error(ErrorCode::kMailboxTimeout));
  }
}

void CoeDownloadWork::take_poll(Nanoseconds now) {
  if (datagram_.wkc > 0 && (status_[0] & SyncManager::kStatusMailboxFull) != 0) {
    step_ = Step::kRead;
  } else if (now >= end_) {
    fail_with(mailbox_error(ErrorCode::kMailboxTimeout));
  }
}

void CoeDownloadWork::take_message(Nanoseconds now) {
  const auto message = MailboxMessage::decode(bytes_);
  if (!message) return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, "its message lies about its length"));
  step_ = Step::kPoll;
  if (message->type == MailboxType::kError) {
    const auto detail = message->data.size() >= 4 ? load_le<std::uint16_t>(std::span(message->data).subspan(2)) : 0;
    return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, fmt::format("mailbox error {}", detail)));
  }
  if (message->type != MailboxType::kCoe) return;
  const auto response = coe::decode_response(message->data);
  if (!response) {
    auto error = response.error();
    error.subject = subject();
    return fail_with(std::move(error));
  }
  if (const auto* emergency = std::get_if<coe::Emergency>(&*response)) {
    if (on_emergency_) on_emergency_(*emergency);
    return;
  }
  take_response(*response, now);
}

void CoeDownloadWork::take_response(const coe::Response& response, Nanoseconds now) {
  if (const auto* abort = std::get_if<coe::Abort>(&response)) {
    auto error = mailbox_error(ErrorCode::kSdoAbort);
    error.received = abort->code;
    return fail_with(std::move(error));
  }
  const auto* segment = std::get_if<coe::DownloadSegmentResponse>(&response);
  if (segmented_ ? segment == nullptr : std::get_if<coe::DownloadResponse>(&response) == nullptr) {
    return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, "the answer belongs to another request"));
  }
  if (segment != nullptr && segment->toggle != toggle_) {
    return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, "the toggle bit did not alternate"));
  }
  if (sent_ < command().data.size()) return send_segment(now);
  ++index_;
  step_ = Step::kBegin;
}

void CoeDownloadWork::send_segment(Nanoseconds now) {
  const auto rest = std::span(command().data).subspan(sent_);
  const auto size = std::min(rest.size(), coe::segment_capacity(mailbox_.send.length));
  if (size == 0) return fail_with(mailbox_error(ErrorCode::kMailboxProtocol, "the mailbox holds no segment"));
  toggle_ = segmented_ && !toggle_;
  segmented_ = true;
  coe::DownloadSegmentRequest request{toggle_, size == rest.size(), {}};
  request.data.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
  sent_ += size;
  ask(request, now);
}

}  // namespace syncline
