// SPDX-License-Identifier: Apache-2.0
#include "record/run_replay.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "record/replay_run.h"

namespace syncline {

Result<RunReplay> RunReplay::open(RecordingReader reader, ReplayedRun& run) {
  auto blocks = reader.blocks();
  if (!blocks) return tl::unexpected(blocks.error());
  return RunReplay(std::move(reader), run, std::move(*blocks));
}

RunReplay::RunReplay(RecordingReader reader, ReplayedRun& run, std::vector<RecordingReader::Block> blocks)
    : path_(reader.path()),
      reader_(std::move(reader)),
      record_(run.record.get()),
      fresh_(run.record->config()),
      marks_(std::exchange(run.marks, OverviewMarks(blocks.size()))),
      blocks_(std::move(blocks)),
      damage_(reader_->damage()),
      begin_(run.record->samples().first_time()),
      end_(run.record->samples().last_time()),
      overview_(fresh_) {
  bool only_words = false;
  events_ = events_of(run.info, only_words);
  if (run.info.about.armed) fresh_.arm_from(*run.info.about.armed);
  overview_ = fresh_;
  // One that is being written has more by now.
  std::erase_if(blocks_, [this](const RecordingReader::Block& block) { return block.begin > end_; });
}

Status RunReplay::show(Nanoseconds moment) {
  moment = std::clamp(moment, begin_, end_);
  if (auto status = make_overview(moment); !status) {
    leave();
    begin_anew(0);
    return status;
  }
  record_->show_at(moment, overview_.overview());
  return {};
}

void RunReplay::leave() { record_->show_whole(); }

/// From the latest mark before the block on, or from the beginning.
void RunReplay::begin_anew(std::size_t block) {
  const auto* mark = marks_.at(block);
  block_ = mark == nullptr ? 0 : mark->blocks;
  taken_events_ = mark == nullptr ? 0 : mark->events;
  overview_ = mark == nullptr ? fresh_ : mark->overview;
  samples_.clear();
  taken_samples_ = 0;
  taken_until_ = INT64_MIN;
}

Status RunReplay::make_overview(Nanoseconds moment) {
  const auto behind = std::ranges::upper_bound(blocks_, moment, {}, &RecordingReader::Block::begin);
  const auto wanted = behind == blocks_.begin() ? 0 : static_cast<std::size_t>(behind - blocks_.begin()) - 1;
  const auto* mark = marks_.at(wanted);
  if (moment < taken_until_ || (mark != nullptr && mark->blocks > block_)) begin_anew(wanted);
  while (block_ < blocks_.size() && block_ <= wanted) {
    if (auto status = read_current(); !status) return status;
    if (!take(moment)) break;
    marks_.pass(++block_, taken_events_, overview_);
    samples_.clear();
    taken_samples_ = 0;
  }
  // All cycles up to here are in; behind the last one comes what was told when the run had ended.
  const auto until = moment >= end_ ? INT64_MAX : moment;
  for (; taken_events_ < events_.size() && events_[taken_events_].time <= until; ++taken_events_)
    overview_.add(events_[taken_events_]);
  taken_until_ = moment;
  return {};
}

Status RunReplay::read_current() {
  if (!samples_.empty()) return {};
  taken_samples_ = 0;
  if (!reader_) {
    auto reader = RecordingReader::open(path_);
    if (!reader) return tl::unexpected(reader.error());
    reader_.emplace(std::move(*reader));
  }
  auto status = reader_->samples(blocks_[block_], samples_);
  const auto fresh = std::ranges::find_if(
      reader_->damage(), [this](const Finding& found) { return std::ranges::find(damage_, found) == damage_.end(); });
  if (status && fresh != reader_->damage().end()) status = reader_->as_error(*fresh);
  if (!status) samples_.clear();
  return status;
}

bool RunReplay::take(Nanoseconds until) {
  const auto rest = std::span(samples_).subspan(taken_samples_);
  const auto later =
      std::ranges::find_if(rest, [until](const CycleSample& sample) { return sample.send_time > until; });
  const auto count = static_cast<std::size_t>(later - rest.begin());
  add_in_order(overview_, rest.first(count), events_, taken_events_);
  taken_samples_ += count;
  return count == rest.size();
}

}  // namespace syncline
