// SPDX-License-Identifier: Apache-2.0
#include "record/watched_columns.h"

#include <bit>
#include <type_traits>
#include <variant>

#include "channels/cycle_sample.h"
#include "support/bits.h"
#include "trace/watch_lists.h"

namespace syncline {
namespace {

std::int64_t cell_of(const WatchedNumber& number) {
  return std::visit(
      [](auto value) -> std::int64_t {
        using Value = decltype(value);
        if constexpr (std::is_same_v<Value, float>) {
          return std::bit_cast<std::uint32_t>(value);
        } else {
          return std::bit_cast<std::int64_t>(value);
        }
      },
      number);
}

}  // namespace

void put_watched_cells(const WatchLists& watched, std::size_t variable, std::span<const CycleSample> samples,
                       Cells& out) {
  out.assign(samples.size(), std::nullopt);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (const auto bits = watched.bits(samples[i], variable))
      out[i] = cell_of(watched_number(watched.variables()[variable], *bits));
  }
}

bool take_watched_cells(const WatchLists& watched, std::size_t variable, const ColumnCells& cells,
                        std::span<CycleSample> samples) {
  const auto size = watched.variables()[variable].bit_size;
  const auto mask = low_bits(size);
  for (std::size_t i = 0; i < cells.integers.size(); ++i) {
    if (!cells.there.empty() && cells.there[i] == 0) continue;
    const auto place = watched.place(samples[i].watch_list, variable);
    if (!place) return false;
    samples[i].watched[*place] = std::bit_cast<std::uint64_t>(cells.integers[i]) & mask;
    samples[i].watched_known = static_cast<std::uint16_t>(samples[i].watched_known | 1U << *place);
  }
  return cells.floats.empty();
}

}  // namespace syncline
