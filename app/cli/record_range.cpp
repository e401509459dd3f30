// SPDX-License-Identifier: Apache-2.0
#include "app/cli/record_range.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/context.h"
#include "app/cli/duration.h"
#include "app/cli/options.h"
#include "reasons/because.h"
#include "record/recording_reader.h"

namespace syncline::cli {

Result<Nanoseconds> parse_moment(const std::string& text) {
  if (text == "0" || text == "0s") return Nanoseconds{0};
  return parse_duration(text);
}

void warn_of_file(Context& context, const RecordingReader& reader) {
  for (const auto& finding : reader.found()) {
    if (finding.severity == Severity::kNote) continue;
    context.warn(finding);
    if (finding.severity == Severity::kError && context.exit_code == kDone) context.exit_code = kAnswerIsNo;
  }
}

void add_range_options(CLI::App& command, RecordRange& range) {
  command.add_option("--from", range.from, "Begin of the range since the recording's, e.g. 1.5s or 2min");
  command.add_option("--to", range.to, "End of the range, likewise; it is no part of it");
}

Result<RecordStretch> stretch_of(const RecordRange& range, const RecordingInfo& info) {
  RecordStretch stretch{info.begin, info.end + 1};
  if (!range.from.empty()) {
    const auto from = parse_moment(range.from);
    if (!from) return tl::unexpected(from.error());
    stretch.begin = info.begin + *from;
  }
  if (!range.to.empty()) {
    const auto to = parse_moment(range.to);
    if (!to) return tl::unexpected(to.error());
    stretch.end = std::min(info.begin + *to, stretch.end);
  }
  if (info.cycles == 0 || stretch.begin >= stretch.end) {
    return fail(ErrorCode::kBadValue, "the range",
                because("it holds nothing of the recording, which is {time} s long",
                        fmt::format("{:.3f}", static_cast<double>(info.end - info.begin) / 1e9)));
  }
  return stretch;
}

}  // namespace syncline::cli
