// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "master/exchange/slave_address.h"
#include "reasons/brief_reason.h"
#include "support/brief_error.h"
#include "support/types.h"

namespace syncline {

/// One slave's EEPROM interface (0x0500 to 0x050F) step by step: takes it from the PDI and gives it back, reads eight
/// bytes, writes one word. One of these at a time, each cut into datagrams as a SlaveWork. Who has the whole bus for
/// reading uses SiiAccess, which does it for many slaves at once. Allocates nothing.
class SiiPort {
 public:
  static constexpr std::size_t kPiece = 8;

  void use(const SlaveAddress& slave);
  void open();
  void close();
  void read(std::uint32_t word);
  void write(std::uint32_t word, std::uint16_t value);

  Datagram* next(Nanoseconds now);
  void take(Nanoseconds now);
  [[nodiscard]] bool over() const { return step_ == Step::kOver; }
  /// Before that next() has nothing to send.
  [[nodiscard]] Nanoseconds not_before() const { return not_before_; }
  /// kSii with the word; {2} in its words is left for who says what became of the rest.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }
  /// After read().
  [[nodiscard]] std::span<const std::uint8_t, kPiece> piece() const { return piece_; }

 private:
  enum class Step : std::uint8_t {
    kOver,
    kLook,
    kForce,
    kAssign,
    kClearOld,
    kGiveBack,
    kIdle,
    kCommand,
    kFetch,
    kClear,
  };
  enum class Job : std::uint8_t { kOpen, kClose, kRead, kWrite };

  void begin(Job job, Step step);
  Datagram* ask(std::uint16_t register_address, std::size_t length);
  Datagram* tell(std::uint16_t register_address, std::uint32_t value, std::size_t length);
  Datagram* command();
  void take_look();
  void take_idle(Nanoseconds now);
  void take_fetch(Nanoseconds now);
  void take_data(std::uint32_t address, Nanoseconds now);
  void fail_with(BriefRow<1> why);
  [[nodiscard]] std::uint32_t word() const { return word_ + static_cast<std::uint32_t>(got_ / 2); }

  SlaveAddress slave_ = SlaveAddress::at_station(0);
  Job job_ = Job::kOpen;
  Step step_ = Step::kOver;
  bool pdi_ = false, old_error_ = false, reads_address_back_ = true;
  std::uint32_t word_ = 0;
  std::uint16_t value_ = 0;
  std::size_t got_ = 0;
  int errors_ = 0, mismatches_ = 0, silences_ = 0;
  Nanoseconds not_before_ = 0, busy_since_ = 0;
  std::array<std::uint8_t, 14> bytes_{};
  std::array<std::uint8_t, kPiece> piece_{};
  Datagram datagram_;
  std::optional<BriefError> failure_;
};

}  // namespace syncline
