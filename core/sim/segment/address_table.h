// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sim/esc/esc.h"
#include "sim/esc/passing_frame.h"

namespace syncline::sim {

/// Which of a segment's slaves a datagram for single slaves is for: found by its address instead of by asking each of
/// them in every frame. It holds as long as no ESC's settings change (Esc::count_changes_in()).
class AddressTable {
 public:
  AddressTable() : places_(PassingFrame::kNoStation, kNobody) {}

  /// All anew; `changes`: the count of changes now.
  void begin(std::uint64_t changes);
  /// The next slave on the frames' way.
  void add(Esc& esc);
  [[nodiscard]] bool holds(std::uint64_t changes) const { return changes_ == changes; }
  void forget() { changes_ = 0; }
  /// Slaves, by their places on the way and in its order, for whom a datagram for single slaves is; of a frame with
  /// nothing else in it also those that look at every frame. `event_changes`: the count of those now.
  [[nodiscard]] const std::vector<std::uint16_t>& called_by(const PassingFrame& frame, std::uint64_t event_changes);

 private:
  static constexpr std::uint16_t kNobody = 0xFFFF;
  void place(std::uint32_t station, std::uint16_t slave);
  void find_watching(std::uint64_t event_changes);

  struct Slave {
    const Esc* esc = nullptr;
    StationAddresses::Pair address;
  };
  std::uint64_t changes_ = 0;
  std::vector<Slave> slaves_;
  std::vector<std::uint16_t> places_;    // by station address
  std::vector<std::uint16_t> watchful_;  // those that may look at every frame
  std::vector<std::uint16_t> watching_;  // those of them that do
  std::uint64_t event_changes_ = 0;      // when that was found out; 0: not yet
  bool shared_ = false;                  // several have the same address
  std::vector<std::uint16_t> called_;
};

}  // namespace syncline::sim
