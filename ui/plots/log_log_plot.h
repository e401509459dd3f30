// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/plots/decade_axis.h"
#include "ui/text/quantity_text.h"

namespace syncline::ui {

/// Up to a few curves over each other on two logarithmic axes, a limit, and the reading of a point by pointer or keys.
class LogLogPlot final : public QWidget {
  Q_OBJECT

 public:
  /// A point that has a name or rests on a figure of its own: the keys stop there.
  struct Stop {
    QPointF at;
    QString note;       // what there is to say besides both values
    bool weak = false;  // rests on little: hollow
    bool bad = false;   // beyond the limit: crossed out in its colour
    bool operator==(const Stop&) const = default;
  };
  struct Curve {
    QString name;
    QColor color;
    std::vector<QPointF> line;  // both > 0, by x
    std::vector<Stop> stops;
    bool numbered = false;  // of many points; its few stops are numbered from 1 on. Else stops are dots
    bool operator==(const Curve&) const = default;
  };
  struct Axes {
    Quantity x = Quantity::kSeconds, y = Quantity::kNanoseconds;
    QString title;  // what is drawn over what
    bool operator==(const Axes&) const = default;
  };
  struct Limit {
    double value = 0;  // 0: none
    QString text;
    std::vector<QPointF> line{};  // by x; empty: the same value everywhere. Else `value` is the highest of it
    bool operator==(const Limit&) const = default;
  };

  explicit LogLogPlot(QWidget* parent = nullptr);
  /// `chosen`: the curve in front. A reading stays where its point does.
  void setData(const Axes& axes, std::vector<Curve> curves, const Limit& limit, int chosen);
  [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }
  [[nodiscard]] const Limit& limit() const { return limit_; }
  /// "16.0 ms: 3.21 ns" with the note; empty when nothing is read.
  [[nodiscard]] QString reading() const;
  /// Where a point is drawn.
  [[nodiscard]] QPointF placeOf(const QPointF& point) const;
  [[nodiscard]] QSize sizeHint() const override { return {420, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 80}; }

 Q_SIGNALS:
  void curveChosen(int curve);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Reading {
    int curve = 0;
    QPointF at;
    bool operator==(const Reading&) const = default;
  };
  [[nodiscard]] QRectF area() const;
  void scaleAxes();
  [[nodiscard]] std::optional<Reading> readingAt(const QPointF& pointer) const;
  [[nodiscard]] std::optional<Reading> highestNear(const QPointF& pointer) const;
  [[nodiscard]] const std::optional<Reading>& shown() const { return pointed_ ? pointed_ : kept_; }
  [[nodiscard]] const Stop* stopOf(const Reading& reading) const;
  void stepStop(int by);
  void stepCurve(int by);
  void keep(std::optional<Reading> reading);
  void drawGrid(QPainter& painter) const;
  void drawCurve(QPainter& painter, int number) const;
  void drawStops(QPainter& painter, const Curve& curve, bool chosen) const;
  void drawLimit(QPainter& painter) const;
  void drawMask(QPainter& painter) const;
  void drawLimitText(QPainter& painter, const QPointF& right, const QString& text) const;
  void drawReading(QPainter& painter) const;

  Axes axes_;
  std::vector<Curve> curves_;
  Limit limit_;
  int chosen_ = 0;
  DecadeAxis x_, y_;
  std::optional<Reading> pointed_, kept_;
};

}  // namespace syncline::ui
