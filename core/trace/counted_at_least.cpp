// SPDX-License-Identifier: Apache-2.0
#include "trace/counted_at_least.h"

#include "channels/snapshot.h"

namespace syncline {

bool counted_at_least(const Snapshot& snapshot, Signal signal, std::size_t slave) {
  if (slave >= snapshot.slaves.size()) return false;
  const auto& evidence = snapshot.slaves[slave].evidence;
  const auto number = static_cast<std::size_t>(signal);
  constexpr auto kFirst = static_cast<std::size_t>(Signal::kPortErrors);
  if (number >= kFirst && number < kFirst + kPorts * kPortSignals)
    return evidence.ports[(number - kFirst) / kPortSignals].at_least;
  switch (signal) {
    case Signal::kOutputsExceeded:
      return evidence.outputs.exceeded.at_least;
    case Signal::kInputsExceeded:
      return evidence.inputs.exceeded.at_least;
    case Signal::kOutputsShiftTooShort:
      return evidence.outputs.shift_too_short.at_least;
    case Signal::kInputsShiftTooShort:
      return evidence.inputs.shift_too_short.at_least;
    case Signal::kProcessDataWatchdog:
      return evidence.process_data_watchdog.at_least;
    case Signal::kPdiWatchdog:
      return evidence.pdi_watchdog.at_least;
    case Signal::kProcessingUnitErrors:
      return evidence.processing_unit_errors.at_least;
    case Signal::kPdiErrors:
      return evidence.pdi_errors.at_least;
    default:
      return false;
  }
}

}  // namespace syncline
