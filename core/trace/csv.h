// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "channels/cycle_sample.h"

namespace syncline {

/// Header line of the sample table: names with units, comma separated.
[[nodiscard]] std::string sample_csv_header();
/// Appends one line a sample. Numbers do not depend on the locale; values that are not valid are empty.
void append_sample_csv(std::string& out, std::span<const CycleSample> samples);

}  // namespace syncline
