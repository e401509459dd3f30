// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/frame_exchange.h"
#include "master/run_state.h"

namespace syncline {

/// Reads the counters of missed SM2 events of all slaves with SYNC signals, one after the other, by SDO
/// uploads that take one step a cycle. Rides in the acyclic frame and allocates nothing.
class Sm2Reader {
 public:
  explicit Sm2Reader(RunState& run);
  Sm2Reader(const Sm2Reader&) = delete;
  Sm2Reader& operator=(const Sm2Reader&) = delete;

  /// Off while others use the mailboxes; a transfer under way is still finished.
  void set_enabled(bool enabled) { enabled_ = enabled; }
  [[nodiscard]] bool idle() const { return step_ == Step::kIdle; }
  /// Slaves whose counter is read.
  [[nodiscard]] std::vector<std::size_t> slaves() const;
  /// The sub-index that the object's names gave; see sm2_counter_profile.h.
  void set_sub_index(std::size_t slave, std::uint8_t sub_index);

  void add_to(PendingFrame& frame, Nanoseconds now);
  void take(Nanoseconds time, CycleSample& sample);

 private:
  enum class Step : std::uint8_t { kIdle, kWrite, kPoll, kRead };
  struct Counter {
    std::uint16_t slave = 0;
    std::uint8_t sub_index = 0;
    bool supported = true;
  };
  void begin(Nanoseconds now);
  void write_request();
  void take_message(Nanoseconds time, CycleSample& sample);
  void take_value(std::uint32_t value, CycleSample& sample);
  [[nodiscard]] const SlaveConfig& slave() const { return run_.config().slaves[counters_[current_].slave]; }

  RunState& run_;
  std::vector<Counter> counters_;
  std::size_t current_ = 0;
  Step step_ = Step::kIdle;
  bool enabled_ = false;
  Nanoseconds next_start_ = 0, give_up_ = 0;
  std::vector<std::uint8_t> mailbox_;        // the longest of all
  std::array<std::uint8_t, 1> status_{};
  std::optional<Datagram> datagram_;
  bool asked_ = false;
};

}  // namespace syncline
