// SPDX-License-Identifier: Apache-2.0
#include "master/startup/slave_visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "master/sii/sii_access.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::uint32_t kBootstrapMailboxWord = 0x14, kMailboxWord = 0x18;
constexpr std::uint8_t kMailboxRead = 0x22, kMailboxWrite = 0x26;  // SyncManager control, with interrupt to the PDI
constexpr std::uint8_t kEnabled = 1;
constexpr std::uint16_t kFirstStation = 0x1001, kLastStation = 0xFFFE;

/// ESI defaults.
Nanoseconds patience(AlState target) {
  switch (target) {
    case AlState::kInit:
      return 5 * kSecond;
    case AlState::kPreop:
    case AlState::kBoot:
      return 3 * kSecond;
    default:
      return 10 * kSecond;
  }
}

/// The next state on the way; BOOT is reached from INIT only.
AlState next_state(AlState from, AlState target) {
  if (from == target || target == AlState::kInit) return target;
  if (from == AlState::kBoot) return AlState::kInit;
  if (target == AlState::kBoot) return from == AlState::kInit ? AlState::kBoot : AlState::kInit;
  if (from > target) return target;
  if (from == AlState::kInit) return AlState::kPreop;
  return from == AlState::kPreop ? AlState::kSafeop : AlState::kOp;
}

bool is_mailbox(const SyncManager& manager, bool written_by_master) {
  return manager.enabled() && manager.is_mailbox() && manager.ecat_writes() == written_by_master &&
         manager.length > MailboxMessage::kHeaderSize;
}

}  // namespace

SlaveVisit::SlaveVisit(Bus& bus, std::uint16_t position)
    : bus_(bus), slave_(SlaveAddress::at_position(position)), name_(fmt::format("slave {}", position)) {}

Status SlaveVisit::read(std::uint16_t ado, std::span<std::uint8_t> bytes) {
  auto datagram = slave_.read(ado, bytes);
  if (auto status = bus_.transact(datagram); !status) return status;
  if (datagram.wkc == 0) return fail(ErrorCode::kNoResponse, name_);
  return {};
}

Status SlaveVisit::write(std::uint16_t ado, std::span<std::uint8_t> bytes) {
  auto datagram = slave_.write(ado, bytes);
  if (auto status = bus_.transact(datagram); !status) return status;
  if (datagram.wkc == 0) return fail(ErrorCode::kNoResponse, name_);
  return {};
}

Status SlaveVisit::read_status() {
  std::array<std::uint8_t, 6> bytes{};
  if (auto status = read(reg::kAlStatus, bytes); !status) return status;
  status_ = load_le<std::uint16_t>(bytes);
  status_code_ = load_le<std::uint16_t>(std::span(bytes).subspan<4, 2>());
  return {};
}

Status SlaveVisit::look() {
  std::array<std::uint8_t, 2> station{};
  if (auto status = read(reg::kStationAddress, station); !status) return status;
  if (auto status = read(reg::kSyncManager, found_managers_); !status) return status;
  if (auto status = read_status(); !status) return status;
  found_station_ = station_ = load_le<std::uint16_t>(station);
  found_status_ = status_;
  return {};
}

Error SlaveVisit::refused(AlState target, ErrorCode code) {
  Error error{code, name_};
  error.expected = static_cast<std::int64_t>(target);
  error.received = status_;
  error.extra = status_code_;
  return error;
}

Status SlaveVisit::acknowledge() {
  if ((status_ & kAlErrorFlag) == 0) return {};
  auto control = le_bytes(static_cast<std::uint16_t>((status_ & 0x0F) | kAlErrorFlag));
  if (auto status = write(reg::kAlControl, control); !status) return status;
  const auto end = bus_.clock().now() + kSecond;
  while (true) {
    if (auto status = read_status(); !status) return status;
    if ((status_ & kAlErrorFlag) == 0) return {};
    if (bus_.clock().now() >= end) return fail(refused(state(), ErrorCode::kAlTimeout));
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
}

Status SlaveVisit::step_to(AlState target) {
  if (auto status = acknowledge(); !status) return status;
  if (state() == AlState::kInit && (target == AlState::kPreop || target == AlState::kBoot)) {
    if (auto status = set_up_mailbox(target == AlState::kBoot); !status) return status;
  }
  auto control = le_bytes(static_cast<std::uint16_t>(target));
  if (auto status = write(reg::kAlControl, control); !status) return status;
  const auto end = bus_.clock().now() + patience(target);
  while (true) {
    if (auto status = read_status(); !status) return status;
    if ((status_ & kAlErrorFlag) != 0) return fail(refused(target, ErrorCode::kAlState));
    if (state() == target) return {};
    if (bus_.clock().now() >= end) return fail(refused(target, ErrorCode::kAlTimeout));
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
}

Status SlaveVisit::lead_to(AlState target) {
  while (state() != target) {
    if (auto status = step_to(next_state(state(), target)); !status) return status;
  }
  return acknowledge();
}

Status SlaveVisit::set_up_mailbox(bool bootstrap) {
  if (leaving_ && had_mailbox() && bootstrap == (found() == AlState::kBoot)) return set_managers(found_managers_);
  SiiAccess eeprom(bus_, {slave_}, {.take_ownership = true, .broadcast = false});
  std::array<SiiRequest, 1> requests;
  requests[0].word = bootstrap ? kBootstrapMailboxWord : kMailboxWord;
  auto done = eeprom.open();
  if (done) done = eeprom.read(requests);
  const auto closed = eeprom.close();
  if (!done) return done;
  if (!closed) return closed;
  if (requests[0].error) {
    auto error = *requests[0].error;
    error.subject = name_;
    return fail(std::move(error));
  }
  const auto word = [&](std::size_t n) {
    return load_le<std::uint16_t>(std::span(requests[0].data).subspan(2 * n, 2));
  };
  const SyncManager send{.start = word(0), .length = word(1), .control = kMailboxWrite, .activate = kEnabled};
  const SyncManager receive{.start = word(2), .length = word(3), .control = kMailboxRead, .activate = kEnabled};
  if (send.length == 0 || receive.length == 0) return {};  // a simple slave
  std::array<std::uint8_t, kMailboxManagers> managers{};
  std::ranges::copy(send.encode(), managers.begin());
  std::ranges::copy(receive.encode(), managers.begin() + SyncManager::kSize);
  managers_changed_ = true;
  return set_managers(managers);
}

/// It was found with mailboxes that it accepts.
bool SlaveVisit::had_mailbox() const {
  const std::span all(found_managers_);
  return found() != AlState::kInit && is_mailbox(SyncManager::decode(all.first<SyncManager::kSize>()), true) &&
         is_mailbox(SyncManager::decode(all.last<SyncManager::kSize>()), false);
}

/// Enabled, they keep their places whatever is written (ESC data sheet II, 2.31): they are switched off first.
Status SlaveVisit::set_managers(std::array<std::uint8_t, kMailboxManagers>& managers) {
  std::array<std::uint8_t, kMailboxManagers> off{};
  if (auto status = write(reg::kSyncManager, off); !status) return status;
  return write(reg::kSyncManager, managers);
}

/// Mailboxes are asked by station address, which must be the slave's alone.
Status SlaveVisit::take_station_address() {
  const auto answers = [&](std::uint16_t station) {
    std::array<std::uint8_t, 2> bytes{};
    return bus_.exchange(Command::kFprd, station, reg::kStationAddress, bytes);
  };
  if (station_ != 0) {
    const auto count = answers(station_);
    if (!count) return tl::unexpected(count.error());
    if (*count == 1) return {};
  }
  for (std::uint16_t station = kFirstStation; station < kLastStation; ++station) {
    const auto count = answers(station);
    if (!count) return tl::unexpected(count.error());
    if (*count != 0) continue;
    auto bytes = le_bytes(station);
    if (auto status = write(reg::kStationAddress, bytes); !status) return status;
    station_ = station;
    return {};
  }
  return fail(ErrorCode::kNotSupported, name_, because("no station address is free"));
}

Status SlaveVisit::open_mailbox() {
  if (state() == AlState::kInit) {
    if (auto status = lead_to(AlState::kPreop); !status) return status;
  }
  std::array<std::uint8_t, kMailboxManagers> managers{};
  if (auto status = read(reg::kSyncManager, managers); !status) return status;
  const std::span all(managers);
  const auto send = SyncManager::decode(all.first<SyncManager::kSize>());
  const auto receive = SyncManager::decode(all.last<SyncManager::kSize>());
  if (!is_mailbox(send, true) || !is_mailbox(receive, false)) {
    return fail(ErrorCode::kNotSupported, name_, because("it has no mailbox"));
  }
  if (auto status = take_station_address(); !status) return status;
  MailboxPort port;
  port.name = name_;
  port.station_address = station_;
  port.send = {send.start, send.length};
  port.receive = {receive.start, receive.length};
  mailbox_of_slave_.port = std::move(port);
  mailbox_.emplace(bus_, mailbox_of_slave_);
  return mailbox_->collect();
}

Status SlaveVisit::leave() {
  mailbox_.reset();
  Status result;
  const auto keep_first = [&result](Status status) {
    if (result && !status) result = std::move(status);
  };
  bus_.set_cancellable(false);
  leaving_ = true;
  if (state() != found()) keep_first(lead_to(found()));
  // Above INIT they were set on the way there: a slave falls when its mailboxes are switched off under it.
  if (managers_changed_ && (state() == AlState::kInit || !had_mailbox())) keep_first(set_managers(found_managers_));
  leaving_ = false;
  if (station_ != found_station_) {
    auto bytes = le_bytes(found_station_);
    keep_first(write(reg::kStationAddress, bytes));
  }
  bus_.set_cancellable(true);
  return result;
}

}  // namespace syncline
