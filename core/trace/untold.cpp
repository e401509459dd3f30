// SPDX-License-Identifier: Apache-2.0
#include "trace/untold.h"

#include <algorithm>
#include <array>

#include "trace/sample_store.h"

namespace syncline {

Signal answered_signal(const SampleStore& store) {
  constexpr std::array kSignals{Signal::kRoundTrip, Signal::kDcmError, Signal::kDeviation};
  const auto* found = std::ranges::find_if(kSignals, [&store](Signal signal) {
    return !store.empty() && store.series(signal).extent(store.first_time(), store.last_time() + 1).has_value();
  });
  return found == kSignals.end() ? kSignals.front() : *found;
}

}  // namespace syncline
