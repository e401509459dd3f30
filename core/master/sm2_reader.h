// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "master/cyclic_mailbox.h"
#include "master/sync_error_integrator.h"
#include "master/run_state.h"

namespace syncline {

/// Reads the counters of missed SM2 events of all slaves with SYNC signals, one after the other, through the
/// mailboxes of the running bus, and once the limit that they obey (0x10F1:02). Allocates nothing.
class Sm2Reader {
 public:
  Sm2Reader(RunState& run, CyclicMailbox& mailbox);
  Sm2Reader(const Sm2Reader&) = delete;
  Sm2Reader& operator=(const Sm2Reader&) = delete;

  /// Slaves whose counter is read.
  [[nodiscard]] std::vector<std::size_t> slaves() const;
  /// The sub-index that the object's names gave; see sm2_counter_profile.h.
  void set_sub_index(std::size_t slave, std::uint8_t sub_index);

  /// Begins an upload when its time has come and the mailbox is free.
  void begin(Nanoseconds now);
  void take(const CyclicMailbox::Answer& answer, CycleSample& sample);

 private:
  struct Counter {
    std::uint16_t slave = 0;
    std::uint8_t sub_index = 0;
    bool both = false;       // nobody knows which of the two it is: they are read in turn
    bool other = false;      // 0x0C is being asked for, as the other one of the two
    bool supported = true;
    bool limit_known = false;  // or the slave has none
    SyncErrorIntegrator integrator{};
  };
  void take_limit(const CyclicMailbox::Answer& answer);
  void take_counter(const CyclicMailbox::Answer& answer, CycleSample& sample);
  [[nodiscard]] std::uint64_t sync_cycle(std::size_t slave, std::uint64_t bus_cycle) const;

  RunState& run_;
  CyclicMailbox& mailbox_;
  std::vector<Counter> counters_;
  std::size_t current_ = 0;
  Nanoseconds next_start_ = 0;
};

}  // namespace syncline
