// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "protocol/datagram.h"
#include "sim/esc/frame_plan.h"

namespace syncline::sim {

/// A datagram on its way through the slaves: what each of them looks at, taken out of the header once.
struct PassingDatagram {
  Command command = Command::kNop;
  bool circulating = false;
  std::uint16_t adp = 0, ado = 0;  // device addressing
  std::uint32_t address = 0;       // logical addressing
  std::uint16_t step = 0;          // by which each slave moves ADP on: 1 by position and for all, else 0
  std::uint16_t wkc = 0;
  std::span<std::uint8_t> data;  // in the frame
};

/// For one slave by its station address, which looks itself whether it has that.
[[nodiscard]] constexpr bool is_for_station(Command command) {
  return is_fixed_address(command) && command != Command::kFrmw;
}

/// A frame on its way through the slaves. What they leave in it beside the data is written into its bytes at the end.
class PassingFrame {
 public:
  /// kEach: no plans are made, every ESC executes every datagram.
  enum class Execution : std::uint8_t { kPlanned, kEach };
  explicit PassingFrame(Execution execution = Execution::kPlanned) : execution_(execution) {}

  enum class Kind : std::uint8_t { kEtherCat, kForeign, kMalformed };
  /// Takes in a frame, which must stay where it is until leave().
  Kind arrive(std::span<std::uint8_t> bytes);
  /// Writes headers and working counters back.
  void leave();

  /// Frames with the same commands, addresses and lengths have the same shape; station addresses do not count, nor
  /// commands to them that are behind all others.
  struct Shape {
    std::uint64_t id = 0;    // unlike those of all others; 0: none
    std::uint8_t place = 0;  // of its plan in each ESC
    std::vector<std::uint64_t> datagrams;
  };
  /// Null: nobody is to make a plan for this frame.
  [[nodiscard]] const Shape* shape() const { return shape_; }
  static constexpr std::uint32_t kNoStation = 0x1'0000;
  /// A datagram for single slaves is for this station address, or for the other one; kNoStation: for nobody.
  [[nodiscard]] bool is_for(std::uint32_t station, std::uint32_t other) const {
    return !stations_.empty() && (is_wanted(station) || is_wanted(other));
  }
  /// The station addresses that datagrams for single slaves are for.
  [[nodiscard]] const std::vector<std::uint16_t>& stations() const { return stations_; }
  /// A kind of ESCs in frames of this shape: those whose plans count alike. Nothing: there are too many.
  [[nodiscard]] std::optional<std::uint8_t> kind_of(const FramePlan::Counters& wkc);
  /// An ESC has followed its plan: it counts as others of its kind do, and positions move on.
  void pass(std::uint8_t kind) { ++passed_[kind]; }
  /// Takes what the plans counted into the datagrams: before somebody looks at those.
  void settle();
  [[nodiscard]] std::span<std::uint8_t> bytes() { return bytes_; }

  [[nodiscard]] std::span<PassingDatagram> datagrams() { return datagrams_; }
  [[nodiscard]] std::span<const PassingDatagram> datagrams() const { return datagrams_; }
  /// Everything in it is for slaves with this or that station address, and tells the others nothing.
  [[nodiscard]] bool is_for_single_slaves() const { return for_single_slaves_; }
  /// It makes ESCs note when it came to which of their ports.
  [[nodiscard]] bool takes_port_times() const { return takes_port_times_; }
  /// Somebody reads or writes registers of the DC unit by it.
  [[nodiscard]] bool touches_clock() const { return touches_clock_; }
  /// A slave adds its ECAT event request, of which each datagram carries a copy.
  void add_event(std::uint16_t event) { event_ = static_cast<std::uint16_t>(event_ | event); }

 private:
  void find_shape();
  void find_stations();
  [[nodiscard]] bool is_wanted(std::uint32_t station) const {
    return (wanted_[station / 64] >> station % 64 & 1U) != 0;
  }

  Execution execution_;
  std::array<Shape, FramePlan::kPlaces> shapes_;
  std::uint8_t next_shape_ = 0;
  const Shape* shape_ = nullptr;
  std::vector<std::uint64_t> keys_;                          // of the datagrams, for their shape
  std::vector<std::uint16_t> stations_;                      // that datagrams for single slaves are for
  std::array<std::uint64_t, kNoStation / 64 + 1> wanted_{};  // the same: a bit for each address
  static constexpr std::size_t kMostKinds = 32;
  std::array<std::vector<FramePlan::Counters>, FramePlan::kPlaces> kinds_;  // of each shape; the first counts nothing
  std::array<std::uint16_t, kMostKinds> passed_{};  // ESCs of each kind that have followed their plans
  std::span<std::uint8_t> bytes_;
  std::vector<DatagramView> views_;
  std::vector<PassingDatagram> datagrams_;
  bool for_single_slaves_ = false, takes_port_times_ = false, touches_clock_ = false;
  std::uint16_t event_ = 0;
};

}  // namespace syncline::sim
