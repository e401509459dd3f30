// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <qwt_text.h>

#include <QGuiApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <limits>

#include "trace/min_max_series.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/series_csv.h"
#include "ui/plots/slave_slots.h"
#include "ui/plots/slow_range.h"
#include "ui/plots/unit_scale_draw.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

TEST(SlowRange, GrowsAtOnceAndShrinksLate) {
  SlowRange range(1, false, 10);
  range.update(-100, 100);
  EXPECT_LE(range.low(), -100);
  EXPECT_TRUE(range.update(-100, 900));
  EXPECT_GE(range.high(), 900);
  const double high = range.high();
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(range.update(-10, 10)) << i;
  EXPECT_TRUE(range.update(-10, 10));
  EXPECT_LT(range.high(), high / 10);
}

TEST(SlowRange, DoesNotMoveForValuesInside) {
  SlowRange range;
  range.update(-100, 100);
  const double low = range.low();
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(range.update(-100 + i % 30, 100 - i % 20));
  EXPECT_EQ(range.low(), low);
}

TEST(SlowRange, FixedIsFixedUntilFit) {
  SlowRange range;
  range.fix(-5, 5);
  EXPECT_FALSE(range.update(-1000, 1000));
  EXPECT_EQ(range.high(), 5);
  range.fit();
  EXPECT_TRUE(range.update(-1000, 1000));
  EXPECT_GE(range.high(), 1000);
}

TEST(SlowRange, CounterStartsAtZeroButFollowsAHighOne) {
  SlowRange from_zero(4, true);
  from_zero.update(0, 3);
  EXPECT_EQ(from_zero.low(), 0);
  EXPECT_GE(from_zero.high(), 4);
  SlowRange high(4, true);
  high.update(3000, 3001);
  EXPECT_GT(high.low(), 2900) << "a single event must stay visible on a high count";
}

TEST(SlowRange, NothingVisibleKeepsTheRange) {
  SlowRange range;
  range.update(-10, 10);
  EXPECT_FALSE(range.update(1, 0));
  EXPECT_LE(range.low(), -10);
}

TEST(SlaveSlots, ShowsTheWorstAndThePickedOne) {
  SlaveSlots slots(3);
  slots.update({5, 50, 1, 40, 30, -1}, -1);
  const auto slaves = [&] {
    std::vector<int> result;
    for (const auto& slot : slots.slots()) result.push_back(slot.slave);
    return result;
  };
  EXPECT_THAT(slaves(), testing::ElementsAre(1, 3, 4));
  EXPECT_FALSE(slots.update({32, 50, 1, 40, 30, -1}, -1)) << "a little worse does not swap";
  EXPECT_TRUE(slots.update({60, 50, 1, 40, 30, -1}, -1));
  EXPECT_THAT(slaves(), testing::ElementsAre(0, 1, 3));
  slots.update({60, 50, 1, 40, 30, -1}, 2);
  EXPECT_THAT(slaves(), testing::Contains(2));
  slots.update({60, 50, 1, 40, 30, -1}, 5);
  EXPECT_THAT(slaves(), testing::Not(testing::Contains(5))) << "nothing to draw of it";
}

TEST(SlaveSlots, ColoursDifferAndStay) {
  SlaveSlots slots(4);
  slots.update({9, 9, 9, 9, 9, 9, 9, 9}, 6);  // 0 and 6 would like the same colour
  std::vector<int> colors;
  for (const auto& slot : slots.slots()) colors.push_back(slot.color);
  std::sort(colors.begin(), colors.end());
  EXPECT_EQ(std::unique(colors.begin(), colors.end()), colors.end());
}

TEST(SeriesCsv, MergesByTimeAndLeavesMissingFieldsEmpty) {
  MinMaxSeries a;
  MinMaxSeries b;
  a.append(1000, 1.5F);
  a.append(2000, std::numeric_limits<float>::quiet_NaN());
  a.append(4000, -3);
  b.append(2000, 7);
  b.append(3000, 8);
  const auto cycle = [](Nanoseconds time) {
    return time < 2000 ? std::nullopt : std::optional(static_cast<std::uint64_t>(time / 1000 + 40));
  };
  EXPECT_EQ(series_csv({{{"a_ns", &a}, {"b, \"x\"", &b}}, cycle, 1000, 0, 4001}),
            "time_ns,time_utc,cycle,a_ns,\"b, \"\"x\"\"\"\n"
            "0,2000-01-01T00:00:00.000001000Z,,1.5,\n"
            "1000,2000-01-01T00:00:00.000002000Z,42,,7\n"
            "2000,2000-01-01T00:00:00.000003000Z,43,,8\n"
            "3000,2000-01-01T00:00:00.000004000Z,44,-3,\n");
}

TEST(SeriesCsv, DoesNotDependOnTheLocale) {
  MinMaxSeries a;
  a.append(0, 1234.5F);
  const auto before = QLocale();
  QLocale::setDefault(QLocale(QLocale::German));
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const auto table = series_csv({{{"a", &a}}, {}, 0, 0, 1});
  if (set != nullptr) std::setlocale(LC_ALL, "C.UTF-8");
  QLocale::setDefault(before);
  EXPECT_THAT(table, testing::HasSubstr(",1234.5\n"));
}

TEST(IsoUtc, HandlesDatesOnBothSidesOfTheEpoch) {
  EXPECT_EQ(iso_utc(0), "2000-01-01T00:00:00.000000000Z");
  EXPECT_EQ(iso_utc(-1), "1999-12-31T23:59:59.999999999Z");
  EXPECT_EQ(iso_utc((60 * 86'400LL + 3'661) * kSecond + 5), "2000-03-01T01:01:01.000000005Z")
      << "2000 has a 29th of February";
}

TEST(UnitScaleDraw, TicksWithWordsOfTheirOwnHaveThoseUntilThereAreNone) {
  UnitScaleDraw draw;
  draw.setTicks({{0, QStringLiteral("noon")}, {60, QStringLiteral("12:01")}});
  EXPECT_EQ(draw.label(1).text(), QStringLiteral("noon"));
  EXPECT_EQ(draw.label(59).text(), QStringLiteral("12:01"));
  draw.setTicks({{60, QStringLiteral("a minute")}});
  EXPECT_EQ(draw.label(60).text(), QStringLiteral("a minute"));
  draw.setTicks({});
  EXPECT_EQ(draw.label(60).text(), QStringLiteral("60"));
}

TEST(UnitScaleDraw, DecimalsFollowTheTicks) {
  UnitScaleDraw draw;
  draw.setDivisor(1e3);
  draw.setScaleDiv(QwtScaleDiv(0, 1000, {}, {}, {0, 250, 500}));
  EXPECT_EQ(draw.label(500).text(), QStringLiteral("0.5"));
  draw.setScaleDiv(QwtScaleDiv(0, 100, {}, {}, {0, 20, 40}));
  EXPECT_EQ(draw.label(40).text(), QStringLiteral("0.04"));
  EXPECT_EQ(draw.label(-20).text(), QStringLiteral("\u22120.02"));
  EXPECT_EQ(draw.label(-1e-12).text(), QStringLiteral("0.00"));
}

using Linear = std::array<double, 3>;
using SeenAs = std::array<Linear, 3>;
/// What is seen of linear RGB (Machado, Oliveira, Fernandes 2009, table 1, severity 1.0).
constexpr SeenAs kNormal{Linear{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr SeenAs kNoRed{
    Linear{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr SeenAs kNoGreen{
    Linear{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};

double times(const Linear& row, const Linear& color) {
  return std::clamp(row[0] * color[0] + row[1] * color[1] + row[2] * color[2], 0.0, 1.0);
}

/// CIE 1976 L*a*b*, D65.
Linear lab(const QColor& color, const SeenAs& seen) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const Linear shown{linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
  const Linear rgb{times(seen[0], shown), times(seen[1], shown), times(seen[2], shown)};
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047);
  const double y = f(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]);
  const double z = f((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Any two traces can be told apart, also by who sees no red or no green.
TEST(PlotColors, AreToldApartWithoutRedOrGreen) {
  constexpr double kLeastDistance = 16;  // just seen side by side are 2.3
  for (const auto mode : {theme::Mode::kLight, theme::Mode::kDark, theme::Mode::kContrast}) {
    theme::apply(mode);
    const QPalette palette = QGuiApplication::palette();
    for (const auto& seen : {kNormal, kNoRed, kNoGreen}) {
      for (int i = 0; i < plot_colors::kTraceCount; ++i) {
        for (int k = 0; k < i; ++k) {
          const auto a = lab(plot_colors::trace(palette, i), seen), b = lab(plot_colors::trace(palette, k), seen);
          EXPECT_GE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), kLeastDistance) << i << " and " << k;
        }
      }
    }
  }
  theme::apply(theme::Mode::kLight);
}

TEST(PlotColors, StandOutOnTheCanvasOfEachTheme) {
  for (const auto mode : {theme::Mode::kLight, theme::Mode::kDark, theme::Mode::kContrast}) {
    theme::apply(mode);
    const QPalette palette = QGuiApplication::palette();
    const auto canvas = palette.color(QPalette::Base);
    for (int i = 0; i < plot_colors::kTraceCount; ++i) {
      EXPECT_GE(plot_colors::contrast(plot_colors::trace(palette, i), canvas), 3.0) << i;
      for (int k = 0; k < i; ++k) EXPECT_NE(plot_colors::trace(palette, i), plot_colors::trace(palette, k));
    }
    EXPECT_GE(plot_colors::contrast(plot_colors::envelope(palette), canvas), 3.0);
    EXPECT_GE(plot_colors::contrast(plot_colors::limitLine(palette), canvas), 4.5);
    for (const auto role : {QPalette::Window, QPalette::Base}) {
      EXPECT_GE(plot_colors::contrast(theme::mutedText(palette), palette.color(role)), 4.5);
      EXPECT_GE(plot_colors::contrast(palette.color(QPalette::WindowText), palette.color(role)), 4.5);
    }
  }
  theme::apply(theme::Mode::kLight);
}

}  // namespace
}  // namespace syncline::ui
