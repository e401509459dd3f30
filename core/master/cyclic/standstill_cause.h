// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "channels/processor_holder.h"
#include "master/cyclic/standstill_search.h"
#include "support/types.h"

namespace syncline {

class Clock;

/// Tells who held the cyclic thread when cycles had to be left out: other threads, for which it had to wait although it
/// was ready, or none, and then it was woken up late: by firmware, or by the host of a virtual machine. On the real
/// clock and with real-time priority it also looks for who that can be. Cyclic thread.
class StandstillCause {
 public:
  explicit StandstillCause(Clock& clock);

  /// Before each wait for a slot. Asks the clock now and then only, so what it knows is a few cycles old.
  void before_wait();
  /// After a wait that ended `behind` its time, so that cycles are left out.
  void note(Nanoseconds behind);
  /// By how much it came too late, all together; and how much of that others took. Empty where that is not known.
  [[nodiscard]] Nanoseconds held() const { return held_; }
  [[nodiscard]] std::optional<Nanoseconds> held_by_others() const { return by_others_; }
  /// Who keeps a processor longest at a time, of those whom the thread's priority does not interrupt.
  [[nodiscard]] const ProcessorHolder& holder();

 private:
  Clock& clock_;
  Nanoseconds held_ = 0;
  std::optional<Nanoseconds> by_others_, waited_;
  unsigned waits_ = 0;
  std::optional<StandstillSearch> search_;
  ProcessorHolder holder_;
};

}  // namespace syncline
