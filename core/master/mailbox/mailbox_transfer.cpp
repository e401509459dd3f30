// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/mailbox_transfer.h"

#include <utility>

namespace syncline {
namespace {

constexpr int kMostAnew = 3;  // for one message

}  // namespace

MailboxTransfer::MailboxTransfer(MailboxPort port, std::uint8_t& counter) : port_(std::move(port)), counter_(counter) {
  handshake_.use(port_, receipt_);
}

MailboxTransfer::MailboxTransfer(MailboxTransfer&& other) noexcept
    : port_(std::move(other.port_)), counter_(other.counter_), receipt_(other.receipt_) {
  handshake_.use(port_, receipt_);  // transfers move before they begin
}

void MailboxTransfer::begin(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered) {
  counter_ = next_mailbox_counter(counter_);
  MailboxMessage message;
  message.type = type;
  message.counter = counter_;
  message.data.assign(data.begin(), data.end());
  noted_ = false;
  asked_anew_ = 0;
  handshake_.send(message.encode(port_.send.length), answered, now);
  note_end(now);
}

void MailboxTransfer::await(Nanoseconds now) {
  noted_ = false;
  handshake_.await(now);
  note_end(now);
}

void MailboxTransfer::await_further(Nanoseconds now) {
  noted_ = false;
  handshake_.await_further(now);
  note_end(now);
}

Datagram* MailboxTransfer::next(Nanoseconds now) {
  auto* datagram = handshake_.next(now);
  note_end(now);
  return datagram;
}

void MailboxTransfer::take(Nanoseconds now) {
  handshake_.take(now);
  note_end(now);
}

void MailboxTransfer::note_end(Nanoseconds now) {
  if (noted_ || !handshake_.over()) return;
  if (handshake_.end() == MailboxHandshake::End::kAnswerLost && asked_anew_ < kMostAnew) {
    ++asked_anew_;
    counter_ = next_mailbox_counter(counter_);
    return handshake_.send_anew(counter_, now);
  }
  noted_ = true;
  switch (handshake_.end()) {
    case MailboxHandshake::End::kUnderWay:
    case MailboxHandshake::End::kEmpty:
    case MailboxHandshake::End::kTimeout:
    case MailboxHandshake::End::kAnswerLost:
      result_ = fail(ErrorCode::kMailboxTimeout, port_.name);
      return;
    case MailboxHandshake::End::kSent:
      result_ = MailboxMessage{};
      return;
    case MailboxHandshake::End::kTooLong:
      result_ = fail(ErrorCode::kMailboxProtocol, port_.name, "the request is longer than the mailbox");
      return;
    case MailboxHandshake::End::kNoRoom:
      result_ = fail(ErrorCode::kMailboxProtocol, port_.name, "its mailbox holds no message");
      return;
    case MailboxHandshake::End::kMessage:
    case MailboxHandshake::End::kMalformed:
      result_ = MailboxMessage::decode(handshake_.message());
      if (result_) return;
      result_.error().code = ErrorCode::kMailboxProtocol;
      result_.error().subject = port_.name;
      return;
  }
}

}  // namespace syncline
