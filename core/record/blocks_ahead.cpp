// SPDX-License-Identifier: Apache-2.0
#include "record/blocks_ahead.h"

#include <utility>

namespace syncline {

BlocksAhead::BlocksAhead(RecordingReader& reader, RecordingReader::AllPoints& points)
    : reader_(reader), points_(points), thread_([this] { run(); }) {}

void BlocksAhead::run() {
  const auto read = [this]() -> Status {
    const auto held = reader_.hold();
    if (!held) return tl::unexpected(held.error());
    const auto blocks = reader_.blocks();
    if (!blocks) return tl::unexpected(blocks.error());
    std::vector<CycleSample> samples;
    for (const auto& block : *blocks) {
      if (auto status = reader_.samples(block, samples, points_); !status) return status;
      if (!put(samples)) break;
    }
    return {};
  };
  Status status;
  std::exception_ptr failure;
  try {
    status = read();
  } catch (...) {
    failure = std::current_exception();  // memory that there is not: it ends who takes the blocks, not the program
  }
  const std::lock_guard lock(mutex_);
  status_ = std::move(status);
  failure_ = std::move(failure);
  ended_ = true;
  news_.notify_one();
}

bool BlocksAhead::put(std::vector<CycleSample>& samples) {
  std::unique_lock lock(mutex_);
  room_.wait(lock, [this] { return unwanted_ || ahead_.size() < kMostAhead; });
  if (unwanted_) return false;
  ahead_.push_back(std::move(samples));
  samples.clear();
  if (!used_.empty()) {
    samples = std::move(used_.back());
    used_.pop_back();
  }
  news_.notify_one();
  return true;
}

bool BlocksAhead::next(std::vector<CycleSample>& samples) {
  std::unique_lock lock(mutex_);
  news_.wait(lock, [this] { return ended_ || !ahead_.empty(); });
  if (ahead_.empty()) {
    if (auto failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
    return false;
  }
  if (samples.capacity() > 0) used_.push_back(std::move(samples));
  samples = std::move(ahead_.front());
  ahead_.pop_front();
  room_.notify_one();
  return true;
}

Status BlocksAhead::finish() {
  {
    const std::lock_guard lock(mutex_);
    unwanted_ = true;
  }
  room_.notify_one();
  if (thread_.joinable()) thread_.join();
  return status_;
}

}  // namespace syncline
