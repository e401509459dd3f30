// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/acyclic_requests.h"

#include <algorithm>
#include <utility>

#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_mailbox.h"
#include "master/exchange/slave_name.h"
#include "reasons/brief_reason.h"

namespace syncline {
namespace {

constexpr BriefError kGone{.code = ErrorCode::kNoResponse, .why = brief("the slave does not answer{which}")};

bool is_file(const SlaveRequest& request) {
  return std::holds_alternative<requests::FileRead>(request) || std::holds_alternative<requests::FileWrite>(request);
}

}  // namespace

void refuse_requests(MasterChannels& channels, Nanoseconds now) {
  // In this order: a command that was sent in front of a request is seen with it.
  while (!channels.requests.empty() && channels.commands.empty()) {
    auto* ticket = channels.requests.pop();
    if (ticket == nullptr) return;
    ticket->failure =
        BriefError{.code = ErrorCode::kConfiguration, .why = brief("the bus is offline; go online first")};
    channels.requests.answer(*ticket, now);
  }
}

AcyclicRequests::AcyclicRequests(const NetworkConfig& config, const Snapshot& snapshot,
                                 std::span<SlaveMailbox> mailboxes, RequestDesk& desk)
    : config_(config), snapshot_(snapshot), mailboxes_(mailboxes), desk_(desk), eeprom_taken_(config.slaves.size()) {
  for (auto& slot : slots_) slot = std::make_unique<RequestSlot>(config, mailboxes);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) names_.emplace_back(slave_name(config, i));
  waiting_.reserve(RequestDesk::kCapacity);
}

// ---- taking on ----------------------------------------------------------------------------------

void AcyclicRequests::accept(Nanoseconds now) {
  while (auto* ticket = desk_.pop()) {
    const auto slave = slave_of(ticket->request);
    if (slave >= names_.size()) {
      ticket->failure = BriefError{.code = ErrorCode::kConfiguration,
                                   .why = brief("the configuration has only {count} slaves", names_.size())};
      desk_.answer(*ticket, now);
      continue;
    }
    ticket->slave = names_[slave];
    waiting_.push_back(ticket);
  }
}

void AcyclicRequests::remove(std::size_t place) {
  waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(place));
}

RequestSlot* AcyclicRequests::free_slot() {
  const auto found = std::ranges::find_if(slots_, [](const auto& slot) { return slot->ticket() == nullptr; });
  return found == slots_.end() ? nullptr : found->get();
}

/// Why it can never be carried out as things are.
std::optional<BriefError> AcyclicRequests::refusal(const RequestTicket& ticket) const {
  if (!snapshot_.slaves[slave_of(ticket.request)].present) return kGone;
  return place_of(ticket.request) == RequestPlace::kMailbox ? mailbox_refusal(ticket) : std::nullopt;
}

std::optional<BriefError> AcyclicRequests::mailbox_refusal(const RequestTicket& ticket) const {
  const auto slave = slave_of(ticket.request);
  const auto& mailbox = config_.slaves[slave].mailbox;
  const bool file = is_file(ticket.request);
  const auto none = [](BriefReason why) { return BriefError{.code = ErrorCode::kNotSupported, .why = why}; };
  if (!mailbox) return none(brief("it has no mailbox"));
  if (!file && !mailbox->coe) return none(brief("it does not speak CoE"));
  const auto state = al_state_of(snapshot_.slaves[slave].al_status);
  if (has_mailbox_communication(state) || (file && state == AlState::kBoot)) return std::nullopt;
  auto why = none(brief("its mailbox works from PREOP on, and it is in {state}; lead it there first"));
  why.why.word = al_state_name(state);
  return why;
}

void AcyclicRequests::set_taken(const RequestTicket& ticket, bool taken) {
  const auto slave = slave_of(ticket.request);
  if (place_of(ticket.request) == RequestPlace::kMailbox) {
    mailboxes_[slave].taken = taken;
    mailboxes_[slave].own_last = false;
  }
  if (place_of(ticket.request) == RequestPlace::kEeprom) eeprom_taken_[slave] = taken;
}

SlaveAddress AcyclicRequests::address_of(std::size_t slave) const {
  if (!by_position_) return SlaveAddress::at_station(config_.slaves[slave].station_address);
  return SlaveAddress::at_position(positions_ ? positions_(slave) : static_cast<std::uint16_t>(slave));
}

/// False when its turn has not come.
bool AcyclicRequests::begin(RequestTicket& ticket, Nanoseconds now) {
  const auto place = place_of(ticket.request);
  const auto slave = slave_of(ticket.request);
  auto& mailbox = mailboxes_[slave];
  // Whom the state machine leads just now gets his mailbox, or has it in another place.
  if (place == RequestPlace::kState || (place == RequestPlace::kMailbox && mailbox.reserved > 0)) return false;
  if (const auto why = refusal(ticket)) {
    ticket.failure = why;
    desk_.answer(ticket, now);
    return true;
  }
  if (place == RequestPlace::kMailbox && mailbox.taken) {
    mailbox.wanted = any_wanted_ = true;
    return false;
  }
  if (place == RequestPlace::kEeprom && eeprom_taken_[slave]) return false;
  auto* slot = free_slot();
  if (slot == nullptr) return false;
  slot->begin(ticket, address_of(slave));
  set_taken(ticket, true);
  return true;
}

void AcyclicRequests::begin_ready(Nanoseconds now) {
  if (std::exchange(any_wanted_, false)) {
    for (auto& mailbox : mailboxes_) mailbox.wanted = false;
  }
  for (std::size_t i = 0; i < waiting_.size();) {
    if (begin(*waiting_[i], now)) {
      remove(i);
    } else {
      ++i;
    }
  }
}

void AcyclicRequests::cancel_unwanted(Nanoseconds now) {
  const auto unwanted = [](const RequestTicket& ticket) { return ticket.cancelled.load(std::memory_order_relaxed); };
  for (std::size_t i = 0; i < waiting_.size();) {
    auto& ticket = *waiting_[i];
    if (!unwanted(ticket)) {
      ++i;
      continue;
    }
    remove(i);
    ticket.failure = BriefError{.code = ErrorCode::kCancelled};
    desk_.answer(ticket, now);
  }
  for (auto& slot : slots_) {
    if (slot->ticket() != nullptr && unwanted(*slot->ticket())) slot->cancel();
  }
}

// ---- rounds -------------------------------------------------------------------------------------

Datagram* AcyclicRequests::next(Nanoseconds now) {
  asked_ = nullptr;
  if (!desk_.empty()) accept(now);
  cancel_unwanted(now);
  begin_ready(now);
  for (std::size_t n = 0; n < kSlots; ++n) {
    auto& slot = *slots_[(turn_ + n) % kSlots];
    if (slot.ticket() == nullptr) continue;
    auto* datagram = slot.work().next(now);
    if (datagram == nullptr) continue;
    asked_ = &slot;
    return datagram;
  }
  return nullptr;
}

void AcyclicRequests::take(Nanoseconds now) {
  if (asked_ == nullptr) return;
  const auto place = std::ranges::find_if(slots_, [this](const auto& slot) { return slot.get() == asked_; });
  turn_ = static_cast<std::size_t>(place - slots_.begin() + 1) % kSlots;
  asked_->work().take(now);
  asked_ = nullptr;
}

void AcyclicRequests::settle(Nanoseconds now) {
  for (auto& slot : slots_) {
    if (slot->ticket() == nullptr) continue;
    const auto slave = slave_of(slot->ticket()->request);
    if (!slot->work().over() && !snapshot_.slaves[slave].present) slot->give_up(kGone);
    if (!slot->work().over()) continue;
    auto& ticket = slot->finish();
    set_taken(ticket, false);
    desk_.answer(ticket, now);
  }
}

void AcyclicRequests::refuse_asked(const BriefError& why) {
  if (asked_ != nullptr) asked_->give_up(why);
  asked_ = nullptr;
}

Result<bool> AcyclicRequests::run_round(Bus& bus) {
  by_position_ = true;
  auto* datagram = next(bus.clock().now());
  by_position_ = false;
  if (datagram != nullptr) {
    auto copy = *datagram;
    if (auto status = bus.transact(copy); !status) {
      refuse_asked({.code = status.error().code, .why = brief("no frame comes back")});
      settle(bus.clock().now());
      return tl::unexpected(status.error());
    }
    datagram->wkc = copy.wkc;
    datagram->answered = copy.answered;
    datagram->times_sent = copy.times_sent;
    take(bus.clock().now());
  }
  settle(bus.clock().now());
  return datagram != nullptr;
}

RequestTicket* AcyclicRequests::state_request() {
  const auto found = std::ranges::find_if(
      waiting_, [](const auto* ticket) { return place_of(ticket->request) == RequestPlace::kState; });
  if (found == waiting_.end()) return nullptr;
  auto* ticket = *found;
  waiting_.erase(found);
  return ticket;
}

// ---- ends ---------------------------------------------------------------------------------------

void AcyclicRequests::cancel_files() {
  for (auto& slot : slots_) {
    if (slot->ticket() != nullptr && is_file(slot->ticket()->request)) slot->cancel();
  }
}

void AcyclicRequests::give_up_mailboxes() {
  constexpr BriefError kAgain{.code = ErrorCode::kCancelled, .why = brief("the bus is brought up again")};
  for (auto& slot : slots_) {
    if (slot->ticket() != nullptr && place_of(slot->ticket()->request) == RequestPlace::kMailbox) slot->give_up(kAgain);
  }
}

void AcyclicRequests::cancel_all(const BriefError& why, Nanoseconds now) {
  accept(now);
  for (auto& slot : slots_) {
    if (slot->ticket() != nullptr) slot->cancel();
  }
  end_waiting(why, now);
}

bool AcyclicRequests::busy() const {
  return std::ranges::any_of(slots_, [](const auto& slot) { return slot->ticket() != nullptr; });
}

void AcyclicRequests::end_waiting(const BriefError& why, Nanoseconds now) {
  for (auto* ticket : waiting_) {
    ticket->failure = why;
    desk_.answer(*ticket, now);
  }
  waiting_.clear();
}

void AcyclicRequests::end_all(const BriefError& why, Nanoseconds now) {
  accept(now);
  for (auto& slot : slots_) {
    if (slot->ticket() != nullptr) slot->give_up(why);
  }
  settle(now);
  end_waiting(why, now);
}

}  // namespace syncline
