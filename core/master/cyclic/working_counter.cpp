// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/working_counter.h"

#include <utility>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_states.h"

namespace syncline {

/// What is behind a pause is another spell, however like the one before it looks.
void WorkingCounter::set_judging(bool judging) {
  if (!judging) pause();
  judging_ = judging;
}

void WorkingCounter::end_spell(Nanoseconds time) {
  const auto count = std::exchange(spell_, 0);
  if (count > 1) teller_.tell(time, -1, events::WkcError{last_expected_, last_wrong_, count});
}

void WorkingCounter::observe(std::uint16_t expected, std::uint16_t received, Nanoseconds time, CycleSample& sample) {
  sample.wkc_expected = expected;
  sample.wkc_received = received;
  // A lost frame is told as such, not a second time as a counter of zero.
  if (!judging_ || (sample.flags & CycleSample::kFrameLost) != 0) return;
  // Who comes back counts before anybody has looked at him.
  if (expected == received || (received > expected && (joining_ || states_.somebody_absent()))) {
    return end_spell(time);
  }
  sample.flags |= CycleSample::kWkcError;
  ++snapshot_.wkc_errors;
  last_wrong_ = received;
  last_expected_ = expected;
  last_time_ = time;
  if (spell_++ == 0) teller_.tell(time, -1, events::WkcError{expected, received, 1});
}

}  // namespace syncline
