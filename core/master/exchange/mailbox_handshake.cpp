// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/mailbox_handshake.h"

#include <algorithm>

#include "config/slave_config.h"
#include "protocol/datagram.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSm1Activate = kSm1Status + 1;
constexpr std::uint8_t kRepeat = 0x02;  // request in "activate", acknowledge in "PDI control"
/// A request whose fate is unknown is written again when nothing has come for so long.
constexpr Nanoseconds kRewriteAfter = 20 * kMillisecond;
/// The process image's bit may be stale (lost slave, FMMU not set): then the register is asked now and then.
constexpr Nanoseconds kLookAnyway = 20 * kMillisecond;
/// For slaves that fill the mailbox again but never acknowledge.
constexpr Nanoseconds kRepeatPatience = 50 * kMillisecond;
/// A slave that can repeat a message loads it before it acknowledges; some acknowledge and have none.
constexpr Nanoseconds kRepeatedAfter = 100 * kMillisecond;
constexpr std::size_t kCounterByte = 5;  // of a mailbox header; bits 6..4

}  // namespace

MailboxPort mailbox_port(const SlaveConfig& slave) {
  MailboxPort port;
  port.name = slave.name;
  port.station_address = slave.station_address;
  if (!slave.mailbox) return port;
  port.send = slave.mailbox->send;
  port.receive = slave.mailbox->receive;
  port.request_timeout = slave.mailbox->timeouts.request_ms * kMillisecond;
  port.response_timeout = slave.mailbox->timeouts.response_ms * kMillisecond;
  return port;
}

void MailboxHandshake::use(const MailboxPort& port, Receipt& receipt) {
  port_ = &port;
  receipt_ = &receipt;
  response_timeout_ = port.response_timeout;
  step_ = Step::kOver;
  read_repeated_ = false;
  request_.reserve(port.send.length);
  bytes_.reserve(std::max(port.send.length, port.receive.length));
}

void MailboxHandshake::begin_write(bool answered, Nanoseconds now) {
  wants_answer_ = answered;
  only_fetch_ = write_unanswered_ = write_uncertain_ = false;
  repeat_due_.reset();
  end_ = now + port_->request_timeout;
  step_ = Step::kWrite;
}

void MailboxHandshake::send_anew(std::uint8_t counter, Nanoseconds now) {
  begin_write(true, now);
  request_[kCounterByte] = static_cast<std::uint8_t>((request_[kCounterByte] & 0x8FU) | (counter & 7U) << 4);
}

void MailboxHandshake::send(std::span<const std::uint8_t> message, bool answered, Nanoseconds now) {
  begin_write(answered, now);
  if (message.size() > port_->send.length) return end_with(End::kTooLong);
  if (port_->receive.length < MailboxMessage::kHeaderSize) return end_with(End::kNoRoom);
  request_.assign(port_->send.length, 0);
  std::ranges::copy(message, request_.begin());
}

void MailboxHandshake::await(Nanoseconds now) {
  end_ = now + response_timeout_;
  wants_answer_ = false;  // to nothing that could be sent anew
  await_further(now);
}

void MailboxHandshake::await_further(Nanoseconds now) {
  only_fetch_ = write_uncertain_ = false;
  look_at_ = now + kLookAnyway;
  step_ = Step::kPoll;
  (void)out_of_time(now);
}

void MailboxHandshake::fetch(Nanoseconds now) {
  await(now);
  only_fetch_ = true;
  if (step_ == Step::kPoll) step_ = Step::kRead;
  if (port_->receive.length < MailboxMessage::kHeaderSize) end_with(End::kNoRoom);
}

bool MailboxHandshake::out_of_time(Nanoseconds now) {
  if (now < end_) return false;
  end_with(End::kTimeout);
  return true;
}

void MailboxHandshake::end_with(End end) {
  step_ = Step::kOver;
  end_reason_ = end;
}

Datagram* MailboxHandshake::next(Nanoseconds now) {
  const auto station = port_ != nullptr ? port_->station_address : std::uint16_t{0};
  status_.fill(0);
  switch (step_) {
    case Step::kOver:
      return nullptr;
    case Step::kWrite:
      bytes_ = request_;
      datagram_ = {Command::kFpwr, device_address(station, port_->send.start), bytes_};
      return &datagram_;
    case Step::kPoll:
      return poll(now);
    case Step::kRead:
      return read();
    case Step::kReadRepeat:
    case Step::kAwaitRepeat:
      datagram_ = {Command::kFprd, device_address(station, kSm1Activate), status_};
      return &datagram_;
    case Step::kWriteRepeat:
      datagram_ = {Command::kFpwr, device_address(station, kSm1Activate), bytes_};
      return &datagram_;
  }
  return nullptr;
}

Datagram* MailboxHandshake::poll(Nanoseconds now) {
  if (out_of_time(now)) return nullptr;
  if (repeat_due_ && now >= *repeat_due_) {
    end_with(End::kAnswerLost);
    return nullptr;
  }
  const auto full = port_->full ? port_->full() : std::nullopt;
  if (full == false && now < look_at_) return nullptr;
  if (full == true) {
    step_ = Step::kRead;
    return read();
  }
  look_at_ = now + kLookAnyway;
  datagram_ = {Command::kFprd, device_address(port_->station_address, kSm1Status), std::span(status_).first(1)};
  return &datagram_;
}

Datagram* MailboxHandshake::read() {
  bytes_.assign(port_->receive.length, 0);
  datagram_ = {Command::kFprd, device_address(port_->station_address, port_->receive.start), bytes_};
  datagram_.once = true;  // the second time it would be another message
  return &datagram_;
}

void MailboxHandshake::take(Nanoseconds now) {
  switch (step_) {
    case Step::kOver:
      return;
    case Step::kWrite:
      return take_write(now);
    case Step::kPoll:
      return take_poll(now);
    case Step::kRead:
      return take_read(now);
    case Step::kReadRepeat:
    case Step::kWriteRepeat:
    case Step::kAwaitRepeat:
      return take_repeat(now);
  }
}

void MailboxHandshake::take_write(Nanoseconds now) {
  if (!datagram_.answered) {
    write_unanswered_ = true;
    return (void)out_of_time(now);
  }
  // A mailbox that is full at a repetition holds the request, most likely: only the first answer was lost.
  const bool repeated = write_unanswered_ || datagram_.times_sent > 1;
  if (datagram_.wkc == 0 && !repeated) {
    if (!write_uncertain_) return (void)out_of_time(now);
    rewrite_at_ = now + kRewriteAfter;
    step_ = Step::kPoll;
    return;
  }
  write_unanswered_ = false;
  if (!wants_answer_) return end_with(End::kSent);
  if (!write_uncertain_) end_ = now + response_timeout_;
  write_uncertain_ = datagram_.wkc == 0;
  rewrite_at_ = now + kRewriteAfter;
  look_at_ = now + kLookAnyway;
  step_ = Step::kPoll;
}

void MailboxHandshake::take_poll(Nanoseconds now) {
  if (datagram_.wkc > 0 && (status_[0] & SyncManager::kStatusMailboxFull) != 0) {
    step_ = Step::kRead;
  } else if (!out_of_time(now) && write_uncertain_ && now >= rewrite_at_) {
    step_ = Step::kWrite;
  }
}

void MailboxHandshake::take_read(Nanoseconds now) {
  if (!datagram_.answered) {
    step_ = Step::kReadRepeat;
    return;
  }
  step_ = Step::kPoll;
  if (datagram_.wkc == 0) return only_fetch_ ? end_with(End::kEmpty) : (void)out_of_time(now);
  repeat_due_.reset();
  const auto length = load_le<std::uint16_t>(bytes_);
  if (length + MailboxMessage::kHeaderSize > bytes_.size()) return end_with(End::kMalformed);
  const auto counter = static_cast<std::uint8_t>((bytes_[kCounterByte] >> 4) & 7U);
  // A repeated message may be one that was never lost. Some slaves do not count: theirs are only doubted then.
  const bool again = counter != 0 && counter == receipt_->last;
  if (again && (read_repeated_ || receipt_->counts)) return (void)out_of_time(now);
  receipt_->counts = receipt_->last != 0 && counter != receipt_->last;
  receipt_->last = counter;
  read_repeated_ = false;
  end_with(End::kMessage);
}

void MailboxHandshake::take_repeat(Nanoseconds now) {
  if (out_of_time(now)) return;
  if (datagram_.wkc == 0) return;
  if (step_ == Step::kReadRepeat) {
    repeat_bit_ = static_cast<std::uint8_t>(~status_[0] & kRepeat);
    bytes_.assign(1, static_cast<std::uint8_t>((status_[0] & ~kRepeat) | repeat_bit_));
    repeat_end_ = now + kRepeatPatience;
    step_ = Step::kWriteRepeat;
  } else if (step_ == Step::kWriteRepeat) {
    step_ = Step::kAwaitRepeat;
  } else if ((status_[1] & kRepeat) == repeat_bit_ || now >= repeat_end_) {
    read_repeated_ = true;
    if (wants_answer_) repeat_due_ = now + kRepeatedAfter;
    look_at_ = now;
    step_ = Step::kPoll;
  }
}

}  // namespace syncline
