// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/exchange/slave_address.h"
#include "master/exchange/slave_batch.h"
#include "support/brief_error.h"

namespace syncline {

/// Reads or writes a range of a slave's registers and memory, a datagram at a time. Allocates where
/// what comes has no room in the caller's bytes.
class RegisterWork final : public SlaveWork {
 public:
  static constexpr std::size_t kMost = 512;  // bytes in one datagram

  /// What is there comes behind what `into` holds. `into` outlives the work.
  void read(const SlaveAddress& slave, std::uint16_t address, std::size_t length, std::vector<std::uint8_t>& into);
  /// `data` outlives the work.
  void write(const SlaveAddress& slave, std::uint16_t address, std::span<const std::uint8_t> data);
  void give_up(const BriefError& why);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return done_ == length_ || failure_; }
  [[nodiscard]] Status result() const override;
  /// kWorkingCounter: nobody processed the datagram, be it that the slave has no such register (or protects it) or
  /// that no slave is there: whoever must know asks for a register that every ESC has.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }

 private:
  void begin(const SlaveAddress& slave, std::uint16_t address, std::size_t length);

  SlaveAddress slave_ = SlaveAddress::at_station(0);
  std::uint16_t address_ = 0;
  std::size_t length_ = 0, done_ = 0;
  std::vector<std::uint8_t>* into_ = nullptr;  // null: a write
  std::span<const std::uint8_t> data_;
  std::array<std::uint8_t, kMost> bytes_{};
  Datagram datagram_;
  int silences_ = 0;
  std::optional<BriefError> failure_;
};

}  // namespace syncline
