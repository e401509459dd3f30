// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "channels/cycle_sample.h"

namespace syncline {

/// Cycles one after the other, in little room: what nobody watches takes none.
class SampleChunk {
 public:
  explicit SampleChunk(std::span<const CycleSample> samples);
  [[nodiscard]] std::vector<CycleSample> samples() const;
  [[nodiscard]] std::size_t size() const { return bytes_.size() / stride_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_.size(); }
  [[nodiscard]] Nanoseconds first_time() const { return first_; }
  [[nodiscard]] Nanoseconds last_time() const { return last_; }

 private:
  std::size_t stride_;
  std::vector<std::byte> bytes_;
  Nanoseconds first_, last_;
};

/// A ring of samples within a budget. For one thread; what since() gives is for any.
class RecentSamples {
 public:
  using Chunk = std::shared_ptr<const SampleChunk>;

  /// Bytes; one chunk of cycles at least is kept.
  explicit RecentSamples(std::size_t budget) : budget_(budget) {}
  void add(std::span<const CycleSample> samples);
  void clear();
  /// Bytes; what is beyond goes at once, the oldest first.
  void set_budget(std::size_t budget);
  [[nodiscard]] std::size_t budget() const { return budget_; }

  [[nodiscard]] bool empty() const { return chunks_.empty() && open_.empty(); }
  /// Host clock, of the oldest sample; 0 without any.
  [[nodiscard]] Nanoseconds begin() const;
  /// From the oldest to the newest.
  [[nodiscard]] Nanoseconds span() const;
  /// How long a stretch the budget holds, of samples like the latest.
  [[nodiscard]] Nanoseconds reach(Nanoseconds cycle_time) const;
  /// All that may have samples from `from` on, without copying those that are full.
  [[nodiscard]] std::vector<Chunk> since(Nanoseconds from) const;

 private:
  void forget_beyond();

  std::size_t budget_, bytes_ = 0;  // of the chunks
  std::deque<Chunk> chunks_;
  std::vector<CycleSample> open_;
};

}  // namespace syncline
