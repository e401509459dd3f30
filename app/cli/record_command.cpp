// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/milliseconds.h"
#include "app/cli/options.h"
#include "app/cli/record_figures.h"
#include "app/cli/record_import.h"
#include "app/cli/record_plot.h"
#include "app/cli/record_range.h"
#include "app/cli/record_report.h"
#include "app/cli/terminal_reason.h"
#include "record/recorded_signals.h"
#include "record/recording_reader.h"
#include "record/trigger_document.h"
#include "support/counted.h"
#include "support/output_file.h"
#include "trace/csv.h"
#include "trace/signal_quality.h"

namespace syncline::cli {
namespace {

struct RecordingOptions {
  std::string file, out, document;
  RecordRange range;
  bool json = false;
};

Json slave_or_null(int slave) { return slave < 0 ? Json(nullptr) : Json(slave); }

Json recording_json(const RecordingInfo& info) {
  Json slaves = Json::array(), documents = Json::array(), events = Json::array(), findings = Json::array(),
       notes = Json::array(), variables = Json::array();
  for (const auto& slave : info.about.slaves) slaves.push_back(slave.name);
  for (const auto& variable : info.about.watched.variables()) {
    variables.push_back({{"name", variable.name},
                         {"slave", slave_or_null(variable.slave)},
                         {"direction", variable.output ? "output" : "input"},
                         {"type", variable.data_type},
                         {"bits", variable.bit_size}});
  }
  for (const auto& document : info.about.documents)
    documents.push_back({{"kind", document.kind}, {"name", document.name}, {"bytes", document.body.size()}});
  for (const auto& event : info.events) {
    events.push_back({{"time_s", seconds(event.time - info.begin)},
                      {"slave", slave_or_null(event.slave)},
                      {"kind", event.kind},
                      {"text", event.text}});
  }
  for (const auto& finding : info.findings) {
    findings.push_back({{"code", finding.code},
                        {"severity", finding.level},
                        {"slave", slave_or_null(finding.slave)},
                        {"text", finding.text}});
  }
  for (const auto& note : info.notes)
    notes.push_back({{"time_s", seconds(note.time - info.begin)}, {"text", note.text}});
  return {
      {"program", info.about.program},
      {"link", info.about.link},
      {"cycle_time_us", static_cast<double>(info.about.limits.cycle_time) / 1000},
      {"limits", {{"deviation_ns", info.about.limits.deviation_ns}, {"dcm_error_ns", info.about.limits.dcm_error_ns}}},
      {"slaves", std::move(slaves)},
      {"documents", std::move(documents)},
      {"variables", std::move(variables)},
      {"cycles", info.cycles},
      {"missing_cycles", info.missing_cycles},
      {"duration_s", seconds(info.end - info.begin)},
      {"ended", info.ended ? Json(*info.ended) : Json(nullptr)},
      {"events", std::move(events)},
      {"findings", std::move(findings)},
      {"notes", std::move(notes)}};
}

/// Values a second of a run that lasted so long; of a count or a state, which stand as changes, none.
std::optional<double> rate_of(const RecordedSignal& of, const RecordingInfo& recording) {
  const bool changes = info(of.signal).form == SignalInfo::Form::kHeld;
  if (changes || recording.end <= recording.begin) return std::nullopt;
  return static_cast<double>(of.values) * 1e9 / static_cast<double>(recording.end - recording.begin);
}

Json signals_json(const RecordedSignals& found, const RecordingInfo& recording) {
  Json rows = Json::array();
  for (const auto& of : found.signals) {
    const auto& row = info(of.signal);
    const auto rate = rate_of(of, recording);
    const auto doubt = value_doubt(row, found.worst_stamp);
    rows.push_back({{"key", row.key},
                    {"slave", slave_or_null(of.slave)},
                    {"unit", row.unit},
                    {"source", row.source},
                    {"values", of.values},
                    {"rate_hz", rate ? Json(std::round(*rate * 1000) / 1000) : Json(nullptr)},
                    {"clock", name_of(row.clock)},
                    {"doubt_ns", doubt ? Json(*doubt) : Json(nullptr)}});
  }
  return rows;
}

Json stamps_json(const RecordedSignals& found) {
  Json by = Json::object();
  for (int source = 0; source < kStampSources; ++source) {
    const auto cycles = found.stamps[static_cast<std::size_t>(source)];
    if (cycles > 0) by[std::string(name_of(static_cast<StampSource>(source)))] = cycles;
  }
  return {{"by", std::move(by)}, {"doubt_ns", found.worst_stamp ? Json(*found.worst_stamp) : Json(nullptr)}};
}

std::string clock_words(SignalInfo::Clock clock) {
  switch (clock) {
    case SignalInfo::Clock::kNone:
      break;
    case SignalInfo::Clock::kHost:
      return ", by the host's clock";
    case SignalInfo::Clock::kSlaves:
      return ", by the clocks of the slaves";
    case SignalInfo::Clock::kBoth:
      return ", by the reference clock and the host's clock";
  }
  return {};
}

std::string signals_text(const RecordedSignals& found, const RecordingInfo& recording) {
  std::string text;
  for (const auto& of : found.signals) {
    const auto& row = info(of.signal);
    const auto rate = rate_of(of, recording);
    text += fmt::format("signal: {}{}: ", row.key, of.slave < 0 ? "" : fmt::format(" of slave {}", of.slave));
    text += rate ? fmt::format("{:.1f} values a second", *rate) : counted(of.values, "change");
    text += clock_words(row.clock);
    if (const auto doubt = value_doubt(row, found.worst_stamp)) text += fmt::format(", within {} ns", *doubt);
    text += '\n';
  }
  for (int source = 0; source < kStampSources; ++source) {
    const auto cycles = found.stamps[static_cast<std::size_t>(source)];
    if (cycles > 0)
      text += fmt::format("stamps: {} by {}\n", counted(cycles, "cycle"), name_of(static_cast<StampSource>(source)));
  }
  if (found.worst_stamp) text += fmt::format("stamps: wrong by {} ns at most\n", *found.worst_stamp);
  return text;
}

Json triggers_json(const RecordingInfo& recording) {
  Json rows = Json::array();
  for (const auto& kept : kept_triggers(recording.about)) {
    Json episodes = Json::array();
    for (const auto& episode : kept.episodes) {
      const auto name = kept.names.find(episode.time);
      episodes.push_back({{"time_s", seconds(episode.time - recording.begin)},
                          {"cycle", episode.cycle ? Json(*episode.cycle) : Json(nullptr)},
                          {"slave", slave_or_null(episode.slave)},
                          {"value", episode.value},
                          {"name", name == kept.names.end() ? "" : name->second}});
    }
    const bool told = kept.trigger.kind == Trigger::Kind::kEvent || kept.trigger.kind == Trigger::Kind::kFinding;
    rows.push_back({{"of", told ? kept.trigger.code : std::string(info(kept.trigger.signal).key)},
                    {"slave", slave_or_null(kept.trigger.slave)},
                    {"episodes", std::move(episodes)}});
  }
  return rows;
}

std::string end_text(const RecordingInfo& info) {
  if (info.ended) return *info.ended;
  return fmt::format("cut short: the program was killed, or still records; whole up to {:.3f} s",
                     seconds(info.end - info.begin));
}

std::string recording_text(const RecordingInfo& info, const RecordedSignals& found) {
  const auto& about = info.about;
  auto text = fmt::format("{} on {}\n{} of {:g} us in {:.3f} s, {} missing\n{}\nend: {}\n", about.program, about.link,
                          counted(info.cycles, "cycle"), static_cast<double>(about.limits.cycle_time) / 1000,
                          seconds(info.end - info.begin), info.missing_cycles, counted(about.slaves.size(), "slave"),
                          end_text(info));
  for (const auto& document : about.documents)
    text += fmt::format("{}: {}, {} bytes\n", document.kind, document.name, document.body.size());
  for (const auto& variable : about.watched.variables()) text += fmt::format("variable: {}\n", variable.name);
  text += signals_text(found, info);
  for (const auto& event : info.events)
    text += fmt::format("{:9.3f} s  {}\n", seconds(event.time - info.begin), event.text);
  for (const auto& finding : info.findings) text += fmt::format("{}: {}\n", finding.level, finding.text);
  for (const auto& note : info.notes)
    text += fmt::format("{:9.3f} s  note: {}\n", seconds(note.time - info.begin), note.text);
  return text;
}

void show_info(Context& context, const RecordingOptions& options) {
  auto reader = RecordingReader::open(options.file);
  if (!reader) return context.fail_with(reader.error());
  auto info = reader->info();
  if (!info) return context.fail_with(info.error());
  const auto found = recorded_signals(*reader, info->about.slaves.size());
  if (!found) return context.fail_with(found.error());
  // What was told together has the time of its first one, and was written when later ones had been.
  std::ranges::stable_sort(info->events, {}, &RecordedEvent::time);
  if (!options.json) {
    context.console.out << recording_text(*info, *found);
    return;
  }
  auto json = recording_json(*info);
  json["signals"] = signals_json(*found, *info);
  json["stamps"] = stamps_json(*found);
  json["triggers"] = triggers_json(*info);
  context.print(json);
}

/// As a run writes it, byte for byte, without what is damaged.
Status write_csv(RecordingReader& reader, const RecordingOptions& options) {
  const auto info = reader.info();
  if (!info) return tl::unexpected(info.error());
  const auto& watched = info->about.watched;
  RecordStretch stretch{INT64_MIN, INT64_MAX};
  if (options.range.any()) {
    const auto typed = stretch_of(options.range, *info);
    if (!typed) return tl::unexpected(typed.error());
    stretch = *typed;
  }
  auto file = OutputFile::create(options.out);
  if (!file) return tl::unexpected(file.error());
  auto status = file->write(sample_csv_header(watched));
  std::string text;
  std::vector<CycleSample> wanted;
  auto read = reader.samples([&](std::span<const CycleSample> samples) {
    wanted.clear();
    text.clear();
    std::ranges::copy_if(samples, std::back_inserter(wanted), [&stretch](const CycleSample& sample) {
      return sample.send_time >= stretch.begin && sample.send_time < stretch.end;
    });
    append_sample_csv(text, wanted, watched);
    status = file->write(text);
    return status.has_value() && samples.front().send_time < stretch.end;
  });
  if (!read) return read;
  return status ? file->finish() : status;
}

Status write_document(RecordingReader& reader, const RecordingOptions& options) {
  const auto info = reader.info();
  if (!info) return tl::unexpected(info.error());
  for (const auto& document : info->about.documents) {
    if (document.kind != options.document) continue;
    auto file = OutputFile::create(options.out);
    if (!file) return tl::unexpected(file.error());
    if (auto status = file->write(document.body); !status) return status;
    return file->finish();
  }
  return fail(ErrorCode::kBadValue, "--document",
              in_terminal("the recording holds a \"project\" and a \"configuration\""));
}

void export_to(Context& context, const RecordingOptions& options) {
  const auto distinct = CommandFiles().reads_recording("file", options.file).writes("out", options.out).check();
  if (!distinct) return context.fail_with(distinct.error());
  auto reader = RecordingReader::open(options.file);
  if (!reader) return context.fail_with(reader.error());
  const auto status = options.document.empty() ? write_csv(*reader, options) : write_document(*reader, options);
  if (!status) context.fail_with(status.error());
  warn_of_file(context, *reader);
}

void verify(Context& context, const RecordingOptions& options) {
  auto reader = RecordingReader::open(options.file);
  const auto blocks = reader ? reader->verify() : Result<std::uint64_t>(tl::unexpected(reader.error()));
  if (!blocks) {
    context.fail_with(blocks.error());
    // What is another kind of file, or none, is no damaged recording.
    if (blocks.error().code == ErrorCode::kFileNotReadable) context.exit_code = kAnswerIsNo;
    return;
  }
  const auto info = reader->info();
  if (!info) return context.fail_with(info.error());
  if (options.json) {
    return context.print({{"whole", true},
                          {"checked", reader->is_checked()},
                          {"cut_short", !info->ended},
                          {"blocks", *blocks},
                          {"cycles", info->cycles}});
  }
  for (const auto& finding : reader->found()) context.warn(finding);
  context.console.out << fmt::format("whole: {}, {}; end: {}\n", counted(*blocks, "block"),
                                     counted(info->cycles, "cycle"), end_text(*info));
}

}  // namespace

void add_record_command(CLI::App& app, Context& context) {
  auto* group = app.add_subcommand("record", "Look at a recording that run --record has written");
  group->require_subcommand(1);
  auto options = std::make_shared<RecordingOptions>();
  auto* show = group->add_subcommand("info", "What was run, how long, what happened and what it means");
  auto* copy = group->add_subcommand("export", "Write the samples as run --csv does, or what was run");
  auto* check = group->add_subcommand("verify", "Read everything and check it; exit code 1 when it is damaged");
  for (auto* command : {show, copy, check}) command->add_option("file", options->file, "Recording")->required();
  copy->add_option("out", options->out, "File to write")->required();
  auto* document =
      copy->add_option("--document", options->document, "Write this document instead: project or configuration");
  add_range_options(*copy, options->range);
  for (const auto* name : {"--from", "--to"}) copy->get_option(name)->excludes(document);
  add_import_command(*group, context);
  auto figures_options = std::make_shared<FiguresOptions>();
  auto* figures = group->add_subcommand(
      "figures", "What the overview shows, and each signal as numbers: of a range, or since the run was armed");
  figures->add_option("file", figures_options->file, "Recording")->required();
  add_range_options(*figures, figures_options->range);
  figures->add_option("--signal", figures_options->signals, "Key of a signal of the bus; may be given several times")
      ->allow_extra_args(false);
  figures->add_flag("--json", figures_options->json, "Print JSON");
  figures->callback([&context, figures_options] { show_figures(context, *figures_options); });
  add_report_command(*group, context);
  add_plot_command(*group, context);
  for (auto* command : {show, check}) command->add_flag("--json", options->json, "Print JSON");
  show->callback([&context, options] { show_info(context, *options); });
  copy->callback([&context, options] { export_to(context, *options); });
  check->callback([&context, options] { verify(context, *options); });
}

}  // namespace syncline::cli
