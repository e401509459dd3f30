// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/standstill_cause.h"

#include <algorithm>

namespace syncline {
namespace {

/// Each asking costs a microsecond or two; between two the thread waits some microseconds a cycle anyway.
constexpr unsigned kWaitsPerAsking = 64;

}  // namespace

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
}

}  // namespace syncline
