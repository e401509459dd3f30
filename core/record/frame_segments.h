// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

struct PcapngPacket;

/// The files of a black box: pcapng, one behind the other, under their names from the begin, so that they outlive a
/// kill. NAME_00001_20260131235959.pcapng is the name of a file in a set to Wireshark (File Set): number, and UTC of
/// its first frame. Each is a kSegments-th of the size at most; the oldest goes before a new one would make them more
/// bytes than wanted. Those of earlier runs are part of the box, and numbers go on behind them. For one thread.
class FrameSegments {
 public:
  static constexpr std::uint64_t kSegments = 16;
  static constexpr std::uint64_t kLeastBytes = 1ULL << 20;

  struct Options {
    std::string name;  // with its folder; a folder alone: "black-box" in it
    std::uint64_t most_bytes = 0;
    std::uint64_t keep_free_bytes = 0;  // of the disk
    bool sync = false;                  // to the disk once a second, which outlives a power cut, too
    std::string program;                // what wrote it, "synclinectl 0.1.0"
    std::string interface;              // LINK text
    std::string description;            // what ran
  };
  struct Segment {
    std::string path;
    std::uint64_t number = 0, bytes = 0;
    std::uint64_t frames = 0, lost = 0;  // 0: of an earlier run
    Nanoseconds begin = 0, end = 0;      // of its first and its last frame
  };

  explicit FrameSegments(Options options);
  ~FrameSegments();
  FrameSegments(const FrameSegments&) = delete;
  FrameSegments& operator=(const FrameSegments&) = delete;

  /// Looks what is there. kFileNotWritable: no such folder, not enough room on the disk, or another program is writing
  /// to a box of this name.
  Status begin();
  /// Gathers; kFileNotWritable when it had to write and could not.
  Status add(const PcapngPacket& packet);
  /// Gives the system what was gathered, in whole blocks. kFileNotWritable: the disk has no room, or the file is gone;
  /// what was given before stays whole.
  Status flush();
  /// Closes the last file. `notes`: what no packet came after.
  Status finish(std::span<const std::string> notes, std::uint64_t lost);

  /// In their order, the one in work last.
  [[nodiscard]] const std::deque<Segment>& segments() const { return segments_; }
  [[nodiscard]] const std::string& name() const { return options_.name; }

 private:
  Status open(Nanoseconds time);
  Status close(std::span<const std::string> notes, std::uint64_t lost);
  Status write();
  Status check_disk() const;
  Status remove_oldest();
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] std::uint64_t segment_bytes() const { return options_.most_bytes / kSegments; }

  Options options_;
  std::deque<Segment> segments_;
  std::uint64_t next_number_ = 1;
  std::vector<std::uint8_t> gathered_;
  std::uint64_t given_ = 0;  // bytes of the file in work that the system has
  std::chrono::steady_clock::time_point synced_;
  int descriptor_ = -1;
};

}  // namespace syncline
