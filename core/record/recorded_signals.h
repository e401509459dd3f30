// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "channels/values/stamp_source.h"
#include "record/recording_reader.h"
#include "support/result.h"

namespace syncline {

/// What a recording has of a signal, of the bus or of one slave.
struct RecordedSignal {
  Signal signal = Signal::kCycle;
  int slave = -1;            // -1: the bus
  std::uint64_t values = 0;  // of a count or a state: changes
  bool operator==(const RecordedSignal&) const = default;
};

struct RecordedSignals {
  std::vector<RecordedSignal> signals;  // those that are drawn and have a value, in the order of the table
  std::array<std::uint64_t, kStampSources> stamps{};  // cycles that each of them stamped
  std::optional<Nanoseconds> worst_stamp;             // no stamp is wrong by more; nothing: nobody tells
};

/// Signals of the bus, and the deviation of each slave: out of the sums of the blocks, without their samples. What is
/// damaged counts nothing. kFileNotReadable as the reader's.
[[nodiscard]] Result<RecordedSignals> recorded_signals(RecordingReader& reader, std::size_t slaves);

}  // namespace syncline
