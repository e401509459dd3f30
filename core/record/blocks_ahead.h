// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "record/recording_reader.h"
#include "support/attempt.h"

namespace syncline {

/// Reads the blocks of a recording in their order in a thread of its own, some ahead of who takes them: what is done
/// with one is done while the next is read. The reader is this thread's until finish() or the end of the object.
class BlocksAhead {
 public:
  /// Both must outlive it. `points`: see RecordingReader::samples().
  BlocksAhead(RecordingReader& reader, RecordingReader::AllPoints& points);
  BlocksAhead(const BlocksAhead&) = delete;
  BlocksAhead& operator=(const BlocksAhead&) = delete;
  ~BlocksAhead() {
    attempt([this] { return finish(); });
  }

  /// The next one, in place of what is in `samples`, whose memory is used again; false: there is no further one, or it
  /// cannot be read. What was thrown while it was read is thrown here.
  bool next(std::vector<CycleSample>& samples);
  /// Reads no further; why it could not be read to the end, or to where it was taken.
  [[nodiscard]] Status finish();

 private:
  static constexpr std::size_t kMostAhead = 4;
  void run();
  /// Waits for room; false: no more is wanted.
  bool put(std::vector<CycleSample>& samples);

  RecordingReader& reader_;
  RecordingReader::AllPoints& points_;
  std::mutex mutex_;
  std::condition_variable news_, room_;
  std::deque<std::vector<CycleSample>> ahead_;
  std::vector<std::vector<CycleSample>> used_;
  bool ended_ = false, unwanted_ = false;
  Status status_;
  std::exception_ptr failure_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace syncline
