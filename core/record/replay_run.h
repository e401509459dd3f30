// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "record/recording_reader.h"
#include "record/run_record.h"

namespace syncline {

/// A recorded run as it was drawn while it ran: the same samples in the same store, gaps and ages included.
struct ReplayedRun {
  std::unique_ptr<RunRecord> record;
  RecordingInfo info;  // events, findings and notes in their words
};

/// `config`: the recording's own, read from its document "configuration" by who knows ENI files. The latest cycles that
/// `cycle_capacity` allows; 0: as RunRecord. kBadValue when it is another machine's, kFileNotReadable where the
/// recording is damaged.
[[nodiscard]] Result<ReplayedRun> replay_run(RecordingReader& reader, NetworkConfig config,
                                             std::size_t cycle_capacity = 0);

}  // namespace syncline
