// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dc/propagation_delay.h"
#include "master/exchange/frame_exchange.h"

namespace syncline {

class SlaveAddress;

/// Rounds of the delay measurement: a broadcast write makes every slave latch when the frame passes its ports, and a
/// later frame reads that. The stamps have a noise of some ten nanoseconds; medians of several rounds have less.
/// Sized at construction; a round allocates nothing.
class DelayLatch {
 public:
  /// `nodes`: what the slaves can and where they hang, in frame order; `rounds`: how many will be taken.
  DelayLatch(std::span<const SlaveAddress> slaves, std::vector<dc::DelayNode> nodes, std::size_t rounds);
  DelayLatch(const DelayLatch&) = delete;
  DelayLatch& operator=(const DelayLatch&) = delete;

  /// Begins a round: what must be sent first, in a frame of its own.
  Datagram& trigger();
  /// That frame is back: what must be sent now, in any frames behind it.
  std::span<Datagram> begin_reading();
  [[nodiscard]] std::span<Datagram> reads() { return reads_; }
  /// The reads are back. False when a slave with receive times did not answer: the round does not count.
  bool take();

  [[nodiscard]] std::size_t rounds() const { return rounds_; }
  [[nodiscard]] std::size_t wanted_rounds() const { return most_rounds_; }
  void forget() { rounds_ = 0; }
  /// The medians of all rounds, as the port times of each slave.
  [[nodiscard]] const std::vector<dc::DelayNode>& nodes();
  /// Local time at the processing unit in the latest round (0x0918), for slaves with a system time.
  [[nodiscard]] std::uint64_t processing_unit(std::size_t slave) const;

 private:
  struct Slave {
    std::array<std::uint8_t, 16> ports{};
    std::array<std::uint8_t, 8> processing_unit{};
    std::size_t base = 0;                                  // the first port that frames pass
    std::array<std::vector<std::int32_t>, 4> differences;  // to the base port, one a round
    std::vector<std::int32_t> processing;                  // the same of the processing unit
  };

  std::vector<dc::DelayNode> nodes_;
  std::vector<Slave> slaves_;
  std::array<std::uint8_t, 4> zeros_{};
  Datagram trigger_;
  std::vector<Datagram> reads_;
  std::vector<std::size_t> port_read_of_;  // index of the slave whose ports reads_[i] reads; SIZE_MAX for 0x0918
  std::size_t rounds_ = 0, most_rounds_;
};

}  // namespace syncline
