// SPDX-License-Identifier: Apache-2.0
// When a drive does the same in each cycle, so that its cycles need only be counted.
#include "sim/devices/drive.h"

namespace syncline::sim {

/// A drive without power whose outputs come in time, and stay what they are.
std::optional<Nanoseconds> Drive::repeats() {
  if (habits_.pll || watched_ || axis_.enabled() || !synchronised() || !latches_at_sync0()) return std::nullopt;
  const bool under_way = arriving_ || waiting_ || arrived_ || event_due_ || event_in_time_ || latch_due_;
  if (under_way || integrator_ != 0 || !any_outputs_ || inputs_sync_.shift() > 0) return std::nullopt;
  const bool known = known_command_ && known_command_->outputs == outputs_taken() && known_command_->sync0 &&
                     known_command_->command == axis_.last_command();
  if (!known || !steady_ || !published_ || !plain_inputs_) return std::nullopt;
  if (2 * end_of(inputs_sync_.longest(application_delay())) > dc().settings().cycle0) return std::nullopt;
  return outputs_sync_.longest(application_delay()).calc_and_copy;
}

/// What on_outputs() and on_sync0() would have left.
void Drive::on_cycles_passed(std::uint64_t count, Nanoseconds time) {
  (void)outputs_sync_.pass_cycles(count, application_delay());
  outputs_sync_.set_sync_error(false);
  last_sync_ = time;
  (void)clock_.skip_before(time);
  clock_.restart(time);
  busy_until_ = time + end_of(inputs_sync_.pass_cycles(count, application_delay()));
}

}  // namespace syncline::sim
