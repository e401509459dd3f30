// SPDX-License-Identifier: Apache-2.0
#include "app/cli/record_import.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/milliseconds.h"
#include "app/cli/options.h"
#include "app/cli/record_range.h"
#include "app/cli/terminal_reason.h"
#include "capture/import_capture.h"
#include "record/import_run.h"
#include "support/counted.h"
#include "support/whole_file.h"

namespace syncline::cli {
namespace {

struct ImportOptions {
  std::string file, out;
  RecordRange range;
  ImportLimits limits;
};

constexpr std::size_t kLargestTable = 1U << 30;  // bytes: two hours at 1 kHz

/// What of the file is taken, as it was typed.
Status take_range(ImportOptions& options) {
  if (!options.range.from.empty()) {
    const auto from = parse_moment(options.range.from);
    if (!from) return tl::unexpected(from.error());
    options.limits.from = *from;
  }
  if (options.range.to.empty()) return {};
  const auto to = parse_moment(options.range.to);
  if (!to) return tl::unexpected(to.error());
  if (*to <= options.limits.from) return fail(ErrorCode::kBadValue, "--to", in_terminal("it is not behind --from"));
  options.limits.until = *to;
  return {};
}

/// A capture by its own mark, else a table by its first line.
Result<ImportedRun> imported_run(const ImportOptions& options) {
  auto capture = import_capture(options.file, options.limits);
  if (capture || capture.error().code != ErrorCode::kNotThatKindOfFile) return capture;
  const auto text = read_whole_file(options.file, kLargestTable);
  if (!text) return tl::unexpected(text.error());
  auto table = import_table(*text, std::filesystem::path(options.file).filename().string(), options.limits);
  if (table && (options.range.any() || options.limits.most_frames > 0)) {
    return fail(ErrorCode::kBadValue, options.file,
                in_terminal("--from, --to and --frames are for captures; of a table take the whole, and a range of the "
                            "recording with \"record export\""));
  }
  return table;
}

void import_from(Context& context, ImportOptions& options) {
  const auto distinct = CommandFiles().reads("file", options.file).writes_database("out", options.out).check();
  if (!distinct) return context.fail_with(distinct.error());
  if (const auto status = take_range(options); !status) return context.fail_with(status.error());
  if (const auto status = may_write_recording(options.out); !status) return context.fail_with(status.error());
  const auto run = imported_run(options);
  if (!run) return context.fail_with(run.error());
  if (const auto status = write_recording(*run, options.out); !status) return context.fail_with(status.error());
  for (const auto& finding : run->findings) {
    if (finding.severity == Severity::kNote) {
      context.console.out << describe(finding) << '\n';
      continue;
    }
    context.warn(finding);
    context.exit_code = kAnswerIsNo;
  }
  context.console.out << fmt::format("{} of {:g} us, {:.3f} s\n", counted(run->samples.size(), "cycle"),
                                     static_cast<double>(run->about.limits.cycle_time) / 1000,
                                     seconds(run->samples.back().send_time - run->samples.front().send_time));
}

}  // namespace

void add_import_command(CLI::App& group, Context& context) {
  auto options = std::make_shared<ImportOptions>();
  auto* command = group.add_subcommand(
      "import",
      "Make a recording of a capture, a log of the master synchronisation (EC-Master's, too) or a table of "
      "run --csv");
  command->add_option("file", options->file, "Capture, log or table")->required();
  command->add_option("out", options->out, "Recording to write")->required();
  command->add_option("--from", options->range.from,
                      "Of a capture: begin of what is taken, since its first frame, e.g. 1.5s or 2min");
  command->add_option("--to", options->range.to, "Likewise its end, which is no part of it");
  command->add_option("--frames", options->limits.most_frames, "Of a capture: so many frames at most from there on")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command->add_option("--deviation-limit-ns", options->limits.deviation_ns,
                      "What the slaves' deviation is held against, which no such file tells");
  command->add_option("--dcm-limit-ns", options->limits.dcm_error_ns, "The same of the master's filtered error")
      ->check(CLI::NonNegativeNumber);
  command->callback([&context, options] { import_from(context, *options); });
}

}  // namespace syncline::cli
