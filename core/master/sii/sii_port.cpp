// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_port.h"

#include <algorithm>

#include "master/sii/sii_layout.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kWriteCommand = 0x0201;  // with write enable in the same datagram

constexpr Nanoseconds kPause = 200 * kMicrosecond;
constexpr Nanoseconds kAfterError = 2 * kMillisecond;  // the EEPROM is still storing the word before
constexpr int kReadTries = 4, kWriteTries = 20, kSilences = 4;

}  // namespace

void SiiPort::use(const SlaveAddress& slave) {
  slave_ = slave;
  pdi_ = old_error_ = false;
  reads_address_back_ = true;
  step_ = Step::kOver;
  not_before_ = 0;
}

void SiiPort::begin(Job job, Step step) {
  job_ = job;
  step_ = step;
  errors_ = mismatches_ = silences_ = 0;
  busy_since_ = 0;
  got_ = 0;
  failure_.reset();
}

void SiiPort::open() { begin(Job::kOpen, Step::kLook); }

void SiiPort::close() { begin(Job::kClose, pdi_ ? Step::kGiveBack : Step::kOver); }

void SiiPort::read(std::uint32_t word) {
  begin(Job::kRead, Step::kIdle);
  word_ = word;
}

void SiiPort::write(std::uint32_t word, std::uint16_t value) {
  begin(Job::kWrite, Step::kIdle);
  word_ = word;
  value_ = value;
}

void SiiPort::fail_with(BriefRow<1> why) {
  step_ = Step::kOver;
  failure_ = BriefError{.code = ErrorCode::kSii, .why = brief(why, hex_number(word(), 4))};
}

// ---- datagrams ----------------------------------------------------------------------------------

Datagram* SiiPort::ask(std::uint16_t register_address, std::size_t length) {
  bytes_.fill(0);
  datagram_ = slave_.read(register_address, std::span(bytes_).first(length));
  return &datagram_;
}

Datagram* SiiPort::tell(std::uint16_t register_address, std::uint32_t value, std::size_t length) {
  store_le(std::span(bytes_), value);
  datagram_ = slave_.write(register_address, std::span(bytes_).first(length));
  return &datagram_;
}

/// Command, address and data in one datagram: the enable bit holds for its own frame only.
Datagram* SiiPort::command() {
  const std::span all(bytes_);
  const bool write = job_ == Job::kWrite;
  store_le(all, write ? kWriteCommand : kSiiReadCommand);
  store_le(all.subspan(2), word());
  store_le(all.subspan(kSiiStatusBytes), value_);
  datagram_ = slave_.write(reg::kSiiControl, all.first(write ? kSiiStatusBytes + 2 : kSiiStatusBytes));
  return &datagram_;
}

Datagram* SiiPort::next(Nanoseconds now) {
  if (now < not_before_) return nullptr;
  switch (step_) {
    case Step::kOver:
      return nullptr;
    case Step::kLook:
      return ask(reg::kSiiConfiguration, 4);
    case Step::kForce:
      return tell(reg::kSiiConfiguration, 0x02, 1);
    case Step::kAssign:
      return tell(reg::kSiiConfiguration, 0x00, 1);
    case Step::kGiveBack:
      return tell(reg::kSiiConfiguration, 0x01, 1);
    case Step::kClearOld:
    case Step::kClear:
      return tell(reg::kSiiControl, 0, 2);
    case Step::kIdle:
    case Step::kFetch:
      return ask(reg::kSiiControl, bytes_.size());
    case Step::kCommand:
      return command();
  }
  return nullptr;
}

void SiiPort::take(Nanoseconds now) {
  if (over() || !datagram_.answered) return;  // lost: once more
  if (datagram_.wkc == 0) {
    if (++silences_ == kSilences) fail_with("no answer at word 0x{word}{which}");
    return;
  }
  silences_ = 0;
  switch (step_) {
    case Step::kOver:
      return;
    case Step::kLook:
      return take_look();
    case Step::kForce:
      step_ = Step::kAssign;
      return;
    case Step::kAssign:
      step_ = old_error_ ? Step::kClearOld : Step::kOver;
      return;
    case Step::kClearOld:
    case Step::kGiveBack:
      step_ = Step::kOver;
      return;
    case Step::kClear:
      step_ = Step::kIdle;
      busy_since_ = 0;
      if (job_ == Job::kWrite) not_before_ = now + kAfterError;
      return;
    case Step::kIdle:
      return take_idle(now);
    case Step::kCommand:
      step_ = Step::kFetch;
      busy_since_ = 0;
      not_before_ = now + kPause;
      return;
    case Step::kFetch:
      return take_fetch(now);
  }
}

// ---- answers ------------------------------------------------------------------------------------

void SiiPort::take_look() {
  const auto control = load_le<std::uint16_t>(std::span(bytes_).subspan(2));
  pdi_ = ((bytes_[0] | bytes_[1]) & 0x01) != 0;
  old_error_ = (control & (kSiiCommandError | kSiiWriteEnableError)) != 0;
  step_ = pdi_ ? Step::kForce : old_error_ ? Step::kClearOld : Step::kOver;
}

/// A busy EEPROM takes no command; it may be another's, of a program that was killed.
void SiiPort::take_idle(Nanoseconds now) {
  if ((load_le<std::uint16_t>(bytes_) & kSiiBusy) == 0) {
    step_ = Step::kCommand;
    return;
  }
  if (busy_since_ == 0) busy_since_ = now;
  if (now - busy_since_ > kSiiBusyLimit) return fail_with("the EEPROM stays busy at word 0x{word}{which}");
  not_before_ = now + kPause;
}

void SiiPort::take_fetch(Nanoseconds now) {
  const auto control = load_le<std::uint16_t>(bytes_);
  if ((control & kSiiBusy) != 0) {
    if (busy_since_ == 0) busy_since_ = now;
    if (now - busy_since_ > kSiiBusyLimit) return fail_with("the EEPROM stays busy at word 0x{word}{which}");
    not_before_ = now + kPause;
    return;
  }
  const bool write = job_ == Job::kWrite;
  if (write && (control & kSiiWriteEnableError) != 0)
    return fail_with("the ESC does not enable writing at word 0x{word}{which}");
  if ((control & kSiiCommandError) != 0) {
    step_ = Step::kClear;
    if (++errors_ == (write ? kWriteTries : kReadTries))
      write ? fail_with("the EEPROM acknowledges no write command at word 0x{word}{which}")
            : fail_with("the EEPROM acknowledges no read command at word 0x{word}{which}");
    return;
  }
  if (write) {
    step_ = Step::kOver;
    return;
  }
  take_data(load_le<std::uint32_t>(std::span<const std::uint8_t>(bytes_).subspan(2)), now);
}

/// The address that comes back tells which read the data belong to; some ESCs never show it.
void SiiPort::take_data(std::uint32_t address, Nanoseconds /*now*/) {
  if (reads_address_back_ && address != word()) {
    step_ = Step::kIdle;
    if (++mismatches_ == kReadTries) reads_address_back_ = false;
    return;
  }
  const bool eight = (load_le<std::uint16_t>(bytes_) & kSiiReadsEightBytes) != 0;
  const std::size_t count = std::min<std::size_t>(eight ? 8 : 4, kPiece - got_);
  std::copy_n(bytes_.begin() + kSiiStatusBytes, count, piece_.begin() + static_cast<std::ptrdiff_t>(got_));
  got_ += count;
  step_ = got_ == kPiece ? Step::kOver : Step::kIdle;
}

}  // namespace syncline
