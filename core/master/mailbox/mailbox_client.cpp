// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/mailbox_client.h"

#include <fmt/format.h>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;
/// More than a mailbox queue of any slave; a slave that talks without end is not listened to for ever.
constexpr int kMostUnasked = 64;

}  // namespace

std::optional<coe::Emergency> emergency_in(const MailboxMessage& message) {
  if (message.type != MailboxType::kCoe) return std::nullopt;
  const auto response = coe::decode_response(message.data);
  if (!response) return std::nullopt;
  const auto* emergency = std::get_if<coe::Emergency>(&*response);
  return emergency != nullptr ? std::optional(*emergency) : std::nullopt;
}

Error mailbox_error(const std::string& subject, const MailboxMessage& message) {
  const auto reply = MailboxError::decode(message.data);
  if (!reply) return {ErrorCode::kMailboxProtocol, subject, "a mailbox error reply that cannot be read"};
  return {ErrorCode::kMailboxProtocol, subject,
          fmt::format("mailbox error {}, {}", static_cast<unsigned>(reply->detail), mailbox_error_text(reply->detail))};
}

MailboxClient::MailboxClient(Bus& bus, MailboxPort port, std::uint8_t& counter, EmergencyHandler on_emergency)
    : bus_(bus), transfer_(std::move(port), counter), on_emergency_(std::move(on_emergency)) {}

Status MailboxClient::run() {
  while (!transfer_.over()) {
    auto* datagram = transfer_.next(bus_.clock().now());
    if (datagram != nullptr) {
      if (auto status = bus_.transact(*datagram); !status) return status;
      transfer_.take(bus_.clock().now());
    }
    // With bus cycles the exchange itself took one.
    if (transfer_.over() || transfer_.in_a_hurry() || (datagram != nullptr && bus_.cyclic())) continue;
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  return {};
}

Result<std::vector<std::uint8_t>> MailboxClient::answer(MailboxType type) {
  for (int unasked = 0;; ++unasked) {
    if (auto status = run(); !status) return tl::unexpected(status.error());
    const auto& message = transfer_.result();
    if (!message) return tl::unexpected(message.error());
    if (message->type == MailboxType::kError) return fail(mailbox_error(port().name, *message));
    const auto emergency = emergency_in(*message);
    if (emergency && on_emergency_) on_emergency_(*emergency);
    if (!emergency && message->type == type) return message->data;
    if (unasked == kMostUnasked)
      return fail(ErrorCode::kMailboxProtocol, port().name, "messages without end, but no answer");
    transfer_.await_further(bus_.clock().now());
  }
}

Result<std::vector<std::uint8_t>> MailboxClient::ask(MailboxType type, std::span<const std::uint8_t> data) {
  transfer_.send(type, data, bus_.clock().now());
  return answer(type);
}

Result<std::vector<std::uint8_t>> MailboxClient::receive(MailboxType type) {
  transfer_.await(bus_.clock().now());
  return answer(type);
}

Result<std::vector<std::uint8_t>> MailboxClient::receive_instead(MailboxType type) {
  transfer_.await_further(bus_.clock().now());
  return answer(type);
}

Status MailboxClient::tell(MailboxType type, std::span<const std::uint8_t> data) {
  transfer_.send_only(type, data, bus_.clock().now());
  if (auto status = run(); !status) return status;
  if (!transfer_.result()) return tl::unexpected(transfer_.result().error());
  return {};
}

Status MailboxClient::collect() {
  for (int messages = 0; messages < kMostUnasked; ++messages) {
    const auto status = bus_.read<std::uint8_t>(port().station_address, kSm1Status, port().name);
    if (!status) return tl::unexpected(status.error());
    if ((*status & SyncManager::kStatusMailboxFull) == 0) return {};
    transfer_.await(bus_.clock().now());
    if (auto done = run(); !done) return done;
    const auto& message = transfer_.result();
    if (!message) return tl::unexpected(message.error());
    if (const auto emergency = emergency_in(*message); emergency && on_emergency_) on_emergency_(*emergency);
  }
  return {};
}

}  // namespace syncline
