// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "channels/request_desk.h"
#include "channels/request_ticket.h"
#include "channels/snapshot.h"
#include "master/cyclic/request_slot.h"
#include "master/exchange/slave_mailbox.h"

namespace syncline {

class Bus;
struct MasterChannels;
struct NetworkConfig;

/// The requests of those outside (MasterChannels::requests): takes them from the desk, begins each when its mailbox or
/// EEPROM is free, in their order, and gives the bus one datagram of one of them at a time, in turn. Requests for
/// states wait for whoever leads the slaves. Allocates at construction alone.
class AcyclicRequests {
 public:
  /// So many are under way at once, each with another slave or another part of it.
  static constexpr std::size_t kSlots = 8;

  AcyclicRequests(const NetworkConfig& config, const Snapshot& snapshot, std::span<SlaveMailbox> mailboxes,
                  RequestDesk& desk);
  // What could throw there would be a fault of this class, with which no run may go on.
  // NOLINTNEXTLINE(bugprone-exception-escape)
  ~AcyclicRequests() { end_all({.code = ErrorCode::kCancelled}, snapshot_.time); }
  AcyclicRequests(const AcyclicRequests&) = delete;
  AcyclicRequests& operator=(const AcyclicRequests&) = delete;

  /// Of one of them, whose turn it is; null when nobody has one. Once a round.
  Datagram* next(Nanoseconds now);
  /// After the datagram was sent; answered or not.
  void take(Nanoseconds now);
  /// At the end of each round: answers what is over.
  void settle(Nanoseconds now);
  /// The one whose datagram next() gave cannot be carried out.
  void refuse_asked(const BriefError& why);
  /// Where a slave stands on the bus, for the time before it has its station address. As configured without.
  void set_positions(std::function<std::uint16_t(std::size_t slave)> positions) { positions_ = std::move(positions); }
  /// Without bus cycles: one datagram. False when there was none. Registers and EEPROMs are found by position then.
  Result<bool> run_round(Bus& bus);

  /// The oldest request for a state; answer() ends it.
  [[nodiscard]] RequestTicket* state_request();
  void answer(RequestTicket& ticket, Nanoseconds now) { desk_.answer(ticket, now); }

  /// File transfers end, because somebody wants the mailboxes.
  void cancel_files();
  /// Everything that is under way in mailboxes ends at once: nobody knows what becomes of the slaves.
  void give_up_mailboxes();
  /// Those that wait end at once, those under way in their order (a written EEPROM is put back, a file's slave is
  /// told).
  void cancel_all(const BriefError& why, Nanoseconds now);
  /// Something is under way.
  [[nodiscard]] bool busy() const;
  /// All requests end at once.
  void end_all(const BriefError& why, Nanoseconds now);

 private:
  void accept(Nanoseconds now);
  void begin_ready(Nanoseconds now);
  void cancel_unwanted(Nanoseconds now);
  bool begin(RequestTicket& ticket, Nanoseconds now);
  void remove(std::size_t place);
  void end_waiting(const BriefError& why, Nanoseconds now);
  [[nodiscard]] RequestSlot* free_slot();
  [[nodiscard]] std::optional<BriefError> refusal(const RequestTicket& ticket) const;
  [[nodiscard]] std::optional<BriefError> mailbox_refusal(const RequestTicket& ticket) const;
  void set_taken(const RequestTicket& ticket, bool taken);
  [[nodiscard]] SlaveAddress address_of(std::size_t slave) const;

  const NetworkConfig& config_;
  const Snapshot& snapshot_;
  std::span<SlaveMailbox> mailboxes_;
  RequestDesk& desk_;
  std::array<std::unique_ptr<RequestSlot>, kSlots> slots_;
  std::vector<RequestTicket*> waiting_;  // in their order; room for all
  std::vector<bool> eeprom_taken_;       // per slave
  std::vector<SharedText> names_;
  std::function<std::uint16_t(std::size_t)> positions_;
  bool by_position_ = false, any_wanted_ = false;
  std::size_t turn_ = 0;
  RequestSlot* asked_ = nullptr;
};

/// Ends all requests that wait while no configuration runs, and none was sent before them.
void refuse_requests(MasterChannels& channels, Nanoseconds now);

}  // namespace syncline
