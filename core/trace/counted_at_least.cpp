// SPDX-License-Identifier: Apache-2.0
#include "trace/counted_at_least.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "channels/slave_status.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

/// Their order is that of the bits: recordings hold them, so that others come behind.
constexpr std::array kCounters{
    port_signal(0, PortSignal::kInvalidFrames),
    port_signal(1, PortSignal::kInvalidFrames),
    port_signal(2, PortSignal::kInvalidFrames),
    port_signal(3, PortSignal::kInvalidFrames),
    Signal::kOutputsExceeded,
    Signal::kInputsExceeded,
    Signal::kOutputsShiftTooShort,
    Signal::kInputsShiftTooShort,
    Signal::kProcessDataWatchdog,
    Signal::kPdiWatchdog,
    Signal::kProcessingUnitErrors,
    Signal::kPdiErrors,
    Signal::kSm2Missed,
};
static_assert(kCounters.size() <= 24, "series hold whole numbers up to 2^24");

/// In the order of kCounters.
std::array<bool, kCounters.size()> told(const SlaveStatus& slave) {
  const auto& evidence = slave.evidence;
  return {evidence.ports[0].at_least,
          evidence.ports[1].at_least,
          evidence.ports[2].at_least,
          evidence.ports[3].at_least,
          evidence.outputs.exceeded.at_least,
          evidence.inputs.exceeded.at_least,
          evidence.outputs.shift_too_short.at_least,
          evidence.inputs.shift_too_short.at_least,
          evidence.process_data_watchdog.at_least,
          evidence.pdi_watchdog.at_least,
          evidence.processing_unit_errors.at_least,
          evidence.pdi_errors.at_least,
          slave.sm2_missed.at_least};
}

/// The counters of a port share its bit.
Signal counter_of(Signal signal) {
  constexpr auto kFirst = static_cast<std::size_t>(Signal::kPortErrors);
  const auto number = static_cast<std::size_t>(signal);
  if (number < kFirst || number >= kFirst + kPorts * kPortSignals) return signal;
  return port_signal((number - kFirst) / kPortSignals, PortSignal::kInvalidFrames);
}

}  // namespace

std::uint32_t counts_at_least(const SlaveStatus& slave) {
  std::uint32_t bits = 0;
  const auto flags = told(slave);
  for (std::size_t i = 0; i < flags.size(); ++i) bits |= flags[i] ? 1U << i : 0U;
  return bits;
}

std::vector<Signal> counts_in(std::uint32_t bits) {
  std::vector<Signal> counts;
  for (std::size_t i = 0; i < kCounters.size(); ++i) {
    if ((bits >> i & 1U) != 0) counts.push_back(kCounters[i]);
  }
  return counts;
}

bool counted_at_least(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds time) {
  const auto counter = std::ranges::find(kCounters, counter_of(signal));
  if (counter == kCounters.end() || slave >= store.slave_count()) return false;
  const auto bits = store.value(Signal::kCountsAtLeast, slave, time);
  return bits && (static_cast<std::uint32_t>(bits->value) >> std::distance(kCounters.begin(), counter) & 1U) != 0;
}

}  // namespace syncline
