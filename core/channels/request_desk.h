// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "channels/bounded_queue.h"
#include "channels/request_ticket.h"
#include "support/result.h"

namespace syncline {

/// What became of a request.
struct SlaveAnswer {
  RequestId id = 0;
  std::vector<std::uint8_t> data{};                       // of reads: object, registers, words, file
  std::optional<coe::InformationResponse> information{};  // of ObjectListRead, ObjectRead, EntryRead
  std::optional<Error> error{};  // kSdoAbort with the code, kCancelled when nobody wants it ...
  Nanoseconds time = 0;          // host clock of its end
};

/// Requests on single slaves, each with an answer: ask with submit(), look for the answer with take() on a later tick.
/// They are carried out beside the bus cycle, in their order for each mailbox and side by side for different slaves;
/// the cycle gets at most one datagram longer. Two threads: the onlookers' and the master's; neither waits for the
/// other.
class RequestDesk {
 public:
  static constexpr std::size_t kCapacity = 64;

  RequestDesk() : to_master_(kCapacity), to_asker_(kCapacity) {}

  // ---- the onlookers' thread
  /// kBadValue when the request is beyond its limits, kConfiguration when kCapacity are on their way already.
  [[nodiscard]] Result<RequestId> submit(SlaveRequest request);
  /// The answer, once; nothing as long as the request is on its way, and for ids that nobody waits for.
  std::optional<SlaveAnswer> take(RequestId id);
  /// How many bytes have been transferred so far, of long ones.
  [[nodiscard]] std::uint32_t progress(RequestId id) const;
  /// Its answer will be kCancelled, unless it comes to its end before.
  void cancel(RequestId id);
  /// Nobody wants the answer any more.
  void forget(RequestId id);
  /// On their way, or answered and not taken.
  [[nodiscard]] std::size_t open() const { return tickets_.size(); }

  // ---- the master's thread
  /// The next request; it stays here and goes back by answer().
  RequestTicket* pop();
  void answer(RequestTicket& ticket, Nanoseconds now);
  [[nodiscard]] bool empty() const { return to_master_.empty(); }

 private:
  struct Kept {
    std::unique_ptr<RequestTicket> ticket;
    bool answered = false, forgotten = false;
  };
  void collect();

  // Neither queue can overflow: no more than kCapacity tickets are on their way.
  BoundedQueue<RequestTicket*> to_master_, to_asker_;
  std::map<RequestId, Kept> tickets_;
  RequestId last_ = 0;
};

}  // namespace syncline
