// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "record/column_codec.h"

/// How the values of watched variables lie in a recording: whole numbers as they are, those of 64 bits without a sign
/// wrapped; of REAL and LREAL their bits. Nothing of them is lost.
namespace syncline {

struct CycleSample;
class WatchLists;

void put_watched_cells(const WatchLists& watched, std::size_t variable, std::span<const CycleSample> samples,
                       Cells& out);
/// Puts them back, as many as there are samples, whose `watch_list` says where. False where a sample has a value whose
/// list does not have the variable.
[[nodiscard]] bool take_watched_cells(const WatchLists& watched, std::size_t variable, const ColumnCells& cells,
                                      std::span<CycleSample> samples);

}  // namespace syncline
