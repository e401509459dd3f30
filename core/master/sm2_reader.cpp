// SPDX-License-Identifier: Apache-2.0
#include "master/sm2_reader.h"

#include <algorithm>

#include "master/sm2_counter_profile.h"
#include "protocol/coe.h"
#include "protocol/dc_registers.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// Often enough for a live plot, seldom enough to leave the slaves' mailboxes to others.
constexpr Nanoseconds kPeriod = 20 * kMillisecond;
constexpr Nanoseconds kTimeout = 2 * kSecond;
constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;
constexpr std::size_t kUploadRequestSize = 16;  // mailbox header, CoE header, SDO header
constexpr std::uint8_t kUploadCommand = 0x40;
constexpr std::uint8_t kUploadResponse = 2;     // specifier, bits 7..5
constexpr std::uint8_t kAbort = 4;

bool uses_sync(const SlaveConfig& slave) {
  return slave.mailbox && slave.mailbox->coe && slave.dc && AssignActivate{slave.dc->assign_activate}.sync0();
}

}  // namespace

Sm2Reader::Sm2Reader(RunState& run) : run_(run) {
  std::size_t longest = 0;
  for (std::size_t i = 0; i < run.config().slaves.size(); ++i) {
    const auto& slave = run.config().slaves[i];
    if (!uses_sync(slave) || slave.mailbox->send.length < kUploadRequestSize) continue;
    counters_.push_back({static_cast<std::uint16_t>(i), sm2_missed_sub_index(slave.identity)});
    longest = std::max<std::size_t>({longest, slave.mailbox->send.length, slave.mailbox->receive.length});
  }
  mailbox_.resize(longest);
}

std::vector<std::size_t> Sm2Reader::slaves() const {
  std::vector<std::size_t> slaves;
  for (const auto& counter : counters_) slaves.push_back(counter.slave);
  return slaves;
}

void Sm2Reader::set_sub_index(std::size_t slave, std::uint8_t sub_index) {
  for (auto& counter : counters_) {
    if (counter.slave == slave) counter.sub_index = sub_index;
  }
}

void Sm2Reader::begin(Nanoseconds now) {
  if (!enabled_ || now < next_start_ || counters_.empty()) return;
  next_start_ = now + kPeriod / static_cast<Nanoseconds>(counters_.size());
  give_up_ = now + kTimeout;
  current_ = (current_ + 1) % counters_.size();
  const auto& counter = counters_[current_];
  const auto& status = run_.snapshot.slaves[counter.slave];
  const auto state = al_state_of(status.al_status);
  if (!counter.supported || !status.present || (state != AlState::kSafeop && state != AlState::kOp)) return;
  auto& mailbox_counter = run_.mailbox_counters[counter.slave];
  mailbox_counter = next_mailbox_counter(mailbox_counter);
  step_ = Step::kWrite;
}

void Sm2Reader::write_request() {
  const auto& counter = counters_[current_];
  const auto bytes = std::span(mailbox_).first(slave().mailbox->send.length);
  std::ranges::fill(bytes, std::uint8_t{0});
  store_le<std::uint16_t>(bytes, kUploadRequestSize - MailboxMessage::kHeaderSize);
  bytes[5] = static_cast<std::uint8_t>(static_cast<unsigned>(MailboxType::kCoe) |
                                       (run_.mailbox_counters[counter.slave] << 4));
  store_le(bytes.subspan(6), static_cast<std::uint16_t>(static_cast<unsigned>(coe::Service::kSdoRequest) << 12));
  bytes[8] = kUploadCommand;
  store_le(bytes.subspan(9), kSyncManager2Parameter);
  bytes[11] = counter.sub_index;
  datagram_ = Datagram{Command::kFpwr, device_address(slave().station_address, slave().mailbox->send.start), bytes};
}

void Sm2Reader::add_to(PendingFrame& frame, Nanoseconds now) {
  asked_ = false;
  if (step_ == Step::kIdle) begin(now);
  switch (step_) {
    case Step::kIdle:
      return;
    case Step::kWrite:
      write_request();
      break;
    case Step::kPoll:
      status_.fill(0);
      datagram_ = Datagram{Command::kFprd, device_address(slave().station_address, kSm1Status), status_};
      break;
    case Step::kRead: {
      const auto bytes = std::span(mailbox_).first(slave().mailbox->receive.length);
      std::ranges::fill(bytes, std::uint8_t{0});
      datagram_ =
          Datagram{Command::kFprd, device_address(slave().station_address, slave().mailbox->receive.start), bytes};
      break;
    }
  }
  asked_ = frame.add(*datagram_);
}

void Sm2Reader::take(Nanoseconds time, CycleSample& sample) {
  if (!asked_) return;
  asked_ = false;
  if (datagram_->done()) {
    if (step_ == Step::kWrite) {
      step_ = Step::kPoll;
    } else if (step_ == Step::kPoll) {
      if ((status_[0] & SyncManager::kStatusMailboxFull) != 0) step_ = Step::kRead;
    } else {
      take_message(time, sample);
    }
  }
  // A slave that stays silent costs its turn, no more; one that is gone not even that.
  const bool gone = !run_.snapshot.slaves[counters_[current_].slave].present;
  if (step_ != Step::kIdle && (gone || time >= give_up_)) step_ = Step::kIdle;
}

void Sm2Reader::take_message(Nanoseconds time, CycleSample& sample) {
  ByteReader reader(std::span<const std::uint8_t>(mailbox_).first(slave().mailbox->receive.length));
  reader.skip(5);
  const auto type = static_cast<MailboxType>(reader.u8() & 0x0F);
  const auto service = static_cast<coe::Service>(reader.u16() >> 12);
  if (!reader.ok() || type == MailboxType::kError) {
    step_ = Step::kIdle;
    return;
  }
  step_ = Step::kPoll;  // whatever else it was: the answer is still to come
  if (type != MailboxType::kCoe) return;
  if (service == coe::Service::kEmergency) {
    const auto code = reader.u16();
    const auto error_register = reader.u8();
    run_.event(EventKind::kEmergency, time, counters_[current_].slave, code, error_register);
    return;
  }
  if (service != coe::Service::kSdoResponse) return;
  step_ = Step::kIdle;
  const auto command = reader.u8();
  const auto index = reader.u16();
  const auto sub_index = reader.u8();
  const auto value = reader.u32();
  auto& counter = counters_[current_];
  if (!reader.ok() || index != kSyncManager2Parameter || sub_index != counter.sub_index) return;
  const auto specifier = static_cast<std::uint8_t>(command >> 5);
  if (specifier == kAbort) counter.supported = false;
  if (specifier != kUploadResponse || (command & 0x02) == 0) return;
  const unsigned unused = (command & 0x01) != 0 ? (command >> 2) & 3U : 0U;
  take_value(value & (0xFFFF'FFFFU >> (8 * unused)), sample);
}

void Sm2Reader::take_value(std::uint32_t value, CycleSample& sample) {
  const auto& counter = counters_[current_];
  run_.snapshot.slaves[counter.slave].sm2_missed = {true, value, kSyncManager2Parameter, counter.sub_index};
  sample.sm2_position = static_cast<std::int16_t>(counter.slave);
  sample.slave_sm2_missed = value;
}

}  // namespace syncline
