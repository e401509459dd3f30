// SPDX-License-Identifier: Apache-2.0
#include "reports/run_plots.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "record/run_record.h"
#include "reports/run_pictures.h"
#include "trace/fault_log.h"
#include "trace/outages.h"
#include "trace/sync_overview.h"

namespace syncline::reports {
namespace {

using Scope = SignalInfo::Scope;

constexpr double kHead = 22, kTitle = 16, kUsualHeight = 180;

const MinMaxSeries& series_of(const RunRecord& run, const NamedSignal& signal) {
  return info(signal.signal).scope == Scope::kBus ? run.samples().series(signal.signal)
                                                  : run.samples().series(signal.signal, signal.slave);
}

bool has_value(const RunRecord& run, const NamedSignal& signal) {
  return series_of(run, signal).extent(INT64_MIN, INT64_MAX).has_value();
}

std::string to_milliseconds(Nanoseconds time) {
  constexpr std::time_t kEpoch2000 = 946'684'800;
  return fmt::format("{:%Y-%m-%d %H:%M:%S}.{:03}", fmt::gmtime(kEpoch2000 + static_cast<std::time_t>(time / kSecond)),
                     time % kSecond / kMillisecond);
}

std::string heading(const PlotsOf& plots) {
  return fmt::format("{}{}{} to {} UTC, cycle {:g} us", plots.name, plots.name.empty() ? "" : ": ",
                     to_milliseconds(plots.begin), to_milliseconds(plots.end),
                     static_cast<double>(plots.run.limits().cycle_time) / 1e3);
}

std::vector<Nanoseconds> faults_of(const RunRecord& run) {
  std::vector<Nanoseconds> faults;
  for (const auto& event : run.events()) {
    if (meaning_of(event) == EventMeaning::kFault) faults.push_back(event.time);
  }
  std::ranges::sort(faults);
  return faults;
}

}  // namespace

std::vector<NamedSignal> usual_plots(const RunRecord& run) {
  std::vector<NamedSignal> usual;
  for (const auto signal : {Signal::kDeviation, Signal::kDcmError}) {
    if (has_value(run, {signal, 0})) usual.push_back({signal, 0});
  }
  NamedSignal worst{Signal::kSm2Missed, 0};
  float most = 0;
  for (std::size_t slave = 0; slave < run.samples().slave_count(); ++slave) {
    const auto extent = run.samples().series(Signal::kSm2Missed, slave).extent(INT64_MIN, INT64_MAX);
    if (!extent || extent->max <= most) continue;
    most = extent->max;
    worst.slave = slave;
  }
  if (most > 0) usual.push_back(worst);
  return usual;
}

std::string plot_title(const RunRecord& run, const NamedSignal& signal) {
  const auto& row = info(signal.signal);
  if (row.scope == Scope::kVariable) return run.watched().variables().at(signal.slave).name;
  if (row.scope == Scope::kBus) return std::string(row.name);
  return fmt::format("#{} {}: {}", signal.slave, run.slave_name(signal.slave), row.name);
}

std::string plots_svg(const PlotsOf& plots) {
  const auto count = static_cast<double>(std::max<std::size_t>(plots.signals.size(), 1));
  const double height = plots.height > 0 ? plots.height : kHead + count * (kUsualHeight + kTitle);
  const SvgFrame frame{.width = plots.width, .height = (height - kHead) / count - kTitle};
  const auto& store = plots.run.samples();
  const auto faults = faults_of(plots.run);
  const auto column =
      std::max<Nanoseconds>((plots.end - plots.begin) / std::max(std::llround(frame.inner_width()), 1LL), 1);
  const auto missing = outages(store, plots.begin, plots.end, column);
  auto svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"11\" fill=\"#1f2933\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      plots.width, height);
  svg_label(svg, 8, 15, "start", heading(plots));
  double y = kHead;
  for (const auto& signal : plots.signals) {
    const auto& row = info(signal.signal);
    const auto title = plot_title(plots.run, signal);
    svg_label(svg, frame.left, y + 12, "start", title);
    const auto course = course_svg({.series = series_of(plots.run, signal),
                                    .begin = plots.begin,
                                    .end = plots.end,
                                    .limit = limit_of(plots.run.limits(), signal.signal),
                                    .is_signed = row.scale == SignalInfo::Scale::kSignedLog,
                                    .unit = row.unit,
                                    .title = title,
                                    .held = store.held(signal.signal, signal.slave),
                                    .outages = missing,
                                    .faults = faults,
                                    .origin = plots.run.overview().begin,
                                    .frame = frame});
    if (course.empty()) {
      svg_label(svg, frame.left + frame.inner_width() / 2, y + kTitle + frame.height / 2, "middle",
                "no value in this range");
    } else {
      fmt::format_to(std::back_inserter(svg), "<g transform=\"translate(0,{:.1f})\">\n{}</g>\n", y + kTitle, course);
    }
    y += kTitle + frame.height;
  }
  return svg + "</svg>\n";
}

}  // namespace syncline::reports
