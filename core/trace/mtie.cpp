// SPDX-License-Identifier: Apache-2.0
#include "trace/mtie.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "support/large_pages.h"

namespace syncline {
namespace {

constexpr std::size_t kPart = 8, kBlock = 64;  // samples; powers of two

template <class Value>
struct Extremes {
  Value high = std::numeric_limits<Value>::lowest(), low = std::numeric_limits<Value>::max();
  void add(Value value) {
    high = std::max(high, value);
    low = std::min(low, value);
  }
  void add(const Extremes& other) {
    high = std::max(high, other.high);
    low = std::min(low, other.low);
  }
  [[nodiscard]] Value span() const { return high - low; }
};

/// Short windows: those of one length are made of two of half of it, at every sample.
template <class Value>
class DoublingWindows {
 public:
  explicit DoublingWindows(std::span<const Value> x) {
    for (auto* values : {&high_, &low_}) {
      reserve_in_large_pages(*values, x.size());
      values->assign(x.begin(), x.end());
    }
  }

  /// Windows of length + 1 samples, which is `length` intervals; nothing when the stretch is too short.
  [[nodiscard]] std::optional<double> largest_span() const {
    if (high_.size() < 2) return std::nullopt;
    Value result = 0;
    for (std::size_t i = 0; i + 1 < high_.size(); ++i)
      result = std::max(result, std::max(high_[i], high_[i + 1]) - std::min(low_[i], low_[i + 1]));
    return static_cast<double>(result);
  }
  /// From windows of `length` samples to twice as many; false when there are none.
  bool widen(std::size_t length) {
    if (high_.size() <= length) return false;
    const auto left = high_.size() - length;
    auto* high = high_.data();
    auto* low = low_.data();
    for (std::size_t i = 0; i < left; ++i) high[i] = std::max(high[i], high[i + length]);
    for (std::size_t i = 0; i < left; ++i) low[i] = std::min(low[i], low[i + length]);
    high_.resize(left);
    low_.resize(left);
    return true;
  }

 private:
  std::vector<Value> high_, low_;
};

/// Long windows, of whole blocks of intervals: each begins in a block, holds the next ones, and ends in one.
template <class Value>
class BlockWindows {
 public:
  explicit BlockWindows(std::span<const Value> x) : x_(x) {
    parts_.resize((x.size() + kPart - 1) / kPart);
    for (std::size_t i = 0; i < x.size(); ++i) parts_[i / kPart].add(x[i]);
    blocks_.resize((x.size() + kBlock - 1) / kBlock);
    for (std::size_t i = 0; i < parts_.size(); ++i) blocks_[i * kPart / kBlock].add(parts_[i]);
    inner_ = blocks_;
  }

  /// Windows of `count` blocks of intervals, a power of two; asked for rising counts, none left out. Nothing when the
  /// stretch is too short.
  [[nodiscard]] std::optional<double> largest_span(std::size_t count) {
    if (count > 2) widen(count / 4);
    const auto length = count * kBlock;
    if (x_.size() <= length) return std::nullopt;
    Value best = 0;
    for (std::size_t first = 0; first * kBlock + length < x_.size(); ++first) {
      // Whatever is in the blocks at both ends: no window from here spans more.
      const auto between = inner(first, count);
      auto most = between;
      most.add(blocks_[first]);
      most.add(blocks_[first + count]);
      if (most.span() > best) best = look(first, count, between, best);
    }
    return static_cast<double>(best);
  }

 private:
  /// Of windows of twice `length` blocks.
  void widen(std::size_t length) {
    if (inner_.size() <= length) return inner_.clear();
    const auto left = inner_.size() - length;
    for (std::size_t i = 0; i < left; ++i) inner_[i].add(inner_[i + length]);
    inner_.resize(left);
  }
  /// The blocks between the two at the ends of windows from `first`: two windows of half of `count` that overlap.
  [[nodiscard]] Extremes<Value> inner(std::size_t first, std::size_t count) const {
    if (count == 1) return {};
    const auto half = count / 2;
    auto result = inner_[first + 1];
    result.add(inner_[first + count - half]);
    return result;
  }
  /// Each window that begins in a block and may span more than `best`; parts of the block are asked first.
  [[nodiscard]] Value look(std::size_t first, std::size_t count, const Extremes<Value>& between, Value best) const {
    constexpr std::size_t kPartsABlock = kBlock / kPart;
    const auto begin = first * kPartsABlock, end = begin + count * kPartsABlock;
    Extremes<Value> behind[kPartsABlock];  // from behind a part to the end of its block
    for (std::size_t part = kPartsABlock - 1; part-- > 0;) {
      behind[part] = behind[part + 1];
      behind[part].add(parts_[begin + part + 1]);
    }
    auto around = between;
    for (std::size_t part = 0; part < kPartsABlock && (end + part) * kPart < x_.size(); ++part) {
      auto inside = around;
      inside.add(behind[part]);
      auto most = inside;
      most.add(parts_[begin + part]);
      most.add(parts_[end + part]);
      if (most.span() > best) best = std::max(best, look_closely(begin + part, end + part, inside));
      around.add(parts_[end + part]);
    }
    return best;
  }
  /// Windows from each sample of a part to the sample as far in another one; `inside`: what all of them hold.
  [[nodiscard]] Value look_closely(std::size_t first, std::size_t last, const Extremes<Value>& inside) const {
    const auto begin = first * kPart, end = last * kPart;
    Extremes<Value> from[kPart];
    auto rest = inside;
    for (std::size_t i = kPart; i-- > 0;) {
      rest.add(x_[begin + i]);
      from[i] = rest;
    }
    Value best = 0;
    Extremes<Value> until;
    for (std::size_t i = 0; i < std::min(kPart, x_.size() - end); ++i) {
      until.add(x_[end + i]);
      auto window = from[i];
      window.add(until);
      best = std::max(best, window.span());
    }
    return best;
  }

  std::span<const Value> x_;
  std::vector<Extremes<Value>> parts_, blocks_, inner_;
};

bool is_to_stop(const std::atomic<bool>* stop) { return stop != nullptr && stop->load(std::memory_order_relaxed); }

template <class Value>
void add_mtie(std::span<const Value> stretch, std::vector<double>& result, const std::atomic<bool>* stop) {
  const auto note = [&](std::size_t octave, double span) {
    if (!(result[octave] >= span)) result[octave] = span;
  };
  std::size_t octave = 0;
  {
    DoublingWindows<Value> windows(stretch);
    for (std::size_t length = 1; length < kBlock && octave < result.size(); ++octave, length *= 2) {
      if (is_to_stop(stop)) return;
      const auto span = windows.largest_span();
      if (!span) return;
      note(octave, *span);
      if (!windows.widen(length)) return;
    }
  }
  BlockWindows<Value> windows(stretch);
  for (std::size_t count = 1; octave < result.size() && !is_to_stop(stop); ++octave, count *= 2) {
    const auto span = windows.largest_span(count);
    if (!span) return;
    note(octave, *span);
  }
}

}  // namespace

template <class Value>
std::vector<double> mtie_octaves(std::span<const std::span<const Value>> stretches, std::size_t octaves,
                                 const std::atomic<bool>* stop) {
  std::vector<double> result(octaves, std::numeric_limits<double>::quiet_NaN());
  for (const auto& stretch : stretches) add_mtie(stretch, result, stop);
  return result;
}

template std::vector<double> mtie_octaves<float>(std::span<const std::span<const float>>, std::size_t,
                                                 const std::atomic<bool>*);
template std::vector<double> mtie_octaves<double>(std::span<const std::span<const double>>, std::size_t,
                                                  const std::atomic<bool>*);

}  // namespace syncline
