// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "support/result.h"
#include "support/types.h"
#include "trace/min_max_series.h"
#include "trace/signals.h"

namespace syncline {

class RecordingReader;
struct SeriesColumn;

/// The first picture of a recording, long before its samples are read: what MinMaxSeries::columns() of its samples
/// gives for [begin, end) with columns of `width` ns (host clock), of each of the signals. Smallest and largest values
/// are exact: they come out of the sums of whole blocks, and where a column ends within a block, of what it holds of
/// fewer cycles. `last` of a column is not looked for, and not-a-number.
///
/// `signals`: of the bus, with a value in every cycle, and columns of recordings themselves (sample_columns()). Sooner
/// than the file's bytes are read: each sum that is used is held against its check, the cells below it are not looked
/// at. `gaps`: blocks, by their place in RecordingReader::blocks(), whose samples are known to be damaged; they are
/// left out, as they are when all samples are drawn. Of a run whose times went back within a second the cycles that no
/// plot shows may be in their column. kFileNotReadable where it is damaged.
[[nodiscard]] Result<std::vector<std::vector<SeriesColumn>>> first_columns(RecordingReader& reader,
                                                                           std::span<const Signal> signals,
                                                                           Nanoseconds begin, Nanoseconds end,
                                                                           Nanoseconds width,
                                                                           const std::set<std::size_t>& gaps = {});

}  // namespace syncline
