// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "channels/frame_ring.h"
#include "record/frame_segments.h"

namespace syncline {

struct Event;
struct NetworkConfig;

/// Keeps the last frames of a run on disk, in a thread of its own: what stands in the ring goes into the files of
/// FrameSegments in the order of time, with what happened as comments. Killed, or without power, they are whole but for
/// the last second.
class BlackBox {
 public:
  struct Options {
    std::string name;                              // see FrameSegments::Options
    std::uint64_t most_bytes = 64ULL << 20;        // of all files together
    std::uint64_t keep_free_bytes = 256ULL << 20;  // of the disk: others need it, too
    bool virtual_time = false;                     // the run waits for the disk, and the same run gives the same files
    std::size_t ring_bytes = FrameRing::kUsualBytes;
    std::string program, link, description;  // who writes, LINK text, what runs
  };
  struct Report {
    std::string name;                // without number and extension
    std::string file;                // written last; "": no frame came yet
    std::size_t files = 0;           // with those of earlier runs
    std::uint64_t bytes = 0;         // of all files
    std::uint64_t frames = 0;        // of this run, in the files
    std::uint64_t replaced = 0;      // of this run, given up for later ones
    std::uint64_t lost = 0;          // that the disk was too slow for
    Nanoseconds begin = 0, end = 0;  // of these frames, host clock
    std::optional<Error> error;      // why it ended before the run
  };

  /// kFileNotWritable as FrameSegments::begin(). `on_stopped` is called once, in the thread that writes, when it ends
  /// before it is told to: kFileNotWritable.
  [[nodiscard]] static Result<std::unique_ptr<BlackBox>> start(std::shared_ptr<FrameRing> ring, const Options& options,
                                                               std::function<void(const Error&)> on_stopped = {});
  /// As finish().
  ~BlackBox();
  BlackBox(const BlackBox&) = delete;
  BlackBox& operator=(const BlackBox&) = delete;

  /// What happened at this time (host clock), for the first frame from then on: any thread. Those of a real run should
  /// come within kHeld; a later one says by how much it is late.
  void note(Nanoseconds time, std::string text);
  /// The same of an event, in its English words; nothing of what only programs care about.
  void note(const Event& event);
  /// The rest is on the disk; frames are no longer kept. The first error of all.
  Status finish();
  /// As of now; any thread.
  [[nodiscard]] Report report() const;

  /// So long a frame waits for what is said of it, and for those sent before it that come later.
  static constexpr Nanoseconds kHeld = 300 * kMillisecond;

 private:
  struct Note {
    Nanoseconds time = 0;
    std::string text;
  };
  struct Held {
    Nanoseconds time = 0;
    FrameDirection direction = FrameDirection::kSent;
    std::uint64_t lost_before = 0;
    std::vector<std::uint8_t> bytes;
  };

  BlackBox(std::shared_ptr<FrameRing> ring, const Options& options, std::unique_ptr<FrameSegments> segments,
           std::function<void(const Error&)> on_stopped);
  void run() noexcept;
  [[nodiscard]] Status begin();
  [[nodiscard]] Status keep(bool ending);
  void stopped(Error error) noexcept;
  void take();
  void hold(const RingFrame& frame);
  [[nodiscard]] Nanoseconds due() const;
  Status write(Nanoseconds until);
  std::vector<std::string> notes_until(Nanoseconds time);
  Status write_rest();
  void publish(const Status& status);

  std::shared_ptr<FrameRing> ring_;
  bool virtual_time_;
  std::unique_ptr<FrameSegments> segments_;
  Error no_memory_;
  std::function<void(const Error&)> on_stopped_;
  // The thread's own.
  std::deque<Held> held_;
  std::size_t held_bytes_ = 0;
  std::deque<Note> taken_;      // notes
  std::uint64_t left_out_ = 0;  // of them
  Nanoseconds newest_ = INT64_MIN, written_ = INT64_MIN;
  std::uint64_t count_ = 0;  // written
  std::uint64_t told_lost_ = 0;
  std::chrono::steady_clock::time_point came_;
  // Shared.
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Note> notes_;
  Report report_;
  bool ending_ = false;
  std::thread thread_;  // last: it uses everything above
};

/// How much time of a run fits into so many bytes: of its cyclic frames, which are nearly all. 0: it has none.
[[nodiscard]] Nanoseconds black_box_reach(const NetworkConfig& config, std::uint64_t bytes);

}  // namespace syncline
