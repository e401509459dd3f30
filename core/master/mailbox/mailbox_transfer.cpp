// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/mailbox_transfer.h"

#include <algorithm>

#include "protocol/coe.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr int kMostAnew = 3;  // for one message

BriefError mailbox_error(std::span<const std::uint8_t> data) {
  if (data.size() < 4 || load_le<std::uint16_t>(data) != 1)
    return protocol_error("a mailbox error reply that cannot be read");
  const auto detail = load_le<std::uint16_t>(data.subspan(2));
  auto error = protocol_error("mailbox error {number}, {reason}", detail);
  error.why.word = mailbox_error_text(static_cast<MailboxErrorDetail>(detail));
  return error;
}

}  // namespace

void MailboxTransfer::use(SlaveMailbox& mailbox) {
  mailbox_ = &mailbox;
  handshake_.use(mailbox.port, mailbox.receipt);
  request_.reserve(std::max<std::size_t>(mailbox.port.send.length, MailboxMessage::kHeaderSize));
  over_ = true;
  failure_.reset();
  data_ = {};
}

void MailboxTransfer::begin() {
  over_ = empty_ = false;
  failure_.reset();
  data_ = {};
}

void MailboxTransfer::send(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered) {
  begin();
  fetching_ = emergency_ = false;
  asked_anew_ = unasked_ = 0;
  type_ = type;
  if (data.size() + MailboxMessage::kHeaderSize > mailbox_->port.send.length)
    return end_with(protocol_error("the request is longer than the mailbox"));
  mailbox_->counter = next_mailbox_counter(mailbox_->counter);
  request_.clear();
  append(request_, MailboxMessageView{type, mailbox_->counter, data});
  handshake_.send(request_, answered, now);
  note_end(now);
}

void MailboxTransfer::ask(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) {
  send(type, data, now, true);
}

void MailboxTransfer::tell(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) {
  send(type, data, now, false);
}

void MailboxTransfer::receive(Nanoseconds now) {
  begin();
  unasked_ = 0;
  handshake_.await(now);
  note_end(now);
}

void MailboxTransfer::receive_instead(Nanoseconds now) {
  begin();
  handshake_.await_further(now);
  note_end(now);
}

void MailboxTransfer::fetch(Nanoseconds now) {
  begin();
  fetching_ = true;
  emergency_ = false;
  handshake_.fetch(now);
  note_end(now);
}

Datagram* MailboxTransfer::next(Nanoseconds now) {
  if (over_) return nullptr;
  auto* datagram = handshake_.next(now);
  note_end(now);
  return datagram;
}

void MailboxTransfer::take(Nanoseconds now) {
  if (over_) return;
  handshake_.take(now);
  note_end(now);
}

void MailboxTransfer::end_with(const BriefError& failure) {
  over_ = true;
  failure_ = failure;
}

void MailboxTransfer::note_end(Nanoseconds now) {
  if (over_ || !handshake_.over()) return;
  mailbox_->full.reset();  // what the last cycle said is over
  switch (handshake_.end()) {
    case MailboxHandshake::End::kAnswerLost:
      if (asked_anew_ == kMostAnew) return give_up();
      ++asked_anew_;
      mailbox_->counter = next_mailbox_counter(mailbox_->counter);
      return handshake_.send_anew(mailbox_->counter, now);
    case MailboxHandshake::End::kUnderWay:
    case MailboxHandshake::End::kTimeout:
      return give_up();
    case MailboxHandshake::End::kEmpty:
      empty_ = over_ = true;
      return;
    case MailboxHandshake::End::kSent:
      over_ = true;
      return;
    case MailboxHandshake::End::kTooLong:
      return end_with(protocol_error("the request is longer than the mailbox"));
    case MailboxHandshake::End::kNoRoom:
      return end_with(protocol_error("its mailbox holds no message"));
    case MailboxHandshake::End::kMessage:
    case MailboxHandshake::End::kMalformed:
      return take_message(now);
  }
}

bool MailboxTransfer::hand_on_emergency(const MailboxMessageView& message, Nanoseconds now) {
  if (message.type != MailboxType::kCoe) return false;
  const auto service = coe::view_service(message.data);
  if (!service || *service != coe::Service::kEmergency) return false;
  const auto response = coe::view_response(message.data);
  if (!response) return false;
  emergency_ = true;
  if (mailbox_->on_emergency) mailbox_->on_emergency(response->emergency, now);
  return true;
}

void MailboxTransfer::take_message(Nanoseconds now) {
  const auto message = view_mailbox_message(handshake_.message());
  if (!message) {
    auto failure = message.error();
    failure.code = ErrorCode::kMailboxProtocol;
    return end_with(failure);
  }
  const bool emergency = hand_on_emergency(*message, now);
  if (fetching_) {
    over_ = true;
    return;
  }
  if (message->type == MailboxType::kError) return end_with(mailbox_error(message->data));
  if (!emergency && message->type == type_) {
    data_ = message->data;
    over_ = true;
    return;
  }
  if (++unasked_ > kMostUnasked) return end_with(protocol_error("messages without end, but no answer"));
  handshake_.await_further(now);
  note_end(now);
}

}  // namespace syncline
