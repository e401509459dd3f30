// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/frame_exchange.h"
#include "master/run_state.h"

namespace syncline {

/// Looks after single slaves by acyclic datagrams while the bus runs: 0x092C of one DC slave a cycle in
/// turn, AL status and code of every slave when the cyclic broadcast says that something changed, and
/// 0x092C of all where the cyclic frame does not read it. Allocates nothing in the cycle.
class SlaveWatch {
 public:
  explicit SlaveWatch(RunState& run);
  SlaveWatch(const SlaveWatch&) = delete;
  SlaveWatch& operator=(const SlaveWatch&) = delete;

  /// Slaves whose deviation is read in turn.
  void set_dc_slaves(std::vector<std::uint16_t> positions) { dc_slaves_ = std::move(positions); }
  /// The cyclic broadcast of AL status: ored value and working counter.
  void observe_broadcast(std::uint16_t al_status, std::uint16_t wkc);
  void refresh_al_status() { next_al_ = 0; }
  [[nodiscard]] bool refreshing() const { return next_al_ < al_.size(); }

  void add_to(PendingFrame& frame, bool read_deviation_of_all);
  /// After the frame: takes the answers over. The ored 0x092C, if it was asked for.
  std::optional<std::uint32_t> take(Nanoseconds time, CycleSample& sample);

 private:
  struct AlReading {
    std::array<std::uint8_t, 6> bytes{};
    Datagram datagram;
    int unanswered = 0;
  };
  void add_al_status(PendingFrame& frame);
  void take_al_status(Nanoseconds time);
  void take_deviation(Nanoseconds time, CycleSample& sample);

  RunState& run_;
  std::vector<std::uint16_t> dc_slaves_;
  std::size_t next_dc_ = 0;
  std::array<std::uint8_t, 4> deviation_bytes_{}, all_bytes_{};
  Datagram deviation_, all_;
  std::optional<std::size_t> asked_deviation_;
  bool asked_all_ = false;

  std::vector<AlReading> al_;
  std::size_t next_al_;                       // first slave that is still to be read
  std::size_t asked_begin_ = 0, asked_end_ = 0;
  std::optional<std::uint16_t> last_status_, last_wkc_;
};

}  // namespace syncline
