// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/log_log_plot.h"

#include <qwt_clipper.h>
#include <qwt_painter.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/plots/small_font.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kLeftOfScale = 58, kRightOfScale = 10, kTopOfScale = 6, kBelowScale = 32;
constexpr double kPointReach = 14;  // px from the pointer to a point that it means
constexpr double kFloor = 1e-7;     // of the highest value: what is below is rounding
constexpr double kLimitRoom = 30;   // a limit so many times above the curves is still shown in its place

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

LogLogPlot::LogLogPlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  speaksValue(*this);
}

void LogLogPlot::setData(const Axes& axes, std::vector<Curve> curves, const Limit& limit, int chosen) {
  const bool other = axes != axes_;
  axes_ = axes;
  curves_ = std::move(curves);
  limit_ = limit;
  chosen_ = std::clamp(chosen, 0, std::max(static_cast<int>(curves_.size()) - 1, 0));
  scaleAxes();
  // Of a curve that was computed anew the point at the same place is read.
  for (auto* reading : {&pointed_, &kept_}) {
    if (!*reading) continue;
    const auto before = std::exchange(*reading, std::nullopt);
    if (other || before->curve >= static_cast<int>(curves_.size())) continue;
    for (const auto& stop : curves_[static_cast<std::size_t>(before->curve)].stops) {
      if (std::abs(stop.at.x() - before->at.x()) < 1e-3 * before->at.x()) *reading = Reading{before->curve, stop.at};
    }
  }
  update();
}

void LogLogPlot::scaleAxes() {
  double left = std::numeric_limits<double>::max(), low = left, right = 0, high = 0;
  for (const auto& curve : curves_) {
    for (const auto& point : curve.line) {
      left = std::min(left, point.x());
      right = std::max(right, point.x());
      high = std::max(high, point.y());
    }
  }
  for (const auto& curve : curves_) {
    for (const auto& point : curve.line) {
      if (point.y() > high * kFloor) low = std::min(low, point.y());
    }
  }
  if (right <= 0 || high <= 0) {
    x_ = y_ = DecadeAxis(1, 10);
    return;
  }
  const auto make_room = [&, most = high * kLimitRoom](double value) {
    if (value >= most) return;
    high = std::max(high, value);
    low = std::min(low, value);
  };
  for (const auto& point : limit_.line) {
    if (point.x() >= left && point.x() <= right) make_room(point.y());
  }
  if (limit_.line.empty() && limit_.value > 0) make_room(limit_.value);
  x_ = DecadeAxis(left, right);
  y_ = DecadeAxis(low, high);
}

QRectF LogLogPlot::area() const {
  return QRectF(rect()).adjusted(kLeftOfScale, kTopOfScale, -kRightOfScale, -kBelowScale);
}

QPointF LogLogPlot::placeOf(const QPointF& point) const {
  const auto all = area();
  return {all.left() + x_.place(point.x()) * all.width(),
          all.bottom() - std::max(y_.place(std::max(point.y(), y_.low() * 1e-3)), -0.1) * all.height()};
}

void LogLogPlot::drawGrid(QPainter& painter) const {
  const auto all = area();
  const auto text = theme::mutedText(palette());
  const auto decade = plot_colors::grid(palette());
  auto between = decade;
  between.setAlpha(110);
  const int high = painter.fontMetrics().height();
  for (const auto& tick : x_.ticks(static_cast<int>(all.width() / 58))) {
    const double x = all.left() + x_.place(tick.value) * all.width();
    painter.setPen(QPen(tick.decade ? decade : between, 0));
    painter.drawLine(QPointF(x, all.top()), QPointF(x, all.bottom()));
    if (!tick.labelled) continue;
    painter.setPen(text);
    painter.drawText(QRectF(x - 40, all.bottom() + 1, 80, 15), Qt::AlignCenter, axisText(axes_.x, tick.value));
  }
  for (const auto& tick : y_.ticks(static_cast<int>(all.height() / (high + 4)))) {
    const double y = all.bottom() - y_.place(tick.value) * all.height();
    painter.setPen(QPen(tick.decade ? decade : between, 0));
    painter.drawLine(QPointF(all.left(), y), QPointF(all.right(), y));
    if (!tick.labelled) continue;
    painter.setPen(text);
    painter.drawText(QRectF(0, y - 10, kLeftOfScale - 5, 20), Qt::AlignRight | Qt::AlignVCenter,
                     axisText(axes_.y, tick.value));
  }
  painter.setPen(text);
  painter.drawText(QRectF(kLeftOfScale, height() - 16, all.width(), 15), Qt::AlignCenter, axes_.title);
}

void LogLogPlot::drawCurve(QPainter& painter, int number) const {
  const auto& curve = curves_[static_cast<std::size_t>(number)];
  QPolygonF line;
  // Of many points in one column of pixels the highest is drawn: no line of a spectrum is lost.
  for (const auto& point : curve.line) {
    const auto place = placeOf(point);
    if (!line.isEmpty() && curve.numbered && std::floor(line.last().x()) == std::floor(place.x())) {
      if (place.y() < line.last().y()) line.last().setY(place.y());
    } else {
      line.append(place);
    }
  }
  const bool front = number == chosen_;
  painter.setPen(QPen(curve.color, front && !curve.numbered ? 2 : 1.2));
  painter.setBrush(Qt::NoBrush);
  // An SVG has no clip: Qwt cuts the line itself.
  QwtPainter::drawPolyline(&painter, line);
  drawStops(painter, curve, front);
}

void LogLogPlot::drawStops(QPainter& painter, const Curve& curve, bool chosen) const {
  int number = 0;
  for (const auto& stop : curve.stops) {
    const auto place = placeOf(stop.at);
    ++number;
    if (!curve.numbered) {
      painter.setPen(QPen(curve.color, 1.2));
      painter.setBrush(stop.weak ? palette().color(QPalette::Base) : curve.color);
      painter.drawEllipse(place, 3, 3);
      if (!stop.bad) continue;
      painter.setPen(QPen(plot_colors::limitLine(palette()), 1.6));
      painter.drawLine(place + QPointF(-5, -5), place + QPointF(5, 5));
      painter.drawLine(place + QPointF(-5, 5), place + QPointF(5, -5));
    } else if (chosen) {
      painter.setPen(palette().color(QPalette::Text));
      QRectF box(0, 0, 16, painter.fontMetrics().height());
      const bool right = place.x() + 20 < area().right();
      box.moveCenter({place.x() + (right ? 11 : -11), std::max(place.y() - 2, area().top() + 7)});
      painter.drawText(box, Qt::AlignCenter, QString::number(number));
    }
  }
}

void LogLogPlot::drawLimit(QPainter& painter) const {
  if (limit_.value <= 0 || curves_.empty()) return;
  const auto all = area();
  if (!limit_.line.empty()) return drawMask(painter);
  const bool above = limit_.value > y_.high();
  const double y = above ? all.top() : placeOf({x_.low(), limit_.value}).y();
  const auto text = limit_.text + (above ? QStringLiteral(" \u2191") : QString());
  painter.setPen(QPen(plot_colors::limitLine(palette()), 1, Qt::DashLine));
  if (!above) painter.drawLine(QPointF(all.left(), y), QPointF(all.right(), y));
  drawLimitText(painter, {all.right() - 2, y}, text);
}

void LogLogPlot::drawMask(QPainter& painter) const {
  const auto all = area();
  QPolygonF line;
  for (const auto& point : limit_.line)
    line.append({all.left() + x_.place(point.x()) * all.width(), all.bottom() - y_.place(point.y()) * all.height()});
  painter.setPen(QPen(plot_colors::limitLine(palette()), 1, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  QwtPainter::drawPolyline(&painter, QwtClipper::clippedPolygonF(all, line));
  // Its name stands where it ends, inside.
  const auto end =
      std::ranges::find_if(line.rbegin(), line.rend(), [&](const QPointF& at) { return at.x() <= all.right(); });
  const double y = end == line.rend() ? all.top() : std::clamp(end->y(), all.top(), all.bottom());
  drawLimitText(painter, {all.right() - 2, y}, limit_.text);
}

/// `right`: its right end, on the line.
void LogLogPlot::drawLimitText(QPainter& painter, const QPointF& right, const QString& text) const {
  const auto all = area();
  const double y = right.y();
  QRectF box(0, 0, painter.fontMetrics().horizontalAdvance(text) + 6, painter.fontMetrics().height());
  const bool below = y - box.height() < all.top();
  box.moveTopRight({right.x(), below ? y + 1 : y - box.height() - 1});
  auto background = palette().color(QPalette::Base);
  background.setAlpha(215);
  painter.fillRect(box, background);
  painter.setPen(plot_colors::limitLine(palette()));
  painter.drawText(box, Qt::AlignCenter, text);
}

void LogLogPlot::drawReading(QPainter& painter) const {
  if (!shown()) return;
  const auto all = area();
  const auto place = placeOf(shown()->at);
  painter.setPen(QPen(theme::mutedText(palette()), 0, Qt::DotLine));
  painter.drawLine(QPointF(place.x(), all.top()), QPointF(place.x(), all.bottom()));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(place, 5, 5);
  const auto text = reading();
  QRectF box(QPointF(), QSizeF(painter.fontMetrics().size(0, text)) + QSizeF(10, 6));
  box.moveTopLeft({place.x() + 10, place.y() - box.height() - 8});
  if (box.right() > all.right()) box.moveRight(place.x() - 10);
  box.moveLeft(std::max(box.left(), all.left() + 1));
  if (box.top() < all.top()) box.moveTop(place.y() + 10);
  box.moveBottom(std::min(box.bottom(), all.bottom() - 1));
  painter.setPen(QPen(theme::outline(palette()), 0));
  painter.setBrush(palette().color(QPalette::ToolTipBase));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(palette().color(QPalette::ToolTipText));
  painter.drawText(box, Qt::AlignCenter, text);
}

void LogLogPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(smallFont(font()));
  painter.fillRect(area(), palette().color(QPalette::Base));
  drawGrid(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.setClipRect(area().adjusted(-4, -4, 4, 4));
  for (int i = 0; i < static_cast<int>(curves_.size()); ++i) {
    if (i != chosen_) drawCurve(painter, i);
  }
  if (!curves_.empty()) drawCurve(painter, chosen_);
  painter.restore();
  drawLimit(painter);
  drawReading(painter);
  if (!hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 0));
  painter.drawRect(area().adjusted(0, 0, -1, -1));
}

const LogLogPlot::Stop* LogLogPlot::stopOf(const Reading& reading) const {
  if (reading.curve >= static_cast<int>(curves_.size())) return nullptr;
  const auto& stops = curves_[static_cast<std::size_t>(reading.curve)].stops;
  const auto found = std::ranges::find(stops, reading.at, &Stop::at);
  return found == stops.end() ? nullptr : &*found;
}

QString LogLogPlot::reading() const {
  if (!shown()) return {};
  const auto& at = shown()->at;
  auto text = quantityText(axes_.x, at.x()) + QStringLiteral(": ") + quantityText(axes_.y, at.y());
  if (curves_.size() > 1) text.prepend(curves_[static_cast<std::size_t>(shown()->curve)].name + u'\n');
  const auto* stop = stopOf(*shown());
  if (stop != nullptr && !stop->note.isEmpty()) text += u'\n' + stop->note;
  return text;
}

std::optional<LogLogPlot::Reading> LogLogPlot::readingAt(const QPointF& pointer) const {
  std::optional<Reading> best;
  double nearest = kPointReach;
  for (int i = 0; i < static_cast<int>(curves_.size()); ++i) {
    for (const auto& stop : curves_[static_cast<std::size_t>(i)].stops) {
      const double far = distance(placeOf(stop.at), pointer);
      if (far >= nearest) continue;
      nearest = far;
      best = Reading{i, stop.at};
    }
  }
  return best ? best : highestNear(pointer);
}

/// Of a curve without a stop there: its highest point in a few columns about the pointer.
std::optional<LogLogPlot::Reading> LogLogPlot::highestNear(const QPointF& pointer) const {
  const auto all = area();
  if (!all.contains(pointer)) return std::nullopt;
  const auto from = x_.value((pointer.x() - 2 - all.left()) / all.width());
  const auto to = x_.value((pointer.x() + 2 - all.left()) / all.width());
  std::optional<Reading> best;
  double nearest = 3 * kPointReach;
  for (int i = 0; i < static_cast<int>(curves_.size()); ++i) {
    const auto& line = curves_[static_cast<std::size_t>(i)].line;
    if (!curves_[static_cast<std::size_t>(i)].numbered) continue;
    const auto begin = std::ranges::lower_bound(line, from, {}, &QPointF::x);
    const auto end = std::ranges::upper_bound(begin, line.end(), to, {}, &QPointF::x);
    if (begin == end) continue;
    const auto top = std::ranges::max_element(begin, end, {}, &QPointF::y);
    const double far = std::abs(placeOf(*top).y() - pointer.y());
    if (far >= nearest) continue;
    nearest = far;
    best = Reading{i, *top};
  }
  return best;
}

void LogLogPlot::keep(std::optional<Reading> reading) {
  kept_ = reading;
  pointed_.reset();
  sayValue(*this, this->reading());
  if (reading && reading->curve != chosen_) Q_EMIT curveChosen(reading->curve);
  update();
}

void LogLogPlot::mouseMoveEvent(QMouseEvent* event) {
  const auto found = readingAt(event->position());
  if (found == pointed_) return;
  pointed_ = found;
  update();
}

void LogLogPlot::leaveEvent(QEvent*) {
  pointed_.reset();
  update();
}

void LogLogPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  keep(readingAt(event->position()));
}

void LogLogPlot::stepStop(int by) {
  if (curves_.empty()) return;
  auto stops = curves_[static_cast<std::size_t>(chosen_)].stops;
  if (stops.empty()) return;
  std::ranges::sort(stops, {}, [](const Stop& stop) { return stop.at.x(); });
  const auto last = static_cast<std::ptrdiff_t>(stops.size()) - 1;
  auto place = by > 0 ? std::ptrdiff_t{0} : last;
  if (kept_ && kept_->curve == chosen_) {
    const auto now = std::ranges::lower_bound(stops, kept_->at.x(), {}, [](const Stop& stop) { return stop.at.x(); });
    place = std::clamp<std::ptrdiff_t>(now - stops.begin() + by, 0, last);
  }
  keep(Reading{chosen_, stops[static_cast<std::size_t>(place)].at});
}

/// To the stop of another curve that is nearest to the one that was read.
void LogLogPlot::stepCurve(int by) {
  const int other = chosen_ + by;
  if (other < 0 || other >= static_cast<int>(curves_.size())) return;
  const auto& stops = curves_[static_cast<std::size_t>(other)].stops;
  if (stops.empty()) return Q_EMIT curveChosen(other);
  const double wanted = kept_ ? kept_->at.x() : stops.front().at.x();
  const auto far = [wanted](const Stop& stop) { return std::abs(std::log(stop.at.x() / wanted)); };
  keep(Reading{other, std::ranges::min_element(stops, {}, far)->at});
}

void LogLogPlot::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return stepStop(-1);
    case Qt::Key_Right:
      return stepStop(1);
    case Qt::Key_Up:
      return stepCurve(-1);
    case Qt::Key_Down:
      return stepCurve(1);
    default:
      return QWidget::keyPressEvent(event);
  }
}

}  // namespace syncline::ui
