// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_axis.h"

#include <QDateTime>
#include <QLocale>
#include <QTimeZone>
#include <algorithm>
#include <array>
#include <cmath>

#include "support/types.h"
#include "ui/plots/round_step.h"
#include "ui/plots/time_view.h"
#include "ui/plots/trace_plot.h"

namespace syncline::ui {
namespace {

using Notation = TimeView::Notation;

/// A step of the clock that leaves at most so many of them in the span.
Nanoseconds clockStep(Nanoseconds span, int most) {
  constexpr std::array kSteps{kSecond,          2 * kSecond,     5 * kSecond,    10 * kSecond,   15 * kSecond,
                              30 * kSecond,     60 * kSecond,    120 * kSecond,  300 * kSecond,  600 * kSecond,
                              900 * kSecond,    1800 * kSecond,  3600 * kSecond, 7200 * kSecond, 21'600 * kSecond,
                              43'200 * kSecond, 86'400 * kSecond};
  const auto least = span / std::max(most, 1) + 1;
  if (least < kSecond) return static_cast<Nanoseconds>(std::llround(roundStep(static_cast<double>(least))));
  const auto* const found = std::ranges::lower_bound(kSteps, least);
  return found == kSteps.end() ? (least / kSteps.back() + 1) * kSteps.back() : *found;
}

int decimalsOf(Nanoseconds step) {
  int decimals = 9;
  for (; decimals > 0 && step % 10 == 0; --decimals) step /= 10;
  return decimals;
}

/// ".250" of a time, as many decimals as the step needs.
QString fraction(Nanoseconds time, int decimals) {
  if (decimals == 0) return {};
  const auto rest = ((time % kSecond) + kSecond) % kSecond;
  return QLocale().decimalPoint() + QStringLiteral("%1").arg(rest, 9, 10, QLatin1Char('0')).left(decimals);
}

QDateTime dateOf(Nanoseconds time) {
  const auto seconds = time / kSecond - (time % kSecond < 0 ? 1 : 0);
  return QDateTime::fromSecsSinceEpoch(seconds + kDcEpochUnixSeconds, QTimeZone::utc());
}

/// The stretch from its beginning on, with ticks at moments.
TimeAxis labelled(const TimeView& view, QString quantity) {
  TimeAxis axis{0, static_cast<double>(view.span()) / 1e9, 1, std::move(quantity), {}, {}, true};
  return axis;
}

void addTick(TimeAxis& axis, const TimeView& view, Nanoseconds time, QString label) {
  axis.ticks.push_back({static_cast<double>(time - view.begin()) / 1e9, std::move(label)});
}

TimeAxis clockAxis(const TimeView& view, int most) {
  const auto date = QLocale::c().toString(dateOf(view.end()).date(), QStringLiteral("yyyy-MM-dd"));
  auto axis = labelled(view, TracePlot::tr("UTC, %1").arg(date));
  const auto step = clockStep(view.span(), std::max(most * 3 / 5, 1));  // wider labels
  const int decimals = decimalsOf(step);
  for (auto time = (view.begin() / step + 1) * step; time <= view.end(); time += step)
    addTick(axis, view, time, dateOf(time).toString(QStringLiteral("HH:mm:ss")) + fraction(time, decimals));
  return axis;
}

/// When that cycle was sent: the first moment whose latest cycle has its number or a later one.
Nanoseconds timeOfCycle(const TimeView& view, std::uint64_t cycle, Nanoseconds from, Nanoseconds to) {
  while (from < to) {
    const auto middle = from + (to - from) / 2;
    const auto there = view.clocks().cycle_at(middle);
    there&&* there >= cycle ? to = middle : from = middle + 1;
  }
  return to;
}

TimeAxis cycleAxis(const TimeView& view, int most) {
  auto axis = labelled(view, TracePlot::tr("Cycle"));
  const auto begin = std::max(view.begin(), view.first());
  const auto end = std::min(view.end(), view.last());
  if (begin > end || !view.clocks().cycle_at) return axis;
  const auto first = view.clocks().cycle_at(begin);
  const auto last = view.clocks().cycle_at(end);
  if (!first || !last) return axis;
  const double wanted = static_cast<double>(*last - *first) / std::max(most, 1);
  const auto step = static_cast<std::uint64_t>(std::max(std::llround(roundStep(std::max(wanted, 1.0))), 1LL));
  QLocale locale;
  for (auto cycle = (*first / step + 1) * step; cycle <= *last; cycle += step)
    addTick(axis, view, timeOfCycle(view, cycle, begin, end), locale.toString(static_cast<qulonglong>(cycle)));
  return axis;
}

/// Whole seconds stand in the title: no label has room for nanoseconds since 2000.
TimeAxis dcTimeAxis(const TimeView& view, int most) {
  const auto at = view.clocks().dc_time_at ? view.clocks().dc_time_at(view.end()) : std::nullopt;
  if (!at) return labelled(view, TracePlot::tr("System time: not known"));
  const auto step = clockStep(view.span(), most);
  const auto decade = std::max<Nanoseconds>(kSecond, view.span() > 10 * kSecond ? 1000 * kSecond : 10 * kSecond);
  const auto base = (*at - view.span()) / decade * decade;
  auto axis = labelled(
      view,
      TracePlot::tr("System time \u2212 %1 s / s").arg(QLocale().toString(static_cast<qlonglong>(base / kSecond))));
  const auto offset = *at - view.end();
  const int decimals = decimalsOf(step);
  for (auto time = ((view.begin() + offset) / step + 1) * step; time <= *at; time += step) {
    addTick(axis, view, time - offset,
            QLocale().toString(static_cast<qlonglong>((time - base) / kSecond)) + fraction(time - base, decimals));
  }
  return axis;
}

/// What a span is told in, and what larger one is taken off the moments in it, so that labels keep few digits.
struct SpanUnit {
  Nanoseconds unit, whole;
  const char* name;
  int decimals;  // of the whole in seconds
};

SpanUnit unitOfSpan(Nanoseconds span) {
  if (span > kSecond) return {kSecond, 0, "s", 0};
  if (span > kMillisecond) return {kMillisecond, kSecond, "ms", 0};
  if (span > 2 * TimeView::kMinSpan) return {kMicrosecond, kMillisecond, "\u00B5s", 3};
  return {1, kMicrosecond, "ns", 6};
}

TimeAxis numberAxis(const TimeView& view) {
  const auto span = static_cast<double>(view.span()) / 1e9;
  const auto of = unitOfSpan(view.span());
  const double divisor = static_cast<double>(of.unit) / 1e9;
  const auto unit = QString::fromUtf8(of.name);
  if (view.mode() == TimeView::Mode::kLive && view.notation() == Notation::kBeforeNow)
    return {-span, 0, divisor, view.goesOn() ? TracePlot::tr("Time before now") : TracePlot::tr("Time before the end"),
            unit};
  const auto since = view.end() - view.origin();
  const auto begin = since - view.span();
  const auto base = of.whole == 0 || begin < 0 ? 0 : begin / of.whole * of.whole;
  const double end = static_cast<double>(since - base) / 1e9;
  const auto quantity = base == 0 ? TracePlot::tr("Time since start")
                                  : TracePlot::tr("Time since start \u2212 %1 s")
                                        .arg(QLocale().toString(static_cast<double>(base) / 1e9, 'f', of.decimals));
  return {end - span, end, divisor, quantity, unit};
}

}  // namespace

TimeAxis timeAxisOf(const TimeView& view, int most) {
  switch (view.notation()) {
    case Notation::kUtc:
      return clockAxis(view, most);
    case Notation::kCycle:
      return cycleAxis(view, most);
    case Notation::kDcTime:
      return dcTimeAxis(view, most);
    case Notation::kBeforeNow:
    case Notation::kSinceStart:
      break;
  }
  return numberAxis(view);
}

}  // namespace syncline::ui
