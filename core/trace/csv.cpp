// SPDX-License-Identifier: Apache-2.0
#include "trace/csv.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "channels/cycle_sample.h"
#include "support/csv_field.h"
#include "trace/signals.h"
#include "trace/watch_lists.h"

namespace syncline {
namespace {

/// New ones at the end: readers of these tables may count columns.
constexpr std::array kCsvColumns{Signal::kCycle,
                                 Signal::kSendTime,
                                 Signal::kLateness,
                                 Signal::kRoundTrip,
                                 Signal::kReferenceTime,
                                 Signal::kDcmError,
                                 Signal::kDcmErrorFiltered,
                                 Signal::kDrift,
                                 Signal::kDcmAdjust,
                                 Signal::kDeviationOred,
                                 Signal::kSlave,
                                 Signal::kSlaveReading,
                                 Signal::kSm2Slave,
                                 Signal::kSm2Reading,
                                 Signal::kWkcExpected,
                                 Signal::kWkcReceived,
                                 Signal::kFrameLost,
                                 Signal::kDcInSync,
                                 Signal::kDcmInSync,
                                 Signal::kNetworkToSlave,
                                 Signal::kMasterToNetwork,
                                 Signal::kFramesLost,
                                 Signal::kFrameLateBy,
                                 Signal::kSkippedCycles,
                                 Signal::kDeviation,
                                 Signal::kSlaveFollows,
                                 Signal::kSyncBase,
                                 Signal::kStampDoubt,
                                 Signal::kExternalError};

}  // namespace

std::string sample_csv_header(const WatchLists& watched) {
  std::string header;
  for (const auto column : kCsvColumns) {
    if (!header.empty()) header += ',';
    header += info(column).key;
  }
  for (const auto& variable : watched.variables()) header += ',' + csv_field(variable.name);
  return header + '\n';
}

void append_sample_csv(std::string& out, std::span<const CycleSample> samples, const WatchLists& watched) {
  const auto put = [&out](auto value) { fmt::format_to(std::back_inserter(out), "{}", value); };
  for (const auto& sample : samples) {
    for (std::size_t i = 0; i < kCsvColumns.size(); ++i) {
      if (i > 0) out += ',';
      if (const auto number = info(kCsvColumns[i]).of_cycle(sample)) std::visit(put, *number);
    }
    for (std::size_t i = 0; i < watched.variables().size(); ++i) {
      out += ',';
      if (const auto bits = watched.bits(sample, i)) std::visit(put, watched_number(watched.variables()[i], *bits));
    }
    out += '\n';
  }
}

}  // namespace syncline
