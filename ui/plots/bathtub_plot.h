// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <optional>

#include "trace/arrival_bathtub.h"
#include "ui/plots/sync0_period.h"

namespace syncline::ui {

/// One SYNC0 period of a slave to scale, and how probable it is that its outputs come later than a moment of it, or
/// earlier: two walls that fall towards both SYNC0, on a logarithmic axis. What nobody has seen often enough is dashed.
class BathtubPlot final : public QWidget {
  Q_OBJECT

 public:
  struct Picture {
    Nanoseconds period = 0;                      // 0: nothing is drawn
    std::optional<Nanoseconds> calc_and_copy{};  // nothing: not known
    ArrivalBathtub bathtub{};
    bool operator==(const Picture&) const = default;
  };

  explicit BathtubPlot(QWidget* parent = nullptr);
  void setPicture(Picture picture);
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Where a time since the first SYNC0 and a probability are drawn.
  [[nodiscard]] QPointF placeOf(double phase, double probability) const;
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] QSize sizeHint() const override { return {420, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 80}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] Sync0Period period() const;
  void drawDecades(QPainter& painter) const;
  void drawWall(QPainter& painter, const std::vector<ArrivalBathtub::Point>& wall, bool late) const;

  Picture picture_;
};

}  // namespace syncline::ui
