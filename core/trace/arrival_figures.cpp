// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_figures.h"

#include <algorithm>
#include <cmath>

#include "trace/min_max_series.h"

namespace syncline {

ArrivalFigures arrival_figures(const MinMaxSeries& phase, Nanoseconds period, Nanoseconds begin, Nanoseconds end,
                               std::size_t bins) {
  ArrivalFigures figures;
  figures.bins.resize(bins);
  std::vector<Nanoseconds> margins;
  phase.for_each(begin, end, [&](Nanoseconds time, float value) {
    if (std::isnan(value)) return;
    const auto place = std::clamp<Nanoseconds>(static_cast<Nanoseconds>(value), 0, period - 1);
    auto& bin = figures.bins[static_cast<std::size_t>(place * static_cast<Nanoseconds>(bins) / period)];
    ++bin.count;
    bin.newest = time;
    margins.push_back(place == 0 ? 0 : period - place);
  });
  figures.count = margins.size();
  if (margins.empty()) return figures;
  figures.margin_min = *std::ranges::min_element(margins);
  const auto rank = static_cast<std::ptrdiff_t>(margins.size() / 1000);
  std::nth_element(margins.begin(), margins.begin() + rank, margins.end());
  figures.margin_p999 = margins[static_cast<std::size_t>(rank)];
  return figures;
}

}  // namespace syncline
