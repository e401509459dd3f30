// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/mailbox_server.h"

#include <algorithm>
#include <utility>

namespace syncline::sim {
namespace {

constexpr std::size_t kMostEmergencies = 8;  // older ones go; a device has little memory

}  // namespace

MailboxServer::MailboxServer(ObjectDictionary& dictionary, const MailboxDescription& mailbox,
                             std::uint32_t foe_password)
    : mailbox_(mailbox),
      sdo_(dictionary, {mailbox.coe && mailbox.coe->complete_access}),
      information_(dictionary),
      files_(foe_password) {}

void MailboxServer::reset() {
  queue_.clear();
  last_.clear();
  before_last_.clear();
  sdo_.reset();
  files_.reset();
  eoe_.reset();
  last_request_ = counter_ = 0;
}

void MailboxServer::queue(MailboxType type, std::vector<std::uint8_t> data) {
  MailboxMessage message;
  message.type = type;
  message.data = std::move(data);
  message.counter = counter_ = next_mailbox_counter(counter_);
  queue_.push_back(message.encode());
}

void MailboxServer::queue_answer(MailboxType type, std::vector<std::uint8_t> data) {
  if (!data.empty()) queue(type, std::move(data));
}

void MailboxServer::queue_error(MailboxErrorDetail detail) {
  std::vector<std::uint8_t> data;
  ByteWriter(data).u16(1).u16(static_cast<std::uint16_t>(detail));
  queue(MailboxType::kError, std::move(data));
}

void MailboxServer::queue_emergency(const coe::Emergency& emergency) {
  if (!mailbox_.coe || static_cast<std::size_t>(queue_.size()) >= kMostEmergencies) return;
  queue(MailboxType::kCoe, coe::encode(coe::Response(emergency)));
}

std::optional<std::vector<std::uint8_t>> MailboxServer::next(std::size_t reply_size) {
  if (queue_.empty()) return std::nullopt;
  auto bytes = std::move(queue_.front());
  queue_.pop_front();
  if (bytes.size() > reply_size) return std::nullopt;  // a mailbox too small for its own protocol
  bytes.resize(reply_size);
  before_last_ = std::exchange(last_, bytes);
  return bytes;
}

const std::vector<std::uint8_t>& MailboxServer::repeat(bool loaded) {
  if (loaded) {
    if (before_last_.empty()) return before_last_;  // it was given again already, and lies there still
    queue_.push_front(std::move(last_));
    last_ = std::move(before_last_);
    before_last_.clear();
  }
  return last_;
}

void MailboxServer::receive(std::span<const std::uint8_t> bytes, std::size_t reply_size, bool in_preop) {
  const auto request = MailboxMessage::decode(bytes);
  if (!request) return queue_error(MailboxErrorDetail::kInvalidSize);
  // The same counter again: the master repeats a message whose answer it has not seen.
  if (request->counter != 0 && request->counter == last_request_) return;
  last_request_ = request->counter;
  if (request->channel != 0) return queue_error(MailboxErrorDetail::kInvalidChannel);
  switch (request->type) {
    case MailboxType::kCoe:
      if (mailbox_.coe) return receive_coe(*request, reply_size, in_preop);
      break;
    case MailboxType::kFoe:
      if (mailbox_.foe) return receive_foe(*request, reply_size);
      break;
    case MailboxType::kEoe:
      if (mailbox_.eoe) return queue_answer(request->type, eoe_.respond(request->data));
      break;
    case MailboxType::kSoe:
      if (mailbox_.soe) return queue_answer(request->type, soe_.respond(request->data));
      break;
    case MailboxType::kAoe:
      if (mailbox_.aoe) return queue_answer(request->type, aoe_.respond(request->data));
      break;
    case MailboxType::kVoe:
      if (mailbox_.voe) return;  // the vendor's own: nothing to say
      break;
    default:
      break;
  }
  queue_error(MailboxErrorDetail::kUnsupportedProtocol);
}

void MailboxServer::receive_coe(const MailboxMessage& request, std::size_t reply_size, bool in_preop) {
  const auto service = coe::service_of(request.data);
  if (!service)
    return queue_error(request.data.size() < 2 ? MailboxErrorDetail::kSizeTooShort
                                               : MailboxErrorDetail::kServiceNotSupported);
  if (*service == coe::Service::kSdoInformation && mailbox_.coe->sdo_info)
    return receive_information(request, reply_size);
  if (*service != coe::Service::kSdoRequest) return queue_error(MailboxErrorDetail::kServiceNotSupported);
  const auto decoded = coe::decode_request(request.data);
  if (!decoded) return queue(MailboxType::kCoe, coe::encode(coe::Response(coe::Abort{{}, abort::kCommand})));
  if (std::holds_alternative<coe::Abort>(*decoded)) return sdo_.reset();
  queue(MailboxType::kCoe, coe::encode(sdo_.respond(*decoded, reply_size, in_preop)));
}

void MailboxServer::receive_information(const MailboxMessage& request, std::size_t reply_size) {
  const auto decoded = coe::decode_information_request(request.data);
  const auto response = decoded ? information_.respond(*decoded) : coe::InformationError{abort::kCommand};
  for (auto& message : coe::encode(response, reply_size)) queue(MailboxType::kCoe, std::move(message));
}

void MailboxServer::receive_foe(const MailboxMessage& request, std::size_t reply_size) {
  const auto decoded = foe::decode(request.data);
  if (!decoded) return queue_error(MailboxErrorDetail::kSizeTooShort);
  if (const auto reply = files_.respond(*decoded, reply_size)) queue(MailboxType::kFoe, foe::encode(*reply));
}

}  // namespace syncline::sim
