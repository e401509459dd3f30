// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/foe_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "protocol/foe.h"
#include "support/text_bytes.h"

namespace syncline {
namespace {

/// Flash memory is slow, but not for ever.
constexpr Nanoseconds kBusyPause = 20 * kMillisecond;
constexpr Nanoseconds kBusyPatience = 60 * kSecond;
constexpr int kMostDuplicates = 64;

}  // namespace

void FoeWork::use(SlaveMailbox& mailbox) {
  transfer_.use(mailbox);
  message_.reserve(mailbox.port.send.length);
  words_.reserve(mailbox.port.receive.length);
  step_ = Step::kOver;
}

void FoeWork::begin(bool writes, std::string_view name, std::uint32_t password) {
  step_ = Step::kBegin;
  writes_ = writes;
  cancelled_ = last_sent_ = false;
  name_ = name;
  password_ = password;
  packet_no_ = writes ? 0 : 1;
  duplicates_ = 0;
  words_.clear();
  failure_.reset();
}

void FoeWork::read(std::string_view name, std::uint32_t password, std::vector<std::uint8_t>& into, std::size_t limit) {
  begin(false, name, password);
  into_ = &into;
  begin_ = into.size();
  limit_ = limit;
}

void FoeWork::write(std::string_view name, std::uint32_t password, std::span<const std::uint8_t> file) {
  begin(true, name, password);
  file_ = file;
  sent_ = 0;
}

void FoeWork::cancel() { cancelled_ = !over(); }

void FoeWork::give_up(const BriefError& why) {
  transfer_.give_up();
  fail_with(why);
}

std::string FoeWork::subject() const {
  return fmt::format("{}, file \"{}\"", transfer_.mailbox() == nullptr ? "" : transfer_.mailbox()->port.name, name_);
}

Status FoeWork::result() const {
  if (!failure_) return {};
  auto error = failure_->about(subject());
  if (!words_.empty()) error.detail = Reason::verbatim({words_.begin(), words_.end()});
  return fail(std::move(error));
}

void FoeWork::fail_with(const BriefError& why) {
  step_ = Step::kOver;
  failure_ = why;
}

void FoeWork::refuse(std::uint32_t code, const BriefError& why, Nanoseconds now) {
  failure_ = why;
  step_ = Step::kError;
  message_.clear();
  append(message_, foe::MessageView{foe::OpCode::kError, code, {}});
  transfer_.tell(MailboxType::kFoe, message_, now);
}

void FoeWork::send(const foe::MessageView& message, Nanoseconds now) {
  step_ = Step::kPacket;
  message_.clear();
  append(message_, message);
  transfer_.ask(MailboxType::kFoe, message_, now);
}

void FoeWork::send_again(Nanoseconds now) {
  step_ = Step::kPacket;
  transfer_.ask(MailboxType::kFoe, message_, now);
}

Datagram* FoeWork::next(Nanoseconds now) {
  if (step_ == Step::kBegin) {
    busy_until_ = now + kBusyPatience;
    const auto code = writes_ ? foe::OpCode::kWrite : foe::OpCode::kRead;
    if (foe::data_capacity(transfer_.mailbox()->port.send.length) == 0) {
      fail_with(protocol_error("the mailbox holds no data"));
    } else {
      send({code, password_, bytes_of(name_)}, now);
    }
  } else if (step_ == Step::kPause && cancelled_) {
    go_on(now);
  } else if (step_ == Step::kPause && now >= not_before_) {
    send_again(now);
  }
  auto* datagram = over() || step_ == Step::kPause ? nullptr : transfer_.next(now);
  go_on(now);
  return over() ? nullptr : datagram;
}

void FoeWork::take(Nanoseconds now) {
  transfer_.take(now);
  go_on(now);
}

void FoeWork::go_on(Nanoseconds now) {
  while (!over() && step_ != Step::kBegin && transfer_.over()) {
    const bool was_answered = step_ == Step::kPacket || step_ == Step::kPause;
    if (step_ == Step::kError) {
      step_ = Step::kOver;  // whether it arrived or not
    } else if (cancelled_ && was_answered) {
      refuse(foe::error::kNotDefined, {.code = ErrorCode::kCancelled}, now);
    } else if (step_ == Step::kPause) {
      return;
    } else if (transfer_.failure()) {
      fail_with(*transfer_.failure());
    } else if (step_ == Step::kLastAck) {
      step_ = Step::kOver;
    } else {
      take_answer(now);
    }
  }
}

void FoeWork::take_answer(Nanoseconds now) {
  const auto message = foe::view(transfer_.data());
  if (!message) {
    auto failure = message.error();
    failure.code = ErrorCode::kMailboxProtocol;
    return fail_with(failure);
  }
  switch (message->code) {
    case foe::OpCode::kError: {
      const auto end = std::ranges::find(message->rest, std::uint8_t{0});
      words_.assign(message->rest.begin(), end);
      return fail_with({.code = ErrorCode::kFileTransfer, .received = message->value});
    }
    case foe::OpCode::kBusy:
      return take_busy(now);
    case foe::OpCode::kData:
      if (!writes_) return take_data(*message, now);
      break;
    case foe::OpCode::kAck:
      if (writes_) return take_ack(*message, now);
      break;
    case foe::OpCode::kRead:
    case foe::OpCode::kWrite:
      break;
  }
  refuse(foe::error::kIllegal,
         writes_ ? protocol_error("no acknowledgement where one was to come")
                 : protocol_error("no data where data were asked for"),
         now);
}

/// The same packet once more, later.
void FoeWork::take_busy(Nanoseconds now) {
  if (now >= busy_until_) return refuse(foe::error::kNotDefined, protocol_error("busy without end"), now);
  not_before_ = now + kBusyPause;
  step_ = Step::kPause;
}

void FoeWork::take_data(const foe::MessageView& packet, Nanoseconds now) {
  // A packet again: its acknowledgement did not arrive.
  if (packet.value + 1 == packet_no_ && packet_no_ > 1 && ++duplicates_ < kMostDuplicates) return send_again(now);
  if (packet.value != packet_no_) {
    return refuse(foe::error::kPacketNumber,
                  protocol_error("packet {number} where {expected} was to come", packet.value, packet_no_), now);
  }
  if (into_->size() - begin_ + packet.rest.size() > limit_) {
    return refuse(foe::error::kDiskFull,
                  protocol_error("the file is longer than the {bytes} bytes that are taken", limit_), now);
  }
  const auto size = packet.rest.size();
  into_->insert(into_->end(), packet.rest.begin(), packet.rest.end());
  if (progress_) progress_(into_->size() - begin_);
  busy_until_ = now + kBusyPatience;
  duplicates_ = 0;
  const foe::MessageView ack{foe::OpCode::kAck, packet_no_++, {}};
  if (size >= foe::data_capacity(transfer_.mailbox()->port.receive.length)) return send(ack, now);
  step_ = Step::kLastAck;
  message_.clear();
  append(message_, ack);
  transfer_.tell(MailboxType::kFoe, message_, now);
}

void FoeWork::take_ack(const foe::MessageView& ack, Nanoseconds now) {
  if (ack.value != packet_no_) {
    // The acknowledgement before, twice: the one that counts is still to come.
    if (ack.value + 1 == packet_no_ && ++duplicates_ < kMostDuplicates) return transfer_.receive_instead(now);
    return refuse(foe::error::kPacketNumber,
                  protocol_error("packet {number} acknowledged where {expected} was sent", ack.value, packet_no_), now);
  }
  if (packet_no_ > 0 && progress_) progress_(sent_);
  if (last_sent_) {
    step_ = Step::kOver;
    return;
  }
  send_packet(now);
}

/// A file that fills its last packet is ended by an empty one.
void FoeWork::send_packet(Nanoseconds now) {
  const auto full = foe::data_capacity(transfer_.mailbox()->port.send.length);
  const auto part = file_.subspan(sent_, std::min(full, file_.size() - sent_));
  sent_ += part.size();
  last_sent_ = part.size() < full;
  duplicates_ = 0;
  busy_until_ = now + kBusyPatience;
  send({foe::OpCode::kData, ++packet_no_, part}, now);
}

}  // namespace syncline
