// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/foe_client.h"

#include <fmt/format.h>

#include <algorithm>

namespace syncline {
namespace {

/// Flash memory is slow, but not for ever.
constexpr Nanoseconds kBusyPause = 20 * kMillisecond;
constexpr Nanoseconds kBusyPatience = 60 * kSecond;
constexpr int kMostDuplicates = 64;

}  // namespace

Result<foe::Message> FoeClient::decode(const Result<std::vector<std::uint8_t>>& bytes,
                                       const std::string& subject) const {
  if (!bytes) return tl::unexpected(bytes.error());
  auto message = foe::decode(*bytes);
  if (!message) return fail(ErrorCode::kMailboxProtocol, subject, message.error().detail);
  if (const auto* error = std::get_if<foe::FileError>(&*message)) {
    Error failure{ErrorCode::kFileTransfer, subject, error->text};
    failure.received = error->code;
    return fail(std::move(failure));
  }
  return message;
}

Result<foe::Message> FoeClient::ask(const foe::Message& message, const std::string& subject) {
  return decode(mailbox_.ask(MailboxType::kFoe, foe::encode(message)), subject);
}

Status FoeClient::end_transfer(std::uint32_t code, const std::string& subject, std::string why) {
  (void)mailbox_.tell(MailboxType::kFoe, foe::encode(foe::FileError{code, {}}));
  return fail(ErrorCode::kMailboxProtocol, subject, std::move(why));
}

Result<std::vector<std::uint8_t>> FoeClient::read(const std::string& name, std::uint32_t password) {
  const auto subject = fmt::format("{}, file \"{}\"", mailbox_.port().name, name);
  const auto full = foe::data_capacity(mailbox_.port().receive.length);
  std::vector<std::uint8_t> file;
  std::uint32_t expected = 1;
  int duplicates = 0;
  auto busy_until = mailbox_.bus().clock().now() + kBusyPatience;
  foe::Message request = foe::ReadRequest{password, name};
  while (true) {
    const auto answer = ask(request, subject);
    if (!answer) return tl::unexpected(answer.error());
    const auto* data = std::get_if<foe::Data>(&*answer);
    if (std::holds_alternative<foe::Busy>(*answer) && mailbox_.bus().clock().now() < busy_until) {
      if (auto status = mailbox_.bus().wait(kBusyPause); !status) return tl::unexpected(status.error());
      continue;  // the same request once more
    }
    if (data == nullptr) {
      return tl::unexpected(end_transfer(foe::error::kIllegal, subject, "no data where data were asked for").error());
    }
    // A packet again: its acknowledgement did not arrive.
    if (data->packet_no + 1 == expected && expected > 1 && ++duplicates < kMostDuplicates) continue;
    if (data->packet_no != expected) {
      auto why = fmt::format("packet {} where {} was to come", data->packet_no, expected);
      return tl::unexpected(end_transfer(foe::error::kPacketNumber, subject, std::move(why)).error());
    }
    if (file.size() + data->bytes.size() > kLargestFile) {
      return tl::unexpected(end_transfer(foe::error::kDiskFull, subject, "the file has no end").error());
    }
    file.insert(file.end(), data->bytes.begin(), data->bytes.end());
    if (progress_) progress_(file.size());
    busy_until = mailbox_.bus().clock().now() + kBusyPatience;
    duplicates = 0;
    request = foe::Ack{expected++};
    if (data->bytes.size() >= full) continue;
    if (auto status = mailbox_.tell(MailboxType::kFoe, foe::encode(request)); !status)
      return tl::unexpected(status.error());
    return file;
  }
}

/// Until the slave acknowledges it; once more when the slave was busy.
Status FoeClient::send_packet(const foe::Message& packet, std::uint32_t packet_no, const std::string& subject) {
  const auto busy_until = mailbox_.bus().clock().now() + kBusyPatience;
  int duplicates = 0;
  auto answer = ask(packet, subject);
  while (true) {
    if (!answer) return tl::unexpected(answer.error());
    if (const auto* ack = std::get_if<foe::Ack>(&*answer)) {
      if (ack->packet_no == packet_no) return {};
      // The acknowledgement before, twice: the one that counts is still to come.
      if (ack->packet_no + 1 == packet_no && ++duplicates < kMostDuplicates) {
        answer = decode(mailbox_.receive_instead(MailboxType::kFoe), subject);
        continue;
      }
      return end_transfer(foe::error::kPacketNumber, subject,
                          fmt::format("packet {} acknowledged where {} was sent", ack->packet_no, packet_no));
    }
    if (!std::holds_alternative<foe::Busy>(*answer)) {
      return end_transfer(foe::error::kIllegal, subject, "no acknowledgement where one was to come");
    }
    if (mailbox_.bus().clock().now() >= busy_until)
      return end_transfer(foe::error::kNotDefined, subject, "busy without end");
    if (auto status = mailbox_.bus().wait(kBusyPause); !status) return status;
    answer = ask(packet, subject);
  }
}

Status FoeClient::write(const std::string& name, std::span<const std::uint8_t> file, std::uint32_t password) {
  const auto subject = fmt::format("{}, file \"{}\"", mailbox_.port().name, name);
  const auto full = foe::data_capacity(mailbox_.port().send.length);
  if (full == 0) return fail(ErrorCode::kMailboxProtocol, subject, "the mailbox holds no data");
  if (auto status = send_packet(foe::WriteRequest{password, name}, 0, subject); !status) return status;
  std::uint32_t packet_no = 0;
  // A file that fills its last packet is ended by an empty one.
  for (std::size_t sent = 0, size = full; size == full; sent += size) {
    size = std::min(full, file.size() - sent);
    const auto part = file.subspan(sent, size);
    const foe::Data packet{++packet_no, {part.begin(), part.end()}};
    if (auto status = send_packet(packet, packet_no, subject); !status) return status;
    if (progress_) progress_(sent + size);
  }
  return {};
}

}  // namespace syncline
