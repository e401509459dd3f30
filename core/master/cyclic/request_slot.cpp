// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/request_slot.h"

#include <algorithm>
#include <utility>

#include "channels/request_ticket.h"
#include "config/network_config.h"
#include "master/exchange/slave_mailbox.h"
#include "support/overloaded.h"

namespace syncline {

RequestPlace place_of(const SlaveRequest& request) {
  using namespace requests;
  const auto mailbox = [](const auto&) { return RequestPlace::kMailbox; };
  return std::visit(Overloaded{[](const RegisterRead&) { return RequestPlace::kRegisters; },
                               [](const RegisterWrite&) { return RequestPlace::kRegisters; },
                               [](const EepromRead&) { return RequestPlace::kEeprom; },
                               [](const EepromWrite&) { return RequestPlace::kEeprom; },
                               [](const StateChange&) { return RequestPlace::kState; },
                               [](const ErrorAcknowledge&) { return RequestPlace::kState; }, mailbox},
                    request);
}

RequestSlot::RequestSlot(const NetworkConfig& config, std::span<SlaveMailbox> mailboxes) : mailboxes_(mailboxes) {
  SlaveMailbox longest;  // of any slave, in any state
  const auto grow = [](MailboxChannel& channel, const MailboxChannel& other) {
    channel.length = std::max(channel.length, other.length);
  };
  for (const auto& slave : config.slaves) {
    if (!slave.mailbox) continue;
    grow(longest.port.send, slave.mailbox->send);
    grow(longest.port.receive, slave.mailbox->receive);
    if (slave.mailbox->bootstrap_send) grow(longest.port.send, *slave.mailbox->bootstrap_send);
    if (slave.mailbox->bootstrap_receive) grow(longest.port.receive, *slave.mailbox->bootstrap_receive);
  }
  sdo_.use(longest);
  foe_.use(longest);
  const auto tell = [this](std::size_t bytes) {
    if (ticket_ != nullptr) ticket_->done.store(static_cast<std::uint32_t>(bytes), std::memory_order_relaxed);
  };
  foe_.set_progress(tell);
  eeprom_.set_progress([tell](std::size_t words) { tell(2 * words); });
}

void RequestSlot::begin(RequestTicket& ticket, const SlaveAddress& address) {
  using namespace requests;
  ticket_ = &ticket;
  const auto slave = slave_of(ticket.request);
  auto& bytes = ticket.bytes;
  const auto room = bytes.capacity();
  sdo_.use(mailboxes_[slave]);
  foe_.use(mailboxes_[slave]);
  work_ = &sdo_;
  std::visit(Overloaded{[&](const SdoRead& r) { sdo_.upload(r.object, r.complete_access, bytes, r.limit); },
                        [&](const SdoWrite& r) { sdo_.download(r.object, r.complete_access, r.data); },
                        [&](const ObjectListRead& r) { sdo_.ask(coe::ObjectListRequest{r.list}, bytes, room); },
                        [&](const ObjectRead& r) { sdo_.ask(coe::ObjectDescriptionRequest{r.index}, bytes, room); },
                        [&](const EntryRead& r) {
                          sdo_.ask(coe::EntryDescriptionRequest{r.index, r.sub_index, r.value_info}, bytes, room);
                        },
                        [&](const RegisterRead& r) {
                          work_ = &registers_;
                          registers_.read(address, r.address, r.length, bytes);
                        },
                        [&](const RegisterWrite& r) {
                          work_ = &registers_;
                          registers_.write(address, r.address, r.data);
                        },
                        [&](const EepromRead& r) {
                          work_ = &eeprom_;
                          eeprom_.read(address, r.word, r.words, bytes);
                        },
                        [&](const EepromWrite& r) {
                          work_ = &eeprom_;
                          eeprom_.write(address, r.word, r.data, ticket.scratch);
                        },
                        [&](const FileRead& r) {
                          work_ = &foe_;
                          foe_.read(r.name, r.password, bytes, r.limit);
                        },
                        [&](const FileWrite& r) {
                          work_ = &foe_;
                          foe_.write(r.name, r.password, r.data);
                        },
                        [](const StateChange&) {}, [](const ErrorAcknowledge&) {}},
             ticket.request);
}

void RequestSlot::cancel() {
  constexpr BriefError kCancelled{.code = ErrorCode::kCancelled};
  if (work_ == &foe_) return foe_.cancel();
  if (work_ == &eeprom_) return eeprom_.cancel();
  give_up(kCancelled);
}

void RequestSlot::give_up(const BriefError& why) {
  if (work_ == &sdo_) sdo_.give_up(why);
  if (work_ == &foe_) foe_.give_up(why);
  if (work_ == &registers_) registers_.give_up(why);
  if (work_ == &eeprom_) eeprom_.give_up(why);
}

RequestTicket& RequestSlot::finish() {
  auto& ticket = *std::exchange(ticket_, nullptr);
  if (work_ == &sdo_) ticket.failure = sdo_.failure();
  if (work_ == &registers_) ticket.failure = registers_.failure();
  if (work_ == &eeprom_) ticket.failure = eeprom_.failure();
  if (work_ == &foe_) {
    ticket.failure = foe_.failure();
    if (ticket.failure) ticket.bytes.assign(foe_.words().begin(), foe_.words().end());
  }
  return ticket;
}

}  // namespace syncline
