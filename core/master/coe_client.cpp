// SPDX-License-Identifier: Apache-2.0
#include "master/coe_client.h"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr Nanoseconds kRequestTimeout = 1 * kSecond;   // until the slave has emptied its mailbox
constexpr Nanoseconds kResponseTimeout = 2 * kSecond;  // ESI default
constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;
constexpr std::size_t kExpeditedMax = 4;
constexpr std::uint32_t kToggleError = 0x05030000;

}  // namespace

CoeClient::CoeClient(Bus& bus, const SlaveConfig& slave, std::uint8_t& counter, EmergencyHandler on_emergency)
    : bus_(bus),
      slave_(slave),
      mailbox_(*slave.mailbox),
      counter_(counter),
      on_emergency_(std::move(on_emergency)),
      timeout_(kResponseTimeout) {}

void CoeClient::set_timeout_ms(std::uint32_t timeout_ms) {
  timeout_ = timeout_ms == 0 ? kResponseTimeout : timeout_ms * kMillisecond;
}

std::string CoeClient::subject(coe::ObjectAddress object) const {
  return fmt::format("{}, object 0x{:04X}:{:02X}", slave_.name, object.index, object.sub_index);
}

Status CoeClient::write_mailbox(std::vector<std::uint8_t> coe_data) {
  counter_ = next_mailbox_counter(counter_);
  MailboxMessage message;
  message.counter = counter_;
  message.data = std::move(coe_data);
  const auto bytes = message.encode(mailbox_.send.length);
  if (bytes.size() > mailbox_.send.length) {
    return fail(ErrorCode::kMailboxProtocol, slave_.name, "the request is longer than the mailbox");
  }
  const auto end = bus_.clock().now() + kRequestTimeout;
  while (true) {
    auto copy = bytes;
    const auto wkc = bus_.exchange(Command::kFpwr, slave_.station_address, mailbox_.send.start, copy);
    if (!wkc) return tl::unexpected(wkc.error());
    if (*wkc > 0) return {};
    if (bus_.clock().now() >= end) return fail(ErrorCode::kMailboxTimeout, slave_.name);
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
}

Status CoeClient::wait_until_full(Nanoseconds end) {
  while (true) {
    std::array<std::uint8_t, 1> sm_status{};
    const auto wkc = bus_.exchange(Command::kFprd, slave_.station_address, kSm1Status, sm_status);
    if (!wkc) return tl::unexpected(wkc.error());
    if (*wkc > 0 && (sm_status[0] & SyncManager::kStatusMailboxFull) != 0) return {};
    if (bus_.clock().now() >= end) return fail(ErrorCode::kMailboxTimeout, slave_.name);
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
}

Result<MailboxMessage> CoeClient::read_mailbox() {
  const auto end = bus_.clock().now() + timeout_;
  while (true) {
    if (auto status = wait_until_full(end); !status) return tl::unexpected(status.error());
    std::vector<std::uint8_t> bytes(mailbox_.receive.length);
    const auto wkc = bus_.exchange(Command::kFprd, slave_.station_address, mailbox_.receive.start, bytes);
    if (!wkc) return tl::unexpected(wkc.error());
    if (*wkc > 0) return MailboxMessage::decode(bytes);
    // The frame that emptied the mailbox was lost: ask the slave to fill it again.
    std::array<std::uint8_t, 1> activate{};
    const auto read = bus_.exchange(Command::kFprd, slave_.station_address, kSm1Status + 1, activate);
    if (!read) return tl::unexpected(read.error());
    activate[0] ^= 0x02;
    if (auto written = bus_.exchange(Command::kFpwr, slave_.station_address, kSm1Status + 1, activate); !written) {
      return tl::unexpected(written.error());
    }
  }
}

Result<coe::Response> CoeClient::ask(const coe::Request& request) {
  if (auto status = write_mailbox(coe::encode(request)); !status) return tl::unexpected(status.error());
  while (true) {
    const auto message = read_mailbox();
    if (!message) return tl::unexpected(message.error());
    if (message->type == MailboxType::kError) {
      const auto detail = message->data.size() >= 4 ? load_le<std::uint16_t>(std::span(message->data).subspan(2)) : 0;
      return fail(ErrorCode::kMailboxProtocol, slave_.name, fmt::format("mailbox error {}", detail));
    }
    if (message->type != MailboxType::kCoe) continue;
    auto response = coe::decode_response(message->data);
    if (!response) {
      response.error().subject = slave_.name;
      return response;
    }
    const auto* emergency = std::get_if<coe::Emergency>(&*response);
    if (emergency == nullptr) return response;
    if (on_emergency_) on_emergency_(*emergency);
  }
}

template <class Expected>
Result<Expected> CoeClient::ask_for(const coe::Request& request, coe::ObjectAddress object) {
  auto response = ask(request);
  if (!response) return tl::unexpected(response.error());
  if (const auto* abort = std::get_if<coe::Abort>(&*response)) {
    Error error{ErrorCode::kSdoAbort, subject(object)};
    error.received = abort->code;
    return fail(std::move(error));
  }
  if (auto* expected = std::get_if<Expected>(&*response)) return std::move(*expected);
  return fail(ErrorCode::kMailboxProtocol, subject(object), "the answer belongs to another request");
}

Status CoeClient::download(coe::ObjectAddress object, std::span<const std::uint8_t> data, bool complete_access) {
  coe::DownloadRequest request;
  request.object = object;
  request.complete_access = complete_access;
  request.expedited = !complete_access && !data.empty() && data.size() <= kExpeditedMax;
  request.complete_size = static_cast<std::uint32_t>(data.size());
  const auto first = std::min(data.size(), coe::first_message_capacity(mailbox_.send.length));
  request.data.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(first));
  if (auto response = ask_for<coe::DownloadResponse>(request, object); !response) {
    return tl::unexpected(response.error());
  }
  return download_segments(object, data.subspan(first));
}

Status CoeClient::download_segments(coe::ObjectAddress object, std::span<const std::uint8_t> rest) {
  bool toggle = false;
  while (!rest.empty()) {
    const auto size = std::min(rest.size(), coe::segment_capacity(mailbox_.send.length));
    coe::DownloadSegmentRequest request{toggle, size == rest.size(), {}};
    request.data.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
    const auto response = ask_for<coe::DownloadSegmentResponse>(request, object);
    if (!response) return tl::unexpected(response.error());
    if (response->toggle != toggle) {
      (void)write_mailbox(coe::encode(coe::Request(coe::Abort{object, kToggleError})));
      return fail(ErrorCode::kMailboxProtocol, subject(object), "the toggle bit did not alternate");
    }
    toggle = !toggle;
    rest = rest.subspan(size);
  }
  return {};
}

Result<std::vector<std::uint8_t>> CoeClient::upload(coe::ObjectAddress object, bool complete_access) {
  auto first = ask_for<coe::UploadResponse>(coe::UploadRequest{object, complete_access}, object);
  if (!first) return tl::unexpected(first.error());
  auto data = std::move(first->data);
  bool toggle = false;
  bool last = first->expedited || data.size() >= first->complete_size;
  while (!last) {
    const auto segment = ask_for<coe::UploadSegmentResponse>(coe::UploadSegmentRequest{toggle}, object);
    if (!segment) return tl::unexpected(segment.error());
    if (segment->toggle != toggle) {
      (void)write_mailbox(coe::encode(coe::Request(coe::Abort{object, kToggleError})));
      return fail(ErrorCode::kMailboxProtocol, subject(object), "the toggle bit did not alternate");
    }
    data.insert(data.end(), segment->data.begin(), segment->data.end());
    last = segment->last;
    toggle = !toggle;
  }
  if (!first->expedited && data.size() > first->complete_size) data.resize(first->complete_size);
  return data;
}

}  // namespace syncline
