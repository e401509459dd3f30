// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/timing_diagram.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_colors.h"
#include "ui/plots/round_step.h"
#include "ui/plots/small_font.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kNameGap = 8, kEndRoom = 30, kUsualRows = 3;
constexpr int kTimeMarks = 5;
constexpr double kBarShare = 0.55;  // of a row
constexpr int kArmedAlpha = 70;

QString latchText(const dc::SlaveTiming::Latch& latch) {
  QStringList said;
  if (latch.by_device) said << TimingDiagram::tr("The device's own controller has the latch unit (0x09A8).");
  if (latch.single) said << TimingDiagram::tr("The latch takes one edge until its time is read (0x09A8).");
  if (latch.in_frames) said << TimingDiagram::tr("Each frame reads the times of latched edges (0x09AE to 0x09CF).");
  return said.join(QLatin1Char('\n'));
}

}  // namespace

TimingDiagram::TimingDiagram(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  speaksValue(*this);
  sayValue(*this, described());
}

void TimingDiagram::setTiming(std::optional<dc::SlaveTiming> timing) {
  if (timing == timing_) return;
  timing_ = timing;
  line_ = timing ? dc::sync_timeline(*timing) : dc::SyncTimeline{};
  sayValue(*this, described());
  updateGeometry();
  update();
}

bool TimingDiagram::isTooTight() const {
  return timing_ && timing_->compute && line_.margin && *timing_->compute > *line_.margin;
}

QString TimingDiagram::described() const {
  if (!timing_) return tr("Without SYNC0 the device works when its outputs come.");
  QStringList said;
  if (!line_.outputs.empty()) {
    said << tr("Outputs are complete at the slave %1 after the frame has passed the reference clock.")
                .arg(timeText(line_.outputs.front().to));
  }
  if (timing_->compute) said << tr("It calculates and copies for %1.").arg(timeText(*timing_->compute));
  if (!line_.sync0.empty()) {
    said << tr("SYNC0 comes at %1, every %2.").arg(timeText(line_.sync0.front()), cycleText(timing_->sync0.period));
  }
  if (!line_.sync1.empty()) {
    said << tr("SYNC1 comes at %1, every %2.")
                .arg(timeText(line_.sync1.front()),
                     cycleText(dc::sync1_period(timing_->sync0.period, *timing_->sync1)));
  }
  if (timing_->latch) said << latchText(*timing_->latch);
  if (line_.margin) {
    said << (isTooTight() ? tr("%1 are left before SYNC0, which is too little.") : tr("%1 are left before SYNC0."))
                .arg(timeText(*line_.margin));
  }
  return said.join(QLatin1Char('\n'));
}

QList<TimingDiagram::Row> TimingDiagram::rows() const {
  QList<Row> rows;
  if (!timing_) return rows;
  if (!line_.outputs.empty()) rows << Row::kFrame;
  if (!line_.compute.empty()) rows << Row::kCompute;
  rows << Row::kSync0;
  if (timing_->sync1) rows << Row::kSync1;
  if (timing_->latch) rows << Row::kLatch;
  return rows;
}

QString TimingDiagram::rowName(Row row) {
  switch (row) {
    case Row::kFrame:
      return tr("Frame");
    case Row::kCompute:
      return tr("Calc + copy");
    case Row::kSync0:
      return QStringLiteral("SYNC0");
    case Row::kLatch:
      return tr("Latch");
    case Row::kSync1:
      break;
  }
  return QStringLiteral("SYNC1");
}

int TimingDiagram::rowHeight() const { return fontMetrics().height() + 8; }

int TimingDiagram::nameWidth() const {
  int width = 0;
  for (const auto row : {Row::kFrame, Row::kCompute, Row::kSync0, Row::kSync1, Row::kLatch})
    width = std::max(width, fontMetrics().horizontalAdvance(rowName(row)));
  return width + kNameGap;
}

/// One row more for the margin, and one for the axis. The usual rows have their place whatever is drawn.
QSize TimingDiagram::sizeHint() const {
  return {320, rowHeight() * (std::max(static_cast<int>(rows().size()), kUsualRows) + 2)};
}
QSize TimingDiagram::minimumSizeHint() const { return {nameWidth() + 120, sizeHint().height()}; }

QRectF TimingDiagram::area() const { return QRectF(rect()).adjusted(nameWidth(), 0, -kEndRoom, -rowHeight()); }

double TimingDiagram::xOf(Nanoseconds time) const {
  if (line_.length <= 0) return area().left();
  return area().left() + area().width() * static_cast<double>(time) / static_cast<double>(line_.length);
}

void TimingDiagram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (!timing_) {
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, described());
    return;
  }
  drawAxis(painter);
  auto box = area();
  box.setHeight(rowHeight());
  for (const auto row : rows()) {
    drawRow(painter, row, box);
    box.translate(0, rowHeight());
  }
  drawMargin(painter);
}

void TimingDiagram::drawAxis(QPainter& painter) const {
  const auto box = area();
  const auto foot = box.top() + rowHeight() * static_cast<double>(rows().size() + 1);
  painter.setFont(smallFont(font()));
  const auto marks = std::clamp(static_cast<int>(box.width()) / 70, 1, kTimeMarks);
  const double step = roundStep(static_cast<double>(line_.length) / marks);
  for (double at = 0; at <= static_cast<double>(line_.length); at += step) {
    const auto time = static_cast<Nanoseconds>(std::llround(at));
    painter.setPen(QPen(plot_colors::grid(palette()), 0));
    painter.drawLine(QPointF(xOf(time), box.top()), QPointF(xOf(time), foot));
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(QRectF(xOf(time) - 40, foot + 2, 80, rowHeight()), Qt::AlignHCenter | Qt::AlignTop,
                     cycleText(time));
  }
  painter.setFont(font());
}

void TimingDiagram::drawRow(QPainter& painter, Row row, const QRectF& box) const {
  painter.setPen(theme::mutedText(palette()));
  painter.drawText(QRectF(0, box.top(), box.left() - kNameGap, box.height()), Qt::AlignRight | Qt::AlignVCenter,
                   rowName(row));
  painter.setPen(QPen(theme::outline(palette()), 0));
  painter.drawLine(QPointF(box.left(), box.bottom()), QPointF(box.right(), box.bottom()));
  const auto top = box.bottom() - box.height() * kBarShare;
  const auto bar = [&](const dc::SyncTimeline::Span& span, const QColor& color) {
    // What reaches beyond the right end goes on at the left.
    for (const auto shift : {Nanoseconds{0}, line_.length}) {
      const auto from = std::max(xOf(span.from - shift), box.left());
      const auto to = std::min(xOf(span.to - shift), box.right());
      if (to <= from && (shift > 0 || span.to > line_.length)) continue;
      painter.fillRect(QRectF(from, top, std::max(to - from, 2.0), box.bottom() - top), color);
    }
  };
  const auto edge = [&](Nanoseconds time, const QColor& color) {
    painter.setPen(QPen(color, 2));
    painter.drawLine(QPointF(xOf(time), box.top() + 2), QPointF(xOf(time), box.bottom()));
  };
  switch (row) {
    case Row::kFrame:
      for (const auto& span : line_.outputs) bar(span, plot_colors::trace(palette(), 0));
      break;
    case Row::kCompute:
      for (const auto& span : line_.compute)
        bar(span, theme::toneColor(palette(), isTooTight() ? theme::Tone::kBad : theme::Tone::kGood));
      break;
    case Row::kSync0:
      for (const auto time : line_.sync0) edge(time, palette().color(QPalette::Text));
      break;
    case Row::kSync1:
      for (const auto time : line_.sync1) edge(time, plot_colors::trace(palette(), 1));
      break;
    case Row::kLatch: {
      // Edges may come at any time; what is told is when a frame takes their times along.
      auto armed = plot_colors::trace(palette(), 2);
      armed.setAlpha(kArmedAlpha);
      bar({0, line_.length}, armed);
      for (const auto time : line_.latch_reads) edge(time, plot_colors::trace(palette(), 2));
      break;
    }
  }
}

/// From the end of the first frame to the SYNC0 that uses it.
void TimingDiagram::drawMargin(QPainter& painter) const {
  if (!line_.margin || line_.outputs.empty()) return;
  const auto from = line_.outputs.front().to;
  const auto grid = dc::Sync0Grid{timing_->set_value + timing_->sync0.first, timing_->sync0.period};
  const auto to = std::min(from + dc::sync0_arrival(grid, from).margin, line_.length);
  const auto y = area().top() + rowHeight() * (static_cast<double>(rows().size()) + 0.5);
  const auto color = theme::toneColor(palette(), isTooTight() ? theme::Tone::kBad : theme::Tone::kGood);
  const auto left = xOf(from), right = xOf(to);
  painter.setPen(QPen(color, 1));
  const auto text = timeText(*line_.margin);
  const auto width = fontMetrics().horizontalAdvance(text) + 2.0 * kNameGap;
  for (const auto x : {left, right}) painter.drawLine(QPointF(x, y - 4), QPointF(x, y + 4));
  if (right - left >= width + 10) {
    const auto middle = (left + right) / 2;
    painter.drawLine(QPointF(left, y), QPointF(middle - width / 2, y));
    painter.drawLine(QPointF(middle + width / 2, y), QPointF(right, y));
    painter.drawText(QRectF(middle - width / 2, y - rowHeight() / 2.0, width, rowHeight()), Qt::AlignCenter, text);
    return;
  }
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  const bool beside = right + width < this->width();
  painter.drawText(QRectF(beside ? right : left - width, y - rowHeight() / 2.0, width, rowHeight()), Qt::AlignCenter,
                   text);
}

bool TimingDiagram::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), described(), this);
  return true;
}

}  // namespace syncline::ui
