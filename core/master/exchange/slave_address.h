// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "master/exchange/frame_exchange.h"
#include "protocol/datagram.h"
#include "support/types.h"

namespace syncline {

/// How a slave is asked: by its place, which every slave has, or by its station address.
class SlaveAddress {
 public:
  static SlaveAddress at_position(std::uint16_t position) {
    return {Command::kAprd, Command::kApwr, Position{position}.auto_increment_address()};
  }
  static SlaveAddress at_station(std::uint16_t station) { return {Command::kFprd, Command::kFpwr, station}; }

  [[nodiscard]] Datagram read(std::uint16_t ado, std::span<std::uint8_t> data) const {
    return {read_, device_address(adp_, ado), data};
  }
  [[nodiscard]] Datagram write(std::uint16_t ado, std::span<std::uint8_t> data) const {
    return {write_, device_address(adp_, ado), data};
  }

 private:
  SlaveAddress(Command read, Command write, std::uint16_t adp) : read_(read), write_(write), adp_(adp) {}
  Command read_, write_;
  std::uint16_t adp_;
};

}  // namespace syncline
