// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

namespace syncline {

/// The largest peak-to-peak value in any window of 1, 2, 4 ... sampling intervals, of stretches without a gap, as many
/// observation times as `octaves`. Not a number where no stretch is as long. Exact, every window counts; most of them
/// are not looked at, because blocks of samples know that they span less than what was found already. `stop` as in
/// stability_octaves().
template <class Value>
[[nodiscard]] std::vector<double> mtie_octaves(std::span<const std::span<const Value>> stretches, std::size_t octaves,
                                               const std::atomic<bool>* stop);

}  // namespace syncline
