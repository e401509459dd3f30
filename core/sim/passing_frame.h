// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "protocol/frame.h"

namespace syncline::sim {

/// A datagram on its way through the slaves: what each of them looks at, taken out of the header once.
struct PassingDatagram {
  Command command = Command::kNop;
  bool circulating = false;
  std::uint16_t adp = 0, ado = 0;    // device addressing
  std::uint32_t address = 0;         // logical addressing
  std::uint16_t step = 0;            // by which each slave moves ADP on: 1 by position and for all, else 0
  std::uint16_t wkc = 0;
  std::span<std::uint8_t> data;      // in the frame
};

/// A frame on its way through the slaves. What they leave in it beside the data is written into its bytes at the end.
class PassingFrame {
 public:
  enum class Kind : std::uint8_t { kEtherCat, kForeign, kMalformed };
  /// Takes in a frame, which must stay where it is until leave().
  Kind arrive(std::span<std::uint8_t> bytes);
  /// Writes headers and working counters back.
  void leave();

  [[nodiscard]] std::span<PassingDatagram> datagrams() { return datagrams_; }
  [[nodiscard]] std::span<const PassingDatagram> datagrams() const { return datagrams_; }
  /// Everything in it is for slaves with this or that station address, and tells the others nothing.
  [[nodiscard]] bool is_for_single_slaves() const { return for_single_slaves_; }
  /// It makes ESCs note when it came to which of their ports.
  [[nodiscard]] bool takes_port_times() const { return takes_port_times_; }
  /// A slave adds its ECAT event request, of which each datagram carries a copy.
  void add_event(std::uint16_t event) { event_ = static_cast<std::uint16_t>(event_ | event); }

 private:
  std::vector<DatagramView> views_;
  std::vector<PassingDatagram> datagrams_;
  bool for_single_slaves_ = false, takes_port_times_ = false;
  std::uint16_t event_ = 0;
};

}  // namespace syncline::sim
