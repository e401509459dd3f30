// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/external_clock_reader.h"

namespace syncline {

bool ExternalClockReader::Stamp::goes_on(std::uint64_t shown, Nanoseconds now) {
  constexpr Nanoseconds kStill = 100 * kMillisecond;  // a bridge may renew them more seldom than in each cycle
  if (shown != value) *this = {shown, now};
  return now - changed < kStill;
}

std::optional<Nanoseconds> ExternalClockReader::read(std::span<const std::uint8_t> inputs, Nanoseconds now) {
  const auto times = external_clock_times(place_, inputs);
  if (!times) return std::nullopt;
  const bool internal = internal_.goes_on(times->internal, now), external = external_.goes_on(times->external, now);
  if (!internal || !external) return std::nullopt;
  return times->difference();
}

}  // namespace syncline
