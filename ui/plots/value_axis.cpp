// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/value_axis.h"

#include <qwt_plot.h>
#include <qwt_scale_div.h>
#include <qwt_scale_engine.h>
#include <qwt_text.h>
#include <qwt_transform.h>

#include <QFontMetrics>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/decade_axis.h"
#include "ui/plots/unit_scale_draw.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr double kLeastDecades = 1;
constexpr int kLabelHeight = 20;  // logical pixels, with the room to the next one

/// For the plot, which owns it.
class PlotTransform final : public QwtTransform {
 public:
  explicit PlotTransform(const ValueTransform& values) : values_(values) {}
  [[nodiscard]] double transform(double value) const override { return values_.place(value); }
  [[nodiscard]] double invTransform(double place) const override { return values_.value(place); }
  [[nodiscard]] QwtTransform* copy() const override { return new PlotTransform(values_); }

 private:
  ValueTransform values_;
};

struct Unit {
  double divisor;
  QString name;
};

Unit timeUnit(double magnitude_ns) {
  if (magnitude_ns < 2e4) return {1, QStringLiteral("ns")};
  if (magnitude_ns < 2e7) return {1e3, QStringLiteral("\u00B5s")};
  if (magnitude_ns < 2e10) return {1e6, QStringLiteral("ms")};
  return {1e9, QStringLiteral("s")};
}

SlowRange rangeOf(const ValueAxis::Options& options, ValueScale scale) {
  if (scale == ValueScale::kLinear) return SlowRange(options.minimum_span, options.with_zero);
  return SlowRange(kLeastDecades, scale == ValueScale::kSignedLog && options.with_zero);
}

/// Powers of ten between the limits and, of a signed scale, their counterparts below zero: at most so many.
QList<double> decadeTicks(const ValueTransform& transform, double low, double high, int most) {
  QList<double> ticks;
  const double unit = transform.unit();
  if (transform.scale() == ValueScale::kLog) {
    const double from = std::max(low, unit * 1e-30);
    for (const auto& tick : DecadeAxis(from, high).ticks(most)) {
      if (tick.labelled && tick.value >= low && tick.value <= high) ticks.append(tick.value);
    }
    return ticks;
  }
  const double places = transform.place(high) - transform.place(low);
  const int every = std::max(1, static_cast<int>(std::ceil(places / std::max(most - 1, 1))));
  const auto last = static_cast<int>(std::ceil(std::log10(std::max(std::abs(low), std::abs(high)) / unit)));
  if (low <= 0 && high >= 0) ticks.append(0);
  for (int power = every - 1; power <= last; power += every) {
    const double value = unit * std::pow(10, power);
    if (value >= low && value <= high) ticks.append(value);
    if (-value >= low && -value <= high) ticks.prepend(-value);
  }
  std::ranges::sort(ticks);
  return ticks;
}

/// Along a low axis the unit alone, or what has room of the quantity.
QString titleFor(const QString& quantity, const QString& unit, const QFont& font, int height) {
  const QFontMetrics metrics(font);
  const auto whole = unit.isEmpty() ? quantity : quantity + QStringLiteral(" / ") + unit;
  // The plot has no height before it is laid out.
  if (height <= 0 || metrics.horizontalAdvance(whole) <= height) return whole;
  return unit.isEmpty() ? metrics.elidedText(quantity, Qt::ElideRight, height) : unit;
}

}  // namespace

ValueAxis::ValueAxis(QwtPlot& plot, QwtAxisId axis, const Options& options)
    : plot_(plot),
      axis_(axis),
      options_(options),
      transform_(ValueScale::kLinear, options.least),
      range_(rangeOf(options, ValueScale::kLinear)),
      draw_(new UnitScaleDraw) {
  plot_.setAxisScaleDraw(axis_, draw_);
}

void ValueAxis::setOptions(const Options& options) {
  if (options == options_) return;
  const bool other_range = options.minimum_span != options_.minimum_span || options.with_zero != options_.with_zero ||
                           options.least != options_.least;
  options_ = options;
  if (!other_range) return;
  const auto scale = transform_.scale();
  transform_ = ValueTransform(scale, options_.least);
  takeScale();
}

void ValueAxis::setScale(ValueScale scale) {
  if (scale == transform_.scale()) return;
  transform_ = ValueTransform(scale, options_.least);
  takeScale();
}

void ValueAxis::takeScale() {
  const auto scale = transform_.scale();
  range_ = rangeOf(options_, scale);
  auto* engine = new QwtLinearScaleEngine;
  if (scale != ValueScale::kLinear) engine->setTransformation(new PlotTransform(transform_));
  plot_.setAxisScaleEngine(axis_, engine);
  draw_->setDecades(scale != ValueScale::kLinear, options_.kind == Quantity::kTime);
  if (fixed_) fix(AxisLimits(*fixed_));
}

void ValueAxis::update(double low, double high, double headroom) {
  if (fixed_ || low > high) return;
  // What has no logarithm is no reason to show thirty decades.
  if (scale() == ValueScale::kLog) {
    high = std::max(high, options_.least);
    low = std::clamp(low, std::min(options_.least, high), high);
  }
  double from = transform_.place(low);
  double to = transform_.place(high);
  if (headroom > 0) {
    const double least = scale() == ValueScale::kLinear ? options_.minimum_span : kLeastDecades;
    to += std::max(to - from, least) * headroom / (1 - headroom);
  }
  range_.update(from, to);
}

void ValueAxis::fit() {
  fixed_.reset();
  range_.fit();
}

void ValueAxis::fix(const AxisLimits& limits) {
  if (!(limits.low < limits.high)) return;
  const double from = transform_.place(limits.low);
  const double to = transform_.place(limits.high);
  if (!(from < to)) return;
  fixed_ = limits;
  range_.fix(from, to);
}

double ValueAxis::low() const { return fixed_ ? fixed_->low : transform_.value(range_.low()); }
double ValueAxis::high() const { return fixed_ ? fixed_->high : transform_.value(range_.high()); }

void ValueAxis::zoom(double value, double factor) {
  const double at = transform_.place(value);
  fix({transform_.value(at + (range_.low() - at) * factor), transform_.value(at + (range_.high() - at) * factor)});
}

void ValueAxis::setNumbers(bool on) {
  numbers_ = on;
  draw_->enableComponent(QwtAbstractScaleDraw::Labels, on);
  draw_->enableComponent(QwtAbstractScaleDraw::Ticks, on);
}

void ValueAxis::applyTicks(int height) {
  if (scale() == ValueScale::kLinear) return plot_.setAxisScale(axis_, low(), high(), range_.step());
  const int most = std::max(height / kLabelHeight, 2);
  plot_.setAxisScaleDiv(axis_, QwtScaleDiv(low(), high(), {}, {}, decadeTicks(transform_, low(), high(), most)));
}

void ValueAxis::apply(const QPalette& palette, const QFont& font, int height) {
  Unit unit{1, options_.unit};
  const bool decades = scale() != ValueScale::kLinear;
  if (options_.kind == Quantity::kTime) {
    // With decades each label has the unit that suits it.
    unit = decades ? Unit{1, {}} : timeUnit(std::max(std::abs(low()), std::abs(high())));
  }
  draw_->setDivisor(unit.divisor);
  applyTicks(height);
  if (!numbers_) unit.name.clear();
  QwtText title(!numbers_ && axis_ == QwtPlot::yRight ? QStringLiteral(" ")
                                                      : titleFor(options_.quantity, unit.name, font, height));
  title.setFont(font);
  title.setColor(theme::mutedText(palette));
  if (plot_.axisTitle(axis_) != title) plot_.setAxisTitle(axis_, title);
}

}  // namespace syncline::ui
