// SPDX-License-Identifier: Apache-2.0
#include "record/recorded_signals.h"

#include <algorithm>
#include <cmath>

namespace syncline {
namespace {

using Form = SignalInfo::Form;

/// Visits the cells of a column that has whole numbers, in all blocks; those that cannot be read are passed over.
template <class Take>
Status each_cell_of(RecordingReader& reader, std::span<const RecordingReader::Block> blocks, Signal column,
                    Take&& take) {
  ColumnCells cells;
  for (const auto& block : blocks) {
    const auto status = reader.cells(block, column, cells);
    if (!status && status.error().code != ErrorCode::kFileNotReadable) return status;
    if (!status) continue;
    for (std::size_t i = 0; i < cells.integers.size(); ++i) {
      if (cells.there.empty() || cells.there[i] != 0) take(cells.integers[i]);
    }
  }
  return {};
}

Result<RecordedSignal> of_bus(RecordingReader& reader, Signal signal, std::optional<double>& largest) {
  const auto sums = reader.overview(signal);
  if (!sums) return tl::unexpected(sums.error());
  RecordedSignal found{signal, -1, 0};
  for (const auto& block : *sums) {
    found.values += static_cast<std::uint64_t>(std::max<std::int64_t>(block.count, 0));
    if (block.count > 0) largest = std::max(largest.value_or(block.max), block.max);
  }
  return found;
}

}  // namespace

Result<RecordedSignals> recorded_signals(RecordingReader& reader, std::size_t slaves) {
  RecordedSignals found;
  const auto blocks = reader.blocks();
  if (!blocks) return tl::unexpected(blocks.error());
  for (const auto& row : signals()) {
    if (row.scope != SignalInfo::Scope::kBus || row.form == Form::kCell) continue;
    std::optional<double> largest;
    const auto counted = of_bus(reader, row.id, largest);
    if (!counted) return tl::unexpected(counted.error());
    if (counted->values > 0) found.signals.push_back(*counted);
    if (row.id == Signal::kStampDoubt && largest) found.worst_stamp = std::llround(*largest);
  }
  // Who was read in a cycle stands in a column of its own; the reference clock is among them.
  std::vector<std::uint64_t> readings(slaves);
  auto status = each_cell_of(reader, *blocks, Signal::kSlave, [&readings](std::int64_t slave) {
    if (slave >= 0 && static_cast<std::size_t>(slave) < readings.size()) ++readings[static_cast<std::size_t>(slave)];
  });
  if (!status) return tl::unexpected(status.error());
  for (std::size_t slave = 0; slave < slaves; ++slave) {
    if (readings[slave] > 0)
      found.signals.push_back({Signal::kSlaveDeviation, static_cast<int>(slave), readings[slave]});
  }
  status = each_cell_of(reader, *blocks, Signal::kStampedBy, [&found](std::int64_t source) {
    if (source >= 0 && source < kStampSources) ++found.stamps[static_cast<std::size_t>(source)];
  });
  if (!status) return tl::unexpected(status.error());
  return found;
}

}  // namespace syncline
