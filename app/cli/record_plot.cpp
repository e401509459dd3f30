// SPDX-License-Identifier: Apache-2.0
#include "app/cli/record_plot.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/cli/record_range.h"
#include "app/cli/terminal_reason.h"
#include "eni/format/eni_file.h"
#include "record/recorded_configuration.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "reports/run_plots.h"
#include "support/whole_file.h"

namespace syncline::cli {
namespace {

struct PlotOptions {
  std::string file, out, size;
  std::vector<std::string> signals;
  RecordRange range;
};

struct PlotSize {
  int width = 1200, height = 0;
};

/// "1600x800", in pixels; "": as wide as usual, and as high as the plots want to be.
Result<PlotSize> parse_size(const std::string& text) {
  constexpr int kLeast = 100, kMost = 8192;
  PlotSize size;
  if (text.empty()) return size;
  char rest = 0;
  const bool read = std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) == 2;
  const auto fits = [](int side) { return side >= kLeast && side <= kMost; };
  if (read && fits(size.width) && fits(size.height)) return size;
  return fail(
      ErrorCode::kBadValue, "--size " + text,
      in_terminal(fmt::format("it must be a width and a height from {} to {}, such as 1600x800", kLeast, kMost)));
}

Result<std::vector<NamedSignal>> wanted_signals(const PlotOptions& options, const RunRecord& run) {
  if (options.signals.empty()) {
    auto usual = reports::usual_plots(run);
    if (usual.empty()) {
      return fail(ErrorCode::kBadValue, options.file,
                  in_terminal("it has no deviation and no DCM error; name what is to be drawn by --signal"));
    }
    return usual;
  }
  std::vector<NamedSignal> signals;
  for (const auto& text : options.signals) {
    const auto named = named_signal(text, run.samples());
    if (!named) {
      return fail(ErrorCode::kBadValue, "--signal " + text,
                  in_terminal("it is no signal that can be drawn, such as dcm_error_ns, deviation_ns@1 or the name of "
                              "a variable that was watched; \"record info\" lists what there is"));
    }
    if (info(named->signal).scale == SignalInfo::Scale::kBand) {
      return fail(ErrorCode::kBadValue, "--signal " + text,
                  in_terminal("it is a state and has no curve; \"syncline --picture --view free\" draws it as a band"));
    }
    signals.push_back(*named);
  }
  return signals;
}

Status write_plot(Context& context, const PlotOptions& options) {
  const auto size = parse_size(options.size);
  if (!size) return tl::unexpected(size.error());
  const auto distinct = CommandFiles().reads_recording("file", options.file).writes("out", options.out).check();
  if (!distinct) return distinct;
  auto reader = RecordingReader::open(options.file);
  if (!reader) return tl::unexpected(reader.error());
  auto about = reader->info();
  if (!about) return tl::unexpected(about.error());
  const auto stretch = stretch_of(options.range, *about);
  if (!stretch) return tl::unexpected(stretch.error());
  auto config = recorded_configuration(about->about, eni::parse_eni);
  const auto run = replay_run(*reader, std::move(*about), std::move(config));
  if (!run) return tl::unexpected(run.error());
  auto signals = wanted_signals(options, *run->record);
  if (!signals) return tl::unexpected(signals.error());
  warn_of_file(context, *reader);
  return write_whole_file(options.out, reports::plots_svg({.run = *run->record,
                                                           .begin = stretch->begin,
                                                           .end = stretch->end - 1,
                                                           .signals = std::move(*signals),
                                                           .name = std::filesystem::path(options.file).filename(),
                                                           .width = static_cast<double>(size->width),
                                                           .height = static_cast<double>(size->height)}));
}

}  // namespace

void add_plot_command(CLI::App& group, Context& context) {
  auto options = std::make_shared<PlotOptions>();
  auto* command = group.add_subcommand(
      "plot", "Draw signals over time as SVG: deviation, DCM error and missed SM2 events, or what --signal names");
  command->add_option("file", options->file, "Recording")->required();
  command->add_option("out", options->out, "SVG file to write; PNG and PDF are made by syncline --picture")
      ->required()
      ->check([](const std::string& name) {
        return std::string_view(name).ends_with(".svg") ? std::string()
                                                        : "its name must end in .svg; PNG and PDF are made by "
                                                          "\"syncline RUN.slrec --picture\"";
      });
  command
      ->add_option("--signal", options->signals,
                   "Key of a signal of the bus, KEY@POSITION of a slave, or a watched variable; several times for "
                   "several plots")
      ->allow_extra_args(false);
  add_range_options(*command, options->range);
  command->add_option("--size", options->size, "Of the picture in pixels, e.g. 1600x800");
  command->callback([&context, options] {
    if (const auto status = write_plot(context, *options); !status) context.fail_with(status.error());
  });
}

}  // namespace syncline::cli
