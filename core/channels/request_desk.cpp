// SPDX-License-Identifier: Apache-2.0
#include "channels/request_desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reasons/because.h"
#include "support/overloaded.h"

namespace syncline {
namespace {

/// 65536 indexes; far more than any description.
constexpr std::size_t kLongestList = 2 + 2 * 0x1'0000, kLongestDescription = 8U << 10;
constexpr std::size_t kEepromConfiguration = 16;  // bytes that are read to check the checksum
constexpr std::size_t kPiece = 8;                 // in which an EEPROM is read
constexpr std::size_t kEeprom = 128U << 10, kMemory = 64U << 10;
/// The slave's own words to a file that it refuses come as bytes.
constexpr std::uint32_t kLongestWords = 1500;

struct Room {
  std::size_t bytes = 0, scratch = 0;  // of the answer, of the work
};

Result<Room> up_to(std::size_t bytes, std::size_t most, Room room) {
  if (bytes <= most) return room;
  return fail(ErrorCode::kBadValue, "request",
              because("{bytes} bytes are more than the {most} that are possible", bytes, most));
}

/// kBadValue when the request is beyond its limits.
Result<Room> room_for(const SlaveRequest& request) {
  using namespace requests;
  const auto nothing = [] { return fail(ErrorCode::kBadValue, "request", because("it is about no bytes at all")); };
  return std::visit(
      Overloaded{[](const SdoRead& r) {
                   return up_to(r.limit, SdoRead::kMost, {r.limit, 0});
                 },
                 [](const SdoWrite& r) { return up_to(r.data.size(), SdoRead::kMost, {}); },
                 [](const ObjectListRead&) {
                   return Result<Room>(Room{kLongestList, 0});
                 },
                 [](const ObjectRead&) {
                   return Result<Room>(Room{kLongestDescription, 0});
                 },
                 [](const EntryRead&) {
                   return Result<Room>(Room{kLongestDescription, 0});
                 },
                 [&](const RegisterRead& r) -> Result<Room> {
                   if (r.length == 0) return nothing();
                   return up_to(r.address + std::size_t{r.length}, kMemory, {r.length, 0});
                 },
                 [&](const RegisterWrite& r) -> Result<Room> {
                   if (r.data.empty()) return nothing();
                   return up_to(r.address + r.data.size(), kMemory, {});
                 },
                 [&](const EepromRead& r) -> Result<Room> {
                   if (r.words == 0) return nothing();
                   return up_to(2 * (std::size_t{r.word} + r.words), kEeprom, {2 * std::size_t{r.words} + kPiece, 0});
                 },
                 [&](const EepromWrite& r) -> Result<Room> {
                   if (r.data.empty() || r.data.size() % 2 != 0)
                     return fail(ErrorCode::kBadValue, "request",
                                 because("an EEPROM is written in words of two bytes"));
                   return up_to(2 * std::size_t{r.word} + r.data.size(), kEeprom,
                                {0, r.data.size() + kEepromConfiguration + kPiece});
                 },
                 [](const FileRead& r) {
                   return up_to(r.limit, FileRead::kMost, {std::max(r.limit, kLongestWords), 0});
                 },
                 [](const FileWrite& r) {
                   return up_to(r.data.size(), FileRead::kMost, {kLongestWords, 0});
                 },
                 [](const StateChange&) { return Result<Room>(Room{}); },
                 [](const ErrorAcknowledge&) { return Result<Room>(Room{}); }},
      request);
}

std::optional<coe::InformationRequest> information_of(const SlaveRequest& request) {
  using namespace requests;
  using Asked = std::optional<coe::InformationRequest>;
  return std::visit(Overloaded{[](const ObjectListRead& r) { return Asked(coe::ObjectListRequest{r.list}); },
                               [](const ObjectRead& r) { return Asked(coe::ObjectDescriptionRequest{r.index}); },
                               [](const EntryRead& r) {
                                 return Asked(coe::EntryDescriptionRequest{r.index, r.sub_index, r.value_info});
                               },
                               [](const auto&) { return Asked(); }},
                    request);
}

std::string whole_subject(const RequestTicket& ticket) {
  auto what = subject_of(ticket.request);
  auto who = ticket.slave.str();
  if (who.empty()) who = "slave " + std::to_string(slave_of(ticket.request));
  return what.empty() ? who : who + ", " + what;
}

SlaveAnswer answer_of(RequestTicket& ticket) {
  SlaveAnswer answer;
  answer.id = ticket.id;
  answer.time = ticket.answered;
  if (ticket.error) {
    answer.error = std::move(ticket.error);
    return answer;
  }
  if (ticket.failure) {
    answer.error = ticket.failure->about(whole_subject(ticket));
    const bool words = ticket.failure->code == ErrorCode::kFileTransfer && !ticket.bytes.empty();
    if (words) answer.error->detail = Reason::verbatim({ticket.bytes.begin(), ticket.bytes.end()});
    return answer;
  }
  const auto asked = information_of(ticket.request);
  if (!asked) {
    answer.data = std::move(ticket.bytes);
    return answer;
  }
  auto information = coe::decode_information_response(coe::response_opcode(*asked), ticket.bytes);
  if (information) {
    answer.information = std::move(*information);
  } else {
    answer.error = Error{ErrorCode::kMailboxProtocol, whole_subject(ticket), information.error().detail};
  }
  return answer;
}

}  // namespace

Result<RequestId> RequestDesk::submit(SlaveRequest request) {
  collect();
  const auto on_their_way = std::ranges::count_if(tickets_, [](const auto& entry) { return !entry.second.answered; });
  const auto room = room_for(request);
  if (!room) return tl::unexpected(room.error());
  if (static_cast<std::size_t>(on_their_way) >= kCapacity) {
    return fail(ErrorCode::kConfiguration, "request",
                because("{count} others are on their way already; wait for one of them", kCapacity));
  }
  auto ticket = std::make_unique<RequestTicket>();
  ticket->id = ++last_;
  ticket->request = std::move(request);
  ticket->bytes.reserve(room->bytes);
  ticket->scratch.reserve(room->scratch);
  (void)to_master_.push(ticket.get());
  tickets_[last_].ticket = std::move(ticket);
  return last_;
}

void RequestDesk::collect() {
  while (const auto back = to_asker_.pop()) {
    const auto found = tickets_.find((*back)->id);
    if (found == tickets_.end()) continue;
    found->second.answered = true;
    if (found->second.forgotten) tickets_.erase(found);
  }
}

std::optional<SlaveAnswer> RequestDesk::take(RequestId id) {
  collect();
  const auto found = tickets_.find(id);
  if (found == tickets_.end() || !found->second.answered) return std::nullopt;
  auto answer = answer_of(*found->second.ticket);
  tickets_.erase(found);
  return answer;
}

std::uint32_t RequestDesk::progress(RequestId id) const {
  const auto found = tickets_.find(id);
  return found == tickets_.end() ? 0 : found->second.ticket->done.load(std::memory_order_relaxed);
}

void RequestDesk::cancel(RequestId id) {
  const auto found = tickets_.find(id);
  if (found != tickets_.end()) found->second.ticket->cancelled.store(true, std::memory_order_relaxed);
}

void RequestDesk::forget(RequestId id) {
  cancel(id);
  const auto found = tickets_.find(id);
  if (found == tickets_.end()) return;
  found->second.forgotten = true;
  if (found->second.answered) tickets_.erase(found);
}

RequestTicket* RequestDesk::pop() { return to_master_.pop().value_or(nullptr); }

void RequestDesk::answer(RequestTicket& ticket, Nanoseconds now) {
  ticket.answered = now;
  (void)to_asker_.push(&ticket);
}

}  // namespace syncline
