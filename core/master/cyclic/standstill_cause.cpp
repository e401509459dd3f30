// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/standstill_cause.h"

#include <algorithm>

#include "support/clock.h"
#include "support/real_time.h"

namespace syncline {
namespace {

/// Each asking costs a microsecond or two; between two the thread waits some microseconds a cycle anyway.
constexpr unsigned kWaitsPerAsking = 64;

}  // namespace

StandstillCause::StandstillCause(Clock& clock) : clock_(clock) {
  // A thread without priority waits for anybody: then nobody is looked for.
  const int priority = clock.is_virtual() ? 0 : real_time_priority();
  if (priority > 0) search_.emplace(StandstillSearch::Options{.priority = priority});
}

void StandstillCause::before_wait() {
  if (waits_++ % kWaitsPerAsking == 0) waited_ = clock_.processor_wait();
}

void StandstillCause::note(Nanoseconds behind) {
  held_ += behind;
  const auto waited = clock_.processor_wait();
  if (waited && waited_) {
    by_others_ = by_others_.value_or(0) + std::clamp<Nanoseconds>(*waited - *waited_, 0, behind);
  }
  waited_ = waited;
  waits_ = 1;
  if (search_) search_->note_standstill();
}

const ProcessorHolder& StandstillCause::holder() {
  if (search_) (void)search_->read(holder_);
  return holder_;
}

}  // namespace syncline
