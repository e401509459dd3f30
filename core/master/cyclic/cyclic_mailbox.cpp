// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_mailbox.h"

#include <algorithm>
#include <array>

#include "protocol/mailbox.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kUploadRequestSize = 16;  // mailbox header, CoE header, SDO header
constexpr std::uint8_t kUploadCommand = 0x40;
constexpr std::uint8_t kUploadResponse = 2;  // specifier, bits 7..5
constexpr std::uint8_t kAbort = 4;

}  // namespace

CyclicMailbox::CyclicMailbox(RunState& run) : run_(run), receipts_(run.config().slaves.size()) {
  for (std::size_t i = 0; i < receipts_.size(); ++i) ports_.push_back(run.port_of(i));
  for (std::size_t i = 0; i < receipts_.size(); ++i) handshake_.use(ports_[i], receipts_[i]);  // room for the longest
}

bool CyclicMailbox::ready_for(std::size_t slave) const {
  if (!enabled_ || busy_ || ports_[slave].send.length < kUploadRequestSize) return false;
  const auto& status = run_.snapshot.slaves[slave];
  const auto state = al_state_of(status.al_status);
  return status.present && (state == AlState::kPreop || state == AlState::kSafeop || state == AlState::kOp);
}

void CyclicMailbox::upload(std::size_t slave, coe::ObjectAddress object, Nanoseconds now) {
  auto& counter = run_.mailbox_counters[slave];
  counter = next_mailbox_counter(counter);
  std::array<std::uint8_t, kUploadRequestSize> bytes{};
  const std::span<std::uint8_t> view(bytes);
  store_le<std::uint16_t>(view, kUploadRequestSize - MailboxMessage::kHeaderSize);
  bytes[5] = static_cast<std::uint8_t>(static_cast<unsigned>(MailboxType::kCoe) | (counter << 4));
  store_le(view.subspan(6), static_cast<std::uint16_t>(static_cast<unsigned>(coe::Service::kSdoRequest) << 12));
  bytes[8] = kUploadCommand;
  store_le(view.subspan(9), object.index);
  bytes[11] = object.sub_index;
  handshake_.use(ports_[slave], receipts_[slave]);
  handshake_.send(bytes, true, now);
  current_ = {};
  current_.slave = static_cast<std::uint16_t>(slave);
  current_.object = object;
  busy_ = true;
}

void CyclicMailbox::fetch(std::size_t slave, Nanoseconds now) {
  handshake_.use(ports_[slave], receipts_[slave]);
  handshake_.fetch(now);
  current_ = {};
  current_.slave = static_cast<std::uint16_t>(slave);
  busy_ = true;
}

void CyclicMailbox::add_to(PendingFrame& frame, Nanoseconds now) {
  asked_ = false;
  if (!busy_) return;
  auto* datagram = handshake_.next(now);
  asked_ = datagram != nullptr && frame.add(*datagram);
}

std::optional<CyclicMailbox::Answer> CyclicMailbox::take(Nanoseconds now) {
  if (!busy_) return std::nullopt;
  if (asked_) handshake_.take(now);
  asked_ = false;
  // A slave that stays silent costs its turn, no more; one that is gone not even that.
  if (!run_.snapshot.slaves[current_.slave].present) handshake_.give_up();
  return handshake_.over() ? finish(now) : std::nullopt;
}

std::optional<CyclicMailbox::Answer> CyclicMailbox::finish(Nanoseconds now) {
  run_.mailbox_full[current_.slave].reset();  // what the last cycle said is over
  if (handshake_.end() != MailboxHandshake::End::kMessage) return over(Answer::Kind::kNothing);
  auto answer = take_message(now);
  if (answer) return answer;
  handshake_.await_further(now);
  return handshake_.over() ? std::optional(over(Answer::Kind::kNothing)) : std::nullopt;
}

CyclicMailbox::Answer CyclicMailbox::over(Answer::Kind kind, std::uint32_t value) {
  busy_ = false;
  // A fetch may find nothing; a request has an answer.
  auto& silences = run_.snapshot.slaves[current_.slave].evidence.mailbox_silences;
  if (current_.object.index != 0) silences = kind == Answer::Kind::kNothing ? silences + 1 : 0;
  current_.kind = kind;
  current_.value = value;
  return current_;
}

/// Nothing when the message was not what is waited for.
std::optional<CyclicMailbox::Answer> CyclicMailbox::take_message(Nanoseconds now) {
  const bool fetching = current_.object.index == 0;
  ByteReader reader(handshake_.message());
  reader.skip(5);
  const auto type = static_cast<MailboxType>(reader.u8() & 0x0F);
  const auto service = static_cast<coe::Service>(reader.u16() >> 12);
  if (!reader.ok()) return over(Answer::Kind::kNothing);
  if (type == MailboxType::kCoe && service == coe::Service::kEmergency) {
    coe::Emergency emergency;
    emergency.error_code = reader.u16();
    emergency.error_register = reader.u8();
    for (auto& byte : emergency.data) byte = reader.u8();
    if (reader.ok()) run_.emergency(current_.slave, emergency, now);
    current_.emergency = true;
  }
  if (fetching) return over(Answer::Kind::kFetched);
  if (type == MailboxType::kError) return over(Answer::Kind::kNothing);
  // Aborts come as requests in either direction.
  const bool sdo = service == coe::Service::kSdoResponse || service == coe::Service::kSdoRequest;
  if (type != MailboxType::kCoe || !sdo) return std::nullopt;
  const auto command = reader.u8();
  coe::ObjectAddress object;
  object.index = reader.u16();
  object.sub_index = reader.u8();
  const auto value = reader.u32();
  if (!reader.ok() || object != current_.object) return std::nullopt;  // an answer to a question that was given up
  const auto specifier = static_cast<std::uint8_t>(command >> 5);
  if (specifier == kAbort) return over(Answer::Kind::kAbort, value);
  if (specifier != kUploadResponse || (command & 0x02) == 0) return over(Answer::Kind::kNothing);
  const unsigned unused = (command & 0x01) != 0 ? (command >> 2) & 3U : 0U;
  return over(Answer::Kind::kValue, value & (0xFFFF'FFFFU >> (8 * unused)));
}

}  // namespace syncline
