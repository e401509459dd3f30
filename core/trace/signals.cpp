// SPDX-License-Identifier: Apache-2.0
#include "trace/signals.h"

namespace syncline {
namespace {

bool has(const CycleSample& sample, CycleSample::Flag flag) { return (sample.flags & flag) != 0; }

std::optional<double> network_to_slave(const CycleSample& sample) {
  if (has(sample, CycleSample::kDeviationValid)) return sample.deviation_ored_ns;
  // Monitored, but not read in this cycle; or no clocks at all.
  return has(sample, CycleSample::kReferenceValid) ? std::nullopt : std::optional(0.0);
}

std::optional<double> master_to_network(const CycleSample& sample) {
  if (has(sample, CycleSample::kReferenceValid)) return sample.dcm_error_ns;
  return has(sample, CycleSample::kDcmActive) ? std::nullopt : std::optional(0.0);
}

constexpr Signal kSignals[] = {{"NetworkToSubDeviceClkDiff", "ns", network_to_slave},
                               {"MdeviceToNetworkClkDiff", "ns", master_to_network}};

}  // namespace

std::span<const Signal> clock_difference_signals() { return kSignals; }

}  // namespace syncline
