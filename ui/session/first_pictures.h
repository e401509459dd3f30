// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "record/recording_reader.h"
#include "support/types.h"
#include "trace/min_max_series.h"

namespace syncline::ui {

/// Curves over a stretch of a recording whose samples are not read yet.
struct FirstPicture {
  std::vector<Signal> signals;  // see first_columns()
  Nanoseconds begin = 0, end = 0, width = 0;
  std::vector<std::vector<SeriesColumn>> columns{};  // by signal; what is asked for has none
};

/// What is to be drawn of a recording while it is read: asked for by the window, made by the thread that reads, between
/// two blocks. Nobody waits for anybody.
class FirstPictures {
 public:
  /// In place of what was asked for before, and of nothing. The window's thread.
  void ask(std::vector<FirstPicture> pictures);
  /// What was asked for since, made; nothing where nothing was, or the file cannot be read: who reads it whole tells
  /// why. The reading thread.
  [[nodiscard]] std::optional<std::vector<FirstPicture>> answer(const std::string& path);
  /// A block whose samples cannot be read, see first_columns(). The reading thread.
  void leaveOut(std::size_t block) { gaps_.insert(block); }
  /// Where something is left out since the last answer, that is given anew. The reading thread.
  void renew() { renewed_ = gaps_.size() != answered_gaps_; }
  /// Another recording is read next. While none is.
  void forget();

 private:
  std::mutex mutex_;
  std::vector<FirstPicture> asked_;
  std::atomic<bool> any_{false};
  // The reading thread's.
  std::optional<RecordingReader> reader_;
  std::vector<FirstPicture> answered_;  // without columns
  std::set<std::size_t> gaps_;
  std::size_t answered_gaps_ = 0;
  bool renewed_ = false;
};

}  // namespace syncline::ui
