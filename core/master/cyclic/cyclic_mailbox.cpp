// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_mailbox.h"

#include "channels/snapshot.h"
#include "master/exchange/slave_mailbox.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kUploadRequestSize = 16;  // mailbox header, CoE header, SDO header

}  // namespace

CyclicMailbox::CyclicMailbox(Snapshot& snapshot, std::span<SlaveMailbox> mailboxes)
    : snapshot_(snapshot), mailboxes_(mailboxes) {
  for (auto& mailbox : mailboxes) {  // room for the longest
    sdo_.use(mailbox);
    fetch_.use(mailbox);
  }
  value_.reserve(kMostBytes);
}

bool CyclicMailbox::ready_for(std::size_t slave) const {
  const auto& mailbox = mailboxes_[slave];
  if (holds_ > 0 || busy_ || mailbox.taken || mailbox.reserved > 0 || mailbox.port.send.length < kUploadRequestSize)
    return false;
  if (mailbox.wanted && mailbox.own_last) return false;  // by turns, however long each takes
  const auto& status = snapshot_.slaves[slave];
  return status.present && has_mailbox_communication(al_state_of(status.al_status));
}

void CyclicMailbox::begin(std::size_t slave, coe::ObjectAddress object) {
  current_ = {};
  current_.slave = static_cast<std::uint16_t>(slave);
  current_.object = object;
  auto& mailbox = mailboxes_[slave];
  mailbox.taken = mailbox.own_last = busy_ = true;
}

void CyclicMailbox::upload(std::size_t slave, coe::ObjectAddress object) {
  begin(slave, object);
  value_.clear();
  sdo_.use(mailboxes_[slave]);
  sdo_.upload(object, false, value_, kMostBytes);
}

void CyclicMailbox::fetch(std::size_t slave) {
  begin(slave, {});
  fetch_.use(mailboxes_[slave]);
}

Datagram* CyclicMailbox::next(Nanoseconds now) { return busy_ ? work().next(now) : nullptr; }

void CyclicMailbox::take(Nanoseconds now) {
  if (busy_) work().take(now);
}

void CyclicMailbox::give_up() {
  if (!busy_ || work().over()) return;
  if (fetching()) {
    fetch_.give_up();
  } else {
    sdo_.give_up({.code = ErrorCode::kMailboxTimeout});
  }
}

std::optional<CyclicMailbox::Answer> CyclicMailbox::answer() {
  if (!busy_) return std::nullopt;
  // A slave that stays silent costs its turn, no more; one that is gone not even that.
  if (!snapshot_.slaves[current_.slave].present) give_up();
  if (!work().over()) return std::nullopt;
  busy_ = mailboxes_[current_.slave].taken = false;
  judge();
  return current_;
}

void CyclicMailbox::judge() {
  using Kind = Answer::Kind;
  current_.emergency = fetching() ? fetch_.emergency() : sdo_.emergency();
  if (fetching()) {
    current_.kind = fetch_.found() ? Kind::kFetched : Kind::kNothing;
    return;  // it may find nothing; a request has an answer
  }
  const auto& failure = sdo_.failure();
  if (!failure) {
    current_.kind = Kind::kValue;
    for (std::size_t i = value_.size(); i-- > 0;) current_.value = current_.value << 8 | value_[i];
  } else if (failure->code == ErrorCode::kSdoAbort) {
    current_.kind = Kind::kAbort;
    current_.value = static_cast<std::uint32_t>(failure->received);
  }
  auto& silences = snapshot_.slaves[current_.slave].evidence.mailbox_silences;
  silences = current_.kind == Kind::kNothing ? silences + 1 : 0;
}

}  // namespace syncline
