// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "trace/distribution.h"

namespace syncline::ui {

/// Counts of equal bins on a logarithmic axis, several signals over each other as steps. What lies outside stands in a
/// bar of its own at either end.
class HistogramPlot final : public QWidget {
  Q_OBJECT

 public:
  struct Steps {
    QString name;
    QColor color;
    std::vector<std::uint64_t> bins;
    std::uint64_t below = 0, above = 0;
    bool operator==(const Steps&) const = default;
  };

  explicit HistogramPlot(QWidget* parent = nullptr);
  /// `limit`: a magnitude in the unit of the bins, 0: none. `unit`: of the bins.
  void setData(const BinGrid& grid, std::vector<Steps> steps, double limit, const QString& unit);
  [[nodiscard]] const std::vector<Steps>& steps() const { return steps_; }
  /// Outlined; -2: none.
  void setChosen(std::ptrdiff_t bin);
  /// Under a point: -1 below, the number of bins above, -2 beside them.
  [[nodiscard]] std::ptrdiff_t binAt(const QPointF& point) const;
  /// Where a bin is drawn.
  [[nodiscard]] QRectF binArea(std::ptrdiff_t bin) const;
  [[nodiscard]] double heightOf(std::uint64_t count) const;
  [[nodiscard]] QSize sizeHint() const override { return {420, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 80}; }

 Q_SIGNALS:
  void binClicked(qint64 bin);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] double xOf(double value) const;
  void drawAxes(QPainter& painter) const;
  void drawSteps(QPainter& painter, const Steps& steps) const;
  void drawLimit(QPainter& painter) const;
  [[nodiscard]] QString textOf(std::ptrdiff_t bin) const;

  BinGrid grid_;
  std::vector<Steps> steps_;
  double limit_ = 0;
  QString unit_;
  int decades_ = 1;
  std::ptrdiff_t chosen_ = -2;
};

}  // namespace syncline::ui
