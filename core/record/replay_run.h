// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "record/recording_reader.h"
#include "record/run_record.h"

namespace syncline {

/// A recorded run as it was drawn while it ran: the same samples in the same store, gaps and ages included, the same
/// events and findings. Its figures and faults are those from the later of two moments on: when the run was armed last,
/// and where the recording begins.
struct ReplayedRun {
  std::unique_ptr<RunRecord> record;
  RecordingInfo info;  // events, findings and notes in their words
  /// Of events and findings only the words are known: an older program, or a newer one, has recorded them.
  bool only_words = false;
};

struct ReplayOptions {
  /// The latest so many cycles are drawn; 0: all up to kMostCycles.
  std::size_t cycle_capacity = 0;
  /// After each block, with the cycles read of all; false: no more, kCancelled.
  std::function<bool(std::uint64_t done, std::uint64_t all)> progress{};

  static constexpr std::size_t kMostCycles = 1U << 24;  // some 1.2 GB
};

/// `config`: the recording's own, read from its document "configuration" by who knows ENI files. kBadValue when it is
/// another machine's, kFileNotReadable where the recording is damaged, kCancelled.
[[nodiscard]] Result<ReplayedRun> replay_run(RecordingReader& reader, NetworkConfig config,
                                             const ReplayOptions& options = {});
/// The same where the reader's info() is known already.
[[nodiscard]] Result<ReplayedRun> replay_run(RecordingReader& reader, RecordingInfo info, NetworkConfig config,
                                             const ReplayOptions& options = {});

}  // namespace syncline
