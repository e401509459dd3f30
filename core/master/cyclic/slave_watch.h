// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/exchange/frame_exchange.h"

namespace syncline {

struct CycleSample;
class EventTeller;
struct NetworkConfig;
struct OredDeviation;
class SlaveStates;
struct Snapshot;

/// Looks after single slaves by acyclic datagrams while the bus runs: 0x092C of one DC slave a cycle in
/// turn; AL status, AL status code and DL status of every slave when the cyclic broadcast says that
/// something changed (a sweep); and 0x092C of all where the cyclic frame does not read it. Allocates
/// nothing in the cycle.
///
/// An or-ed AL status hides who falls behind one that has fallen already, and a working counter who comes while
/// another goes. So the AL status is read in turn as well, every slave twice a second: what is another than known
/// begins a sweep.
///
/// What a sweep finds is told in a definite order: cables over which nothing comes back any more, slaves
/// that are lost, cables that are healed, slaves that answer again, states and AL status errors, each in
/// frame order, the master's state last.
class SlaveWatch {
 public:
  SlaveWatch(const NetworkConfig& config, Snapshot& snapshot, SlaveStates& states, EventTeller& teller);
  SlaveWatch(const SlaveWatch&) = delete;
  SlaveWatch& operator=(const SlaveWatch&) = delete;

  /// Slaves whose deviation is read in turn.
  void set_dc_slaves(std::vector<std::uint16_t> positions) { dc_slaves_ = std::move(positions); }
  /// The cyclic broadcast of AL status: ored value and working counter. True: others answer than in the one before, so
  /// that frames may go another way; who it is a sweep will say.
  bool observe_broadcast(std::uint16_t al_status, std::uint16_t wkc);
  /// No cyclic frame of this cycle came back. After a while no slave is there any more.
  void observe_silence(bool silent, Nanoseconds time);
  void refresh_al_status() { next_al_ = 0; }
  [[nodiscard]] bool refreshing() const { return next_al_ < al_.size(); }
  /// Nothing hints at slaves that have come or gone since they were looked at last.
  [[nodiscard]] bool settled() const { return !refreshing() && !silent_since_; }
  /// Slaves that answered the latest cyclic broadcast, with or without a station address.
  [[nodiscard]] std::optional<std::uint16_t> answering() const { return last_wkc_; }

  /// `hurry`: the deviations of many slaves in each cycle, to find out who left the sync window.
  void add_to(PendingFrame& frame, bool read_deviation_of_all, bool hurry = false);
  /// After the frame: takes the answers over. The ored 0x092C, if it was asked for.
  std::optional<OredDeviation> take(Nanoseconds time, CycleSample& sample);
  /// The slaves whose deviation came with the latest cycle.
  [[nodiscard]] std::span<const std::uint16_t> deviations_read() const { return deviations_read_; }
  /// Number of sweeps that came to their end.
  [[nodiscard]] std::uint64_t sweeps() const { return sweeps_; }

 private:
  struct AlReading {
    std::array<std::uint8_t, 6> bytes{};
    std::array<std::uint8_t, 2> dl_bytes{};
    Datagram datagram, dl_datagram;
    [[nodiscard]] bool present() const { return datagram.wkc > 0; }
  };
  /// AL status and code of one slave in its turn.
  struct Turn {
    std::size_t slave = 0;
    std::array<std::uint8_t, 6> bytes{};
    Datagram datagram;
  };
  void add_turns(PendingFrame& frame);
  void take_turns(Nanoseconds time);
  [[nodiscard]] bool is_news(const Turn& turn) const;
  void add_al_status(PendingFrame& frame);
  void take_al_status(Nanoseconds time);
  void finish_sweep(Nanoseconds time);
  void tell_cables(Nanoseconds time, bool healed);
  void tell_cable(Nanoseconds time, std::size_t slave, bool healed);
  void tell_presence(Nanoseconds time, bool present);
  void take_deviations(Nanoseconds time, CycleSample& sample);
  bool add_deviation(PendingFrame& frame);

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  SlaveStates& states_;
  EventTeller& teller_;
  std::vector<std::uint16_t> dc_slaves_;
  std::size_t next_dc_ = 0;
  struct DeviationReading {
    std::uint16_t slave = 0;
    std::array<std::uint8_t, 4> bytes{};
    Datagram datagram;
  };
  std::array<DeviationReading, 16> deviations_;
  std::size_t asked_deviations_ = 0;
  std::vector<std::uint16_t> deviations_read_;
  std::array<std::uint8_t, 4> all_bytes_{};
  Datagram all_;
  bool asked_all_ = false;

  std::vector<AlReading> al_;
  std::vector<Turn> turns_;  // as many as a cycle has
  std::size_t turns_asked_ = 0;
  std::size_t next_turn_ = 0;  // slave
  std::size_t cycles_per_round_, turn_credit_ = 0;
  std::size_t next_al_;  // first slave that is still to be read
  std::size_t asked_begin_ = 0, asked_end_ = 0;
  std::uint64_t sweeps_ = 0;
  std::optional<Nanoseconds> silent_since_;
  std::optional<std::uint16_t> last_status_, last_wkc_;
};

}  // namespace syncline
