// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox_transfer.h"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;
constexpr std::uint16_t kSm1Activate = kSm1Status + 1;
constexpr std::uint8_t kRepeat = 0x02;  // request in "activate", acknowledge in "PDI control"
/// A request whose fate is unknown is written again when nothing has come for so long.
constexpr Nanoseconds kRewriteAfter = 20 * kMillisecond;
/// The process image's bit may be stale (lost slave, FMMU not set): then the register is asked now and then.
constexpr Nanoseconds kLookAnyway = 20 * kMillisecond;
/// For slaves that fill the mailbox again but never acknowledge.
constexpr Nanoseconds kRepeatPatience = 50 * kMillisecond;

}  // namespace

MailboxPort mailbox_port(const SlaveConfig& slave) {
  MailboxPort port;
  port.name = slave.name;
  port.station_address = slave.station_address;
  if (!slave.mailbox) return port;
  port.send = slave.mailbox->send;
  port.receive = slave.mailbox->receive;
  return port;
}

void MailboxTransfer::begin(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered) {
  counter_ = next_mailbox_counter(counter_);
  MailboxMessage message;
  message.type = type;
  message.counter = counter_;
  message.data.assign(data.begin(), data.end());
  request_ = message.encode(port_.send.length);
  wants_answer_ = answered;
  write_uncertain_ = false;
  end_ = now + port_.request_timeout;
  step_ = Step::kWrite;
  if (request_.size() > port_.send.length) {
    end_with(fail(ErrorCode::kMailboxProtocol, port_.name, "the request is longer than the mailbox"));
  } else if (port_.receive.length < MailboxMessage::kHeaderSize) {
    end_with(fail(ErrorCode::kMailboxProtocol, port_.name, "its mailbox holds no message"));
  }
}

void MailboxTransfer::send(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) {
  begin(type, data, now, true);
}

void MailboxTransfer::send_only(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) {
  begin(type, data, now, false);
}

void MailboxTransfer::await(Nanoseconds now) {
  end_ = now + port_.response_timeout;
  await_further(now);
}

void MailboxTransfer::await_further(Nanoseconds now) {
  write_uncertain_ = false;
  look_at_ = now;
  step_ = Step::kPoll;
  (void)out_of_time(now);
}

bool MailboxTransfer::out_of_time(Nanoseconds now) {
  if (now < end_) return false;
  end_with(fail(ErrorCode::kMailboxTimeout, port_.name));
  return true;
}

void MailboxTransfer::end_with(Result<MailboxMessage> result) {
  step_ = Step::kOver;
  result_ = std::move(result);
}

Datagram* MailboxTransfer::next(Nanoseconds now) {
  const auto station = port_.station_address;
  status_.fill(0);
  switch (step_) {
    case Step::kOver:
      return nullptr;
    case Step::kWrite:
      bytes_ = request_;
      datagram_ = {Command::kFpwr, device_address(station, port_.send.start), bytes_};
      return &datagram_;
    case Step::kPoll: {
      if (out_of_time(now)) return nullptr;
      const auto full = port_.full ? port_.full() : std::nullopt;
      if (full == false && now < look_at_) return nullptr;
      if (full != true) {
        look_at_ = now + kLookAnyway;
        datagram_ = {Command::kFprd, device_address(station, kSm1Status), std::span(status_).first(1)};
        return &datagram_;
      }
      step_ = Step::kRead;
      [[fallthrough]];
    }
    case Step::kRead:
      bytes_.assign(port_.receive.length, 0);
      datagram_ = {Command::kFprd, device_address(station, port_.receive.start), bytes_};
      datagram_.once = true;  // the second time it would be another message
      return &datagram_;
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

void MailboxTransfer::take(Nanoseconds now) {
  switch (step_) {
    case Step::kOver: return;
    case Step::kWrite: return take_write(now);
    case Step::kPoll: return take_poll(now);
    case Step::kRead: return take_read(now);
    case Step::kReadRepeat:
    case Step::kWriteRepeat:
    case Step::kAwaitRepeat: return take_repeat(now);
  }
}

void MailboxTransfer::take_write(Nanoseconds now) {
  // A mailbox that is full at a repetition holds the request, most likely: only the first answer was lost.
  const bool repeated = datagram_.times_sent > 1;
  if (datagram_.wkc == 0 && !repeated) {
    if (!write_uncertain_) return (void)out_of_time(now);
    rewrite_at_ = now + kRewriteAfter;
    step_ = Step::kPoll;
    return;
  }
  if (!wants_answer_) return end_with(MailboxMessage{});
  if (!write_uncertain_) end_ = now + port_.response_timeout;
  write_uncertain_ = datagram_.wkc == 0;
  rewrite_at_ = now + kRewriteAfter;
  look_at_ = now;
  step_ = Step::kPoll;
}

void MailboxTransfer::take_poll(Nanoseconds now) {
  if (datagram_.wkc > 0 && (status_[0] & SyncManager::kStatusMailboxFull) != 0) {
    step_ = Step::kRead;
  } else if (!out_of_time(now) && write_uncertain_ && now >= rewrite_at_) {
    step_ = Step::kWrite;
  }
}

void MailboxTransfer::take_read(Nanoseconds now) {
  if (!datagram_.answered) {
    step_ = Step::kReadRepeat;
    return;
  }
  step_ = Step::kPoll;
  if (datagram_.wkc == 0) return (void)out_of_time(now);
  auto message = MailboxMessage::decode(bytes_);
  if (!message) {
    message.error().code = ErrorCode::kMailboxProtocol;
    message.error().subject = port_.name;
    return end_with(std::move(message));
  }
  // A repeated message may be one that was never lost. Some slaves do not count: theirs are only doubted then.
  const bool again = message->counter != 0 && message->counter == last_received_;
  if (again && (read_repeated_ || slave_counts_)) return (void)out_of_time(now);
  slave_counts_ = last_received_ != 0 && message->counter != last_received_;
  read_repeated_ = false;
  last_received_ = message->counter;
  end_with(std::move(message));
}

void MailboxTransfer::take_repeat(Nanoseconds now) {
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
    look_at_ = now;
    step_ = Step::kPoll;
  }
}

}  // namespace syncline
