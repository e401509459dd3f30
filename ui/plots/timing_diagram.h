// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "dc/sync_timeline.h"

namespace syncline::ui {

/// One cycle of a slave to scale: when the frame passes it, how long it calculates and copies, when SYNC0 and SYNC1
/// come, when frames read the times that its latch unit took; and the time that is left before SYNC0, which is red
/// where calculating and copying does not fit into it. What it shows it also says, as its accessible description and
/// beside the pointer.
class TimingDiagram final : public QWidget {
  Q_OBJECT

 public:
  explicit TimingDiagram(QWidget* parent = nullptr);
  /// Nothing: no SYNC0, and that is said.
  void setTiming(std::optional<dc::SlaveTiming> timing);
  [[nodiscard]] const dc::SyncTimeline& timeline() const { return line_; }
  /// All that is drawn in one sentence each.
  [[nodiscard]] QString described() const;
  /// Calculating and copying does not fit before SYNC0.
  [[nodiscard]] bool isTooTight() const;
  /// Where a time since the frame passed the reference clock is drawn.
  [[nodiscard]] double xOf(Nanoseconds time) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Row : unsigned char { kFrame, kCompute, kSync0, kSync1, kLatch };
  [[nodiscard]] QList<Row> rows() const;
  [[nodiscard]] static QString rowName(Row row);
  [[nodiscard]] int rowHeight() const;
  [[nodiscard]] int nameWidth() const;
  [[nodiscard]] QRectF area() const;
  void drawAxis(QPainter& painter) const;
  void drawRow(QPainter& painter, Row row, const QRectF& box) const;
  void drawMargin(QPainter& painter) const;

  std::optional<dc::SlaveTiming> timing_;
  dc::SyncTimeline line_;
};

}  // namespace syncline::ui
