// SPDX-License-Identifier: Apache-2.0
#include "record/recent_samples.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace syncline {
namespace {

constexpr std::size_t kChunkCycles = 4096;
/// What watched variables add to a sample stands at its end.
constexpr std::size_t kUnwatched = offsetof(CycleSample, watched_known);
static_assert(std::is_trivially_copyable_v<CycleSample> && std::is_standard_layout_v<CycleSample>);
static_assert(offsetof(CycleSample, watch_list) > kUnwatched && offsetof(CycleSample, watched) > kUnwatched);

bool watches(const CycleSample& sample) { return sample.watch_list != 0; }

}  // namespace

SampleChunk::SampleChunk(std::span<const CycleSample> samples)
    : stride_(std::ranges::any_of(samples, watches) ? sizeof(CycleSample) : kUnwatched),
      bytes_(samples.size() * stride_),
      first_(samples.front().send_time),
      last_(samples.back().send_time) {
  for (std::size_t i = 0; i < samples.size(); ++i) std::memcpy(&bytes_[i * stride_], &samples[i], stride_);
}

std::vector<CycleSample> SampleChunk::samples() const {
  std::vector<CycleSample> samples(size());
  for (std::size_t i = 0; i < samples.size(); ++i) std::memcpy(&samples[i], &bytes_[i * stride_], stride_);
  return samples;
}

void RecentSamples::add(std::span<const CycleSample> samples) {
  while (!samples.empty()) {
    if (open_.capacity() < kChunkCycles) open_.reserve(kChunkCycles);
    const auto count = std::min(samples.size(), kChunkCycles - open_.size());
    open_.insert(open_.end(), samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    samples = samples.subspan(count);
    if (open_.size() < kChunkCycles) return;
    chunks_.push_back(std::make_shared<const SampleChunk>(open_));
    bytes_ += chunks_.back()->bytes();
    open_.clear();
    forget_beyond();
  }
}

void RecentSamples::forget_beyond() {
  for (; bytes_ > budget_ && chunks_.size() > 1; chunks_.pop_front()) bytes_ -= chunks_.front()->bytes();
}

void RecentSamples::set_budget(std::size_t budget) {
  budget_ = budget;
  forget_beyond();
}

void RecentSamples::clear() {
  chunks_.clear();
  bytes_ = 0;
  open_.clear();
}

Nanoseconds RecentSamples::begin() const {
  if (!chunks_.empty()) return chunks_.front()->first_time();
  return open_.empty() ? 0 : open_.front().send_time;
}

Nanoseconds RecentSamples::span() const {
  if (empty()) return 0;
  return (open_.empty() ? chunks_.back()->last_time() : open_.back().send_time) - begin();
}

Nanoseconds RecentSamples::reach(Nanoseconds cycle_time) const {
  const auto of_chunk = chunks_.empty() ? kChunkCycles * kUnwatched : chunks_.back()->bytes();
  return static_cast<Nanoseconds>(std::max<std::size_t>(budget_ / of_chunk, 1) * kChunkCycles) * cycle_time;
}

std::vector<RecentSamples::Chunk> RecentSamples::since(Nanoseconds from) const {
  std::vector<Chunk> result;
  for (const auto& chunk : chunks_) {
    if (chunk->last_time() >= from) result.push_back(chunk);
  }
  if (!open_.empty()) result.push_back(std::make_shared<const SampleChunk>(open_));
  return result;
}

}  // namespace syncline
