// SPDX-License-Identifier: Apache-2.0
#include "app/cli/record_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "app/cli/context.h"
#include "app/cli/interval_json.h"
#include "app/cli/milliseconds.h"
#include "app/cli/terminal_reason.h"
#include "channels/event_text.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "support/counted.h"
#include "trace/range_figures.h"
#include "trace/slaves_standing.h"

namespace syncline::cli {
namespace {

constexpr double kQuantile = 0.9999;

/// A recording with what is asked of it.
struct Told {
  ReplayedRun run;
  RecordStretch stretch;
  RangeFigures figures;
};

Json to_three_digits(double value) { return std::round(value * 1000.0) / 1000.0; }
Json figure_number(double value) {
  return value == std::round(value) ? Json(static_cast<std::int64_t>(value)) : to_three_digits(value);
}

/// Lamps, missed events and faults need slaves by number and name alone.
NetworkConfig slaves_of(const RecordingAbout& about) {
  NetworkConfig config;
  for (const auto& slave : about.slaves) config.slaves.emplace_back().name = slave.name;
  return config;
}

Status check_signals(const std::vector<std::string>& keys, const RangeFigures& figures) {
  for (const auto& key : keys) {
    const auto known =
        std::ranges::any_of(figures.signals(), [&](const auto& of) { return info(of.signal).key == key; });
    if (known) continue;
    std::string all;
    for (const auto& of : figures.signals()) all += (all.empty() ? "" : ", ") + std::string(info(of.signal).key);
    return fail(ErrorCode::kBadValue, "--signal " + key, in_terminal("the signals are " + all));
  }
  return {};
}

Result<Told> read_told(Context& context, const FiguresOptions& options) {
  auto reader = RecordingReader::open(options.file);
  if (!reader) return tl::unexpected(reader.error());
  auto info = reader->info();
  if (!info) return tl::unexpected(info.error());
  auto stretch = stretch_of(options.range, *info);
  if (!stretch) return tl::unexpected(stretch.error());
  // What came in the cycles is looked at one by one and not kept.
  auto config = slaves_of(info->about);
  auto run = replay_run(*reader, std::move(*info), std::move(config), {.cycle_capacity = 1024});
  if (!run) return tl::unexpected(run.error());
  const auto& armed = run->record->overview().armed;
  if (!options.range.any() && armed) stretch->begin = *armed;
  Told told{std::move(*run), *stretch, {0, 0, 0, false}};
  told.figures = RangeFigures(told.run.info.about.slaves.size(), stretch->begin, stretch->end,
                              !options.range.any() && armed.has_value());
  if (auto known = check_signals(options.signals, told.figures); !known) return tl::unexpected(known.error());
  const auto status = reader->samples([&](std::span<const CycleSample> samples) {
    told.figures.add(samples);
    return samples.back().send_time < stretch->end;
  });
  if (!status) return tl::unexpected(status.error());
  warn_of_file(context, *reader);
  return told;
}

bool is_wanted(const FiguresOptions& options, const RangeFigures::OfSignal& of) {
  if (options.signals.empty()) return of.figure.statistics.count() > 0;
  return std::ranges::find(options.signals, info(of.signal).key) != options.signals.end();
}

/// What is left of the limit: of the master that of the filtered error, as far as it has lasted, because what is over
/// the limit for a moment is borne by the verdict.
std::optional<double> margin_of(const RunLimits& limits, const RangeFigures::OfSignal& of) {
  if (of.signal == Signal::kDcmError || of.signal == Signal::kMasterToNetwork) return std::nullopt;
  const auto limit = limit_of(limits, of.signal);
  return of.signal == Signal::kDcmErrorFiltered ? of.lasting.margin(static_cast<std::int64_t>(limit))
                                                : of.figure.margin(limit);
}

Json count_or_null(const std::optional<std::uint64_t>& count) { return count ? Json(*count) : Json(nullptr); }
Json reading_or_null(const std::optional<RangeFigure::Reading>& reading) {
  return reading ? figure_number(reading->value) : Json(nullptr);
}

Json figure_json(const RangeFigure& figure, Signal signal, const std::optional<double>& margin, const RunLimits& limits,
                 Nanoseconds begin) {
  const double limit = limit_of(limits, signal);
  const auto& statistics = figure.statistics;
  const bool any = statistics.count() > 0;
  const auto quantile = figure.quantile(kQuantile);
  return {{"count", statistics.count()},
          {"now", reading_or_null(figure.newest)},
          {"now_s", figure.newest ? Json(seconds(figure.newest->time - begin)) : Json(nullptr)},
          {"mean", any ? to_three_digits(statistics.mean()) : Json(nullptr)},
          {"rms", any ? to_three_digits(statistics.rms()) : Json(nullptr)},
          {"p9999", quantile ? Json(*quantile) : Json(nullptr)},
          {"max", reading_or_null(figure.largest)},
          {"max_s", figure.largest ? Json(seconds(figure.largest->time - begin)) : Json(nullptr)},
          {"limit", limit > 0 ? figure_number(limit) : Json(nullptr)},
          {"margin", margin ? to_three_digits(*margin) : Json(nullptr)},
          {"mean_95", interval_json(statistics.mean_interval(), info(signal).unit == "ppm")}};
}

Json lamp_json(const SyncLamp& lamp, const SyncOverview& overview) {
  const auto lost = lamp.any_lost();
  return {{"state", sync_state_key(lamp.state)},
          {"for_s", seconds(overview.end - lamp.of_all_since())},
          {"times_lost", lamp.times_any_lost()},
          {"last_lost_s", lost ? Json(seconds(*lost - overview.begin)) : Json(nullptr)}};
}

std::string fault_words(const Fault& fault) {
  if (fault.event) return event_words(*fault.event);
  return fmt::format("slave {}: {} SM2 events missed", fault.slave, fault.count);
}

/// Who works at the end of it; nothing: the run does not tell.
std::optional<SlavesStanding> standing_of(const RunRecord& record) {
  return slaves_standing(record.config(), record.samples(), record.overview());
}

std::string standing_words(const RunRecord& record) {
  const auto standing = standing_of(record);
  if (!standing) return {};
  auto text = fmt::format("{} of {} in OP", standing->in_op, counted(standing->slaves, "slave"));
  if (standing->silent > 0) text += fmt::format(", {} not answering", standing->silent);
  if (standing->silent_followers > 0) {
    text += fmt::format("; the verdict on the slaves is without {} of {} that followed the reference clock",
                        standing->silent_followers, standing->followers);
  }
  return text + '\n';
}

Json slaves_json(const RunRecord& record) {
  const auto standing = standing_of(record);
  if (!standing) return nullptr;
  return {{"in_op", standing->in_op},
          {"not_answering", standing->silent},
          {"followers", standing->followers},
          {"followers_not_answering", standing->silent_followers}};
}

Json faults_json(const SyncOverview& overview) {
  Json episodes = Json::array();
  for (const auto& episode : overview.faults.episodes()) {
    Json faults = Json::array();
    for (const auto& fault : episode.faults) {
      faults.push_back({{"time_s", seconds(fault.first - overview.begin)},
                        {"slave", fault.slave < 0 ? Json(nullptr) : Json(fault.slave)},
                        {"count", fault.count},
                        {"over_s", fault.over ? Json(seconds(*fault.over - overview.begin)) : Json(nullptr)},
                        {"text", fault_words(fault)}});
    }
    episodes.push_back({{"from_s", seconds(episode.begin - overview.begin)},
                        {"to_s", seconds(episode.end - overview.begin)},
                        {"faults", std::move(faults)}});
  }
  return episodes;
}

Json figures_as_json(const Told& told, const FiguresOptions& options) {
  const auto& record = *told.run.record;
  const auto& overview = record.overview();
  Json signal_list = Json::array(), slaves = Json::array();
  for (const auto& of : told.figures.signals()) {
    if (!is_wanted(options, of)) continue;
    const auto& row = info(of.signal);
    Json object{{"key", row.key}, {"name", row.name}, {"unit", row.unit}};
    object.update(figure_json(of.figure, of.signal, margin_of(record.limits(), of), record.limits(), overview.begin));
    if (of.signal == Signal::kDcmErrorFiltered) {
      const auto& lasting = of.lasting.largest();
      object["lasting"] = lasting ? Json(lasting->magnitude) : Json(nullptr);
    }
    signal_list.push_back(std::move(object));
  }
  for (std::size_t i = 0; i < told.figures.slaves().size(); ++i) {
    const auto& slave = told.figures.slaves()[i];
    const bool read = slave.deviation.statistics.count() > 0;
    slaves.push_back(
        {{"position", i},
         {"name", record.slave_name(i)},
         {"deviation_ns", read ? figure_json(slave.deviation, Signal::kSlaveDeviation,
                                             slave.deviation.margin(limit_of(record.limits(), Signal::kSlaveDeviation)),
                                             record.limits(), overview.begin)
                               : Json(nullptr)},
         {"sm2_missed", slave.missed ? Json(*slave.missed) : Json(nullptr)}});
  }
  return {
      {"from_s", seconds(told.stretch.begin - overview.begin)},
      {"to_s", seconds(std::min(told.stretch.end, overview.end) - overview.begin)},
      {"armed_s", overview.armed ? Json(seconds(*overview.armed - overview.begin)) : Json(nullptr)},
      {"cycles", told.figures.cycles()},
      {"lost_frames", count_or_null(told.figures.lost_frames())},
      {"wkc_errors", count_or_null(told.figures.wkc_errors())},
      {"skipped_cycles", count_or_null(told.figures.skipped_cycles())},
      {"signals", std::move(signal_list)},
      {"slaves", std::move(slaves)},
      {"standing", slaves_json(record)},
      {"sync", {{"slaves", lamp_json(overview.slaves, overview)}, {"master", lamp_json(overview.master, overview)}}},
      {"sm2_missed", overview.missed.known ? Json(overview.missed.count) : Json(nullptr)},
      {"episodes", faults_json(overview)}};
}

/// Of an imported run not everything is told.
std::string count_text(const std::optional<std::uint64_t>& count) {
  return count ? fmt::format("{}", *count) : "unknown";
}

std::string number_text(double value) {
  return value == std::round(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.3f}", value);
}

void append_figure(std::string& text, std::string_view name, std::string_view unit, const RangeFigure& figure,
                   const std::optional<double>& margin, double limit, Nanoseconds begin, bool lasting = false) {
  const auto& statistics = figure.statistics;
  const auto quantile = figure.quantile(kQuantile);
  const auto half = statistics.mean_half_width();
  const auto or_dash = [](bool any, const std::string& number) { return any ? number : std::string("-"); };
  const bool any = statistics.count() > 0;
  fmt::format_to(std::back_inserter(text), "{:<40} {:>5} {:>10} {:>12} {:>9} {:>12} {:>12} {:>12}", name, unit,
                 statistics.count(), or_dash(any, fmt::format("{:.3f}", statistics.mean())),
                 half ? fmt::format("{:.3f}", *half) : "-", or_dash(any, fmt::format("{:.3f}", statistics.rms())),
                 quantile ? fmt::format("{}", *quantile) : "-",
                 or_dash(any, any ? number_text(figure.largest->value) : ""));
  if (any) fmt::format_to(std::back_inserter(text), "  at {:.6f} s", seconds(figure.largest->time - begin));
  if (margin) {
    text += *margin < 0 ? fmt::format(", over the limit ±{:.0f}", limit)
                        : fmt::format(", {:.0f} % margin to ±{:.0f}", std::floor(*margin * 100), limit);
    if (lasting) text += " of what lasted";
  }
  text += '\n';
}

std::string lamp_words(std::string_view who, const SyncLamp& lamp, const SyncOverview& overview) {
  auto text =
      fmt::format("{}: {} for {:.3f} s", who, sync_state_text(lamp.state), seconds(overview.end - lamp.of_all_since()));
  if (const auto lost = lamp.any_lost()) {
    text += fmt::format(", lost {} since armed, last at {:.3f} s", counted(lamp.times_any_lost(), "time"),
                        seconds(*lost - overview.begin));
  }
  return text + '\n';
}

template <class Count>
std::string of_count(const Count& count, std::string_view noun) {
  const auto text = count_text(count);
  return fmt::format("{} {}{}", text, noun, text == "1" ? "" : "s");
}

std::string figures_text(const Told& told, const FiguresOptions& options) {
  const auto& record = *told.run.record;
  const auto& overview = record.overview();
  const auto out = [](std::string& text) { return std::back_inserter(text); };
  std::string text;
  fmt::format_to(out(text), "{:.3f} s to {:.3f} s{}: {}, {} lost, {}, {} left out\n",
                 seconds(told.stretch.begin - overview.begin),
                 seconds(std::min(told.stretch.end, overview.end) - overview.begin),
                 options.range.any() ? ""
                 : overview.armed    ? ", since it was armed"
                                     : ", never armed",
                 counted(told.figures.cycles(), "cycle"), of_count(told.figures.lost_frames(), "frame"),
                 of_count(told.figures.wkc_errors(), "WKC error"), of_count(told.figures.skipped_cycles(), "cycle"));
  text += lamp_words("slaves", overview.slaves, overview) + lamp_words("master", overview.master, overview) +
          standing_words(record);
  fmt::format_to(out(text), "{:<40} {:>5} {:>10} {:>12} {:>9} {:>12} {:>12} {:>12}\n", "SIGNAL", "UNIT", "COUNT",
                 "MEAN", "±95 %", "RMS", "P99.99", "LARGEST");
  for (const auto& of : told.figures.signals()) {
    if (!is_wanted(options, of)) continue;
    append_figure(text, info(of.signal).name, info(of.signal).unit, of.figure, margin_of(record.limits(), of),
                  limit_of(record.limits(), of.signal), overview.begin, of.signal == Signal::kDcmErrorFiltered);
  }
  for (std::size_t i = 0; i < told.figures.slaves().size(); ++i) {
    const auto& slave = told.figures.slaves()[i];
    const auto name = fmt::format("#{} {}", i, record.slave_name(i));
    if (slave.deviation.statistics.count() > 0) {
      const auto limit = limit_of(record.limits(), Signal::kSlaveDeviation);
      append_figure(text, name, "ns", slave.deviation, slave.deviation.margin(limit), limit, overview.begin);
    }
    if (slave.missed.value_or(0) > 0) fmt::format_to(out(text), "{}: {} SM2 events missed\n", name, *slave.missed);
  }
  for (const auto& episode : overview.faults.episodes()) {
    const auto& first = episode.faults[episode.leading()];
    fmt::format_to(out(text), "{:.3f} s: {}", seconds(first.first - overview.begin), fault_words(first));
    const auto more = episode.faults.size() - 1 + episode.left_out;
    text += more == 0 ? "\n" : fmt::format(", and {} more\n", more);
  }
  return text;
}

}  // namespace

void show_figures(Context& context, const FiguresOptions& options) {
  const auto told = read_told(context, options);
  if (!told) return context.fail_with(told.error());
  if (options.json) return context.print(figures_as_json(*told, options));
  context.console.out << figures_text(*told, options);
}

}  // namespace syncline::cli
