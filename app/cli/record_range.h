// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace CLI {
class App;
}  // namespace CLI

namespace syncline {
struct RecordingInfo;
class RecordingReader;
}  // namespace syncline

namespace syncline::cli {

class Context;

/// A stretch of a recording as it is typed: durations since its beginning.
struct RecordRange {
  std::string from, to;
  [[nodiscard]] bool any() const { return !from.empty() || !to.empty(); }
};
/// [begin, end), host clock.
struct RecordStretch {
  Nanoseconds begin = 0, end = 0;
};

/// What is wrong with a recording that was read, for who takes values out of it: exit code 1 where some are missing.
void warn_of_file(Context& context, const RecordingReader& reader);

/// A duration, or the beginning ("0", "0s"). kBadValue where it is neither.
[[nodiscard]] Result<Nanoseconds> parse_moment(const std::string& text);
/// --from and --to.
void add_range_options(CLI::App& command, RecordRange& range);
/// What is not typed is the recording's own. kBadValue where it is no duration, or nothing of the recording lies in it.
[[nodiscard]] Result<RecordStretch> stretch_of(const RecordRange& range, const RecordingInfo& info);

}  // namespace syncline::cli
