// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "trace/watch_lists.h"

namespace syncline {

struct CycleSample;

/// Header line of the sample table: names with units, comma separated; behind them the variables that were watched.
[[nodiscard]] std::string sample_csv_header(const WatchLists& watched = {});
/// Appends one line a sample. Numbers do not depend on the locale; values that are not valid are empty. Those of
/// variables are exact.
void append_sample_csv(std::string& out, std::span<const CycleSample> samples, const WatchLists& watched = {});

}  // namespace syncline
