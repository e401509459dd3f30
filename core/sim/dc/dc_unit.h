// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "config/sim_config.h"
#include "protocol/registers.h"
#include "sim/dc/latch_unit.h"
#include "sim/dc/local_clock.h"
#include "sim/dc/sync_generator.h"
#include "sim/dc/time_control_loop.h"

namespace syncline::sim {

/// Distributed-clocks unit of an ESC: receive times, system time with its control loop, SYNC signals
/// (registers 0x0900 to 0x09FF; ESC data sheet I, chapter 9). Times given are true time.
class DcUnit {
 public:
  DcUnit(const OscillatorConfig& oscillator, const SimDcConfig& config, Nanoseconds power_on, std::uint64_t seed,
         EscMemory& memory);

  /// SYNC0/SYNC1 up to `time` are delivered in order.
  std::function<void(SyncGenerator::Signal, Nanoseconds)> on_sync;
  /// When more than an hour of them is due at once, the first ones are passed over.
  void advance_to(Nanoseconds time) {
    if (time < quiet_until()) {  // several times in every frame
      now_ = std::max(now_, time);
    } else {
      deliver_until(time);
    }
  }
  /// The same, when nothing is due.
  void pass_quietly(Nanoseconds time) { now_ = std::max(now_, time); }
  /// Nobody wants to know of each SYNC0, which come in regular cycles: they are counted when somebody looks.
  void leave_signals_unminded();
  [[nodiscard]] bool signals_unminded() const { return unminded_; }
  /// How many have come since they were left unminded, or since the last time that somebody asked.
  std::uint64_t count_unminded() {
    pass_unminded();
    return std::exchange(unasked_, 0);
  }
  /// SYNC0 comes in regular cycles, without SYNC1.
  [[nodiscard]] bool has_regular_signals() const;
  /// Until the next SYNC0 of these, seen from this moment, in local time; 0 and less: it has come.
  [[nodiscard]] std::int64_t until_sync0(const LocalClock::Moment& moment) const {
    return static_cast<std::int64_t>(*generator_.next_sync0() - offset() - moment.exact());
  }
  [[nodiscard]] LocalClock::Moment moment(Nanoseconds time) const { return clock_.moment(time); }
  [[nodiscard]] const LocalClock& clock() const { return clock_; }
  /// Somebody else has done what the next SYNC0 is for. Its local time.
  std::uint64_t pass_sync0() {
    const auto local = *generator_.next_sync0() - offset();
    generator_.pass_sync0();
    return local;
  }
  /// Delivers those between `time` and now that pass_idly() and pass_sync0() have left.
  void deliver_from(Nanoseconds time);
  /// They are delivered again; true time of the last one that was not.
  std::optional<Nanoseconds> mind_signals();
  /// Nothing happens in the unit before, as long as nobody writes to it.
  [[nodiscard]] Nanoseconds quiet_until() const {
    return unminded_ ? clock_.next_change() : std::min(quiet_until_, clock_.next_change());
  }

  /// A frame starts at the processing unit: the system time that reads in this frame show.
  void start_of_frame(Nanoseconds time);
  void start_of_frame(const LocalClock::Moment& moment) { local_at_start_of_frame_ = moment.sample; }
  /// The same and count_unminded(), of signals that nobody minds.
  std::uint64_t start_of_counted_frame(Nanoseconds time) {
    const auto clock = clock_.read(time);
    local_at_start_of_frame_ = clock.sample;
    const auto until = now_ <= time ? clock.exact : clock_.exact(now_);
    const auto signals = generator_.skip_regular_to(until + offset() + 1);
    return signals + std::exchange(unasked_, 0);
  }
  /// Copies what a read of this frame shows into the register file: before anybody looks at these registers or writes a
  /// part of them.
  void refresh_registers();
  /// Where they are.
  static constexpr std::uint16_t kShownBegin = 0x0910, kShownSize = 0x90;
  /// Writes of this frame become effective; `address`, `length`: the range that was written.
  void registers_written(std::uint16_t address, std::size_t length, Nanoseconds frame_end);
  /// The usual write: `size` bytes of the system time, 4 or 8.
  void system_time_received(std::uint8_t size, std::uint64_t value, Nanoseconds frame_end) {
    size == sizeof(std::uint64_t) ? memory_.set<std::uint64_t>(reg::kSystemTime, value)
                                  : memory_.set<std::uint32_t>(reg::kSystemTime, static_cast<std::uint32_t>(value));
    compare(static_cast<std::uint32_t>(value), frame_end);
    next_signal_.reset();
  }
  /// 0x092C as it is shown.
  [[nodiscard]] std::uint32_t shown_difference() const {
    const auto difference = loop_.system_time_difference();
    return sign_of_older_edition_ && difference != 0 ? difference ^ kSignBit : difference;
  }
  /// The frame wrote 0x0900: time at the processing unit.
  void latch_processing_unit();
  /// It did so by BWR or FPWR: receive times of the ports it passed.
  void latch_ports(const std::array<std::optional<Nanoseconds>, 4>& passed);

  /// In acknowledge mode (pulse length 0) a signal stays active until the PDI reads its status; no edge before that.
  void acknowledge_sync(SyncGenerator::Signal signal);

  /// The level at a latch input; true when its time was taken.
  bool latch_input(unsigned number, bool level, Nanoseconds time);
  [[nodiscard]] LatchUnit& latches() { return latches_; }

  /// What the device's firmware reads: local time plus offset, no delay.
  [[nodiscard]] std::uint64_t system_time(Nanoseconds time) const;
  [[nodiscard]] bool sync_active() const { return generator_.active(); }
  [[nodiscard]] bool sync0_enabled() const { return settings_.sync0 && generator_.active(); }
  [[nodiscard]] const SyncGenerator::Settings& settings() const { return settings_; }
  /// The unit was activated with a start time that had passed.
  [[nodiscard]] bool start_missed() const { return start_missed_; }
  [[nodiscard]] std::uint32_t deviation_magnitude() const { return loop_.system_time_difference() & 0x7FFF'FFFFU; }

  // Faults.
  void step_clock(Nanoseconds delta, Nanoseconds time);
  /// Somebody adds to 0x0920.
  void step_offset(Nanoseconds delta, Nanoseconds time);
  /// Nothing that is written to 0x0920 to 0x092B takes effect, although it counts as written.
  void ignore_clock_writes(bool ignore);
  /// The receive time of the port stays what it is.
  void stick_port_time(unsigned port, bool stick) { stuck_ports_[port] = stick; }
  /// Start times written from now on are taken so much off.
  void shift_start_times(Nanoseconds by) { start_shift_ = by; }
  /// The cyclic unit is on with SYNC0 only, although nobody has set it up since power-on.
  void leave_sync_running(std::uint32_t cycle, Nanoseconds time);

 private:
  static constexpr std::uint32_t kSignBit = 0x8000'0000;  // of 0x092C

  /// Faster than that the signals cannot be told apart: one level, one edge.
  static constexpr std::uint32_t kShortestCycle = 1000;  // ns

  void deliver_until(Nanoseconds time);
  /// What nobody wanted to know of has come and gone up to now.
  void pass_unminded();
  /// Closed form of delivering for as long as nobody has asked.
  void skip_signals_before(Nanoseconds time);
  [[nodiscard]] std::uint64_t offset() const;
  /// System time that does not wrap; a 32-bit unit shows its low word.
  [[nodiscard]] std::uint64_t unwrapped_time(Nanoseconds time) const { return clock_.exact(time) + offset(); }
  void restore_locked_registers();
  void keep_clock();
  [[nodiscard]] std::uint64_t masked(std::uint64_t value) const { return wide_ ? value : value & 0xFFFF'FFFFU; }
  /// With the low word of the system time that has been received.
  void compare(std::uint32_t received, Nanoseconds frame_end);
  void pulse(SyncGenerator::Signal signal, Nanoseconds time);
  void write_activation(Nanoseconds time);
  /// When the unit activated at `now` fires first, in system time that does not wrap.
  [[nodiscard]] std::optional<std::uint64_t> first_sync0(std::uint64_t now);
  /// A start time written in 32 bits, made the nearest future one of 64.
  void extend_start_time(std::uint64_t now);
  void start_time_written(std::uint16_t address, std::size_t length, Nanoseconds time);
  /// 0x0980: who may write the registers of which unit.
  void follow_ownership();
  void write_status();
  [[nodiscard]] Nanoseconds next_signal();
  /// After what may bring the next SYNC signal forward by more than the time control loop does.
  void signals_moved();
  void implement_registers(std::uint64_t seed);

  SimDcConfig config_;
  SyncGenerator::Settings settings_;
  LatchUnit latches_;
  Random latch_noise_;
  bool start_missed_ = false, start_implausible_ = false;
  std::uint64_t start_time_ = 0;         // of the activation
  std::uint64_t next_when_left_ = 0;     // SYNC0 that was due when they were left unminded, system time
  Nanoseconds quiet_until_ = INT64_MIN;  // no SYNC signal before, whatever the time control loop does

  /// What is kept against all writing: 0x0920 and 0x0928.
  struct KeptClock {
    std::uint64_t offset = 0;
    std::uint32_t delay = 0;
  };
  std::optional<KeptClock> kept_;
  std::array<bool, 4> stuck_ports_{};
  Nanoseconds start_shift_ = 0;

  // Of every frame, and therefore together, in few lines of the processor's cache:
  LocalClock clock_;
  TimeControlLoop loop_;
  SyncGenerator generator_;
  EscMemory& memory_;
  bool wide_;
  bool sign_of_older_edition_;
  bool unminded_ = false;
  std::uint64_t unasked_ = 0;  // of those signals, since the last count_unminded()
  Nanoseconds now_ = 0;        // up to which SYNC signals have been delivered
  /// True time of the next SYNC signal, if there is one; empty after what moves it.
  std::optional<Nanoseconds> next_signal_;
  std::uint64_t local_at_start_of_frame_ = 0;
};

}  // namespace syncline::sim
