// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <QObject>
#include <array>
#include <optional>

#include "ui/plots/series_item.h"

namespace syncline::ui {

/// Two measuring cursors and the place of the pointer, shared by linked plots. They are times of the
/// data, so they move with the data; or they are held at their places on the screen, and the data pass them.
class CursorSet final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  enum Which : unsigned char { kA, kB };

  void set(Which which, std::optional<Nanoseconds> time);
  void clear();
  [[nodiscard]] std::optional<Nanoseconds> at(Which which) const { return cursors_[which]; }
  [[nodiscard]] bool both() const { return cursors_[kA] && cursors_[kB]; }
  [[nodiscard]] bool any() const { return cursors_[kA] || cursors_[kB]; }
  /// B minus A; 0 unless both are set.
  [[nodiscard]] Nanoseconds delta() const { return both() ? *cursors_[kB] - *cursors_[kA] : 0; }

  void setHeld(bool held);
  [[nodiscard]] bool held() const { return held_; }
  /// What the linked plots show from now on; cursors that are held are at other times then.
  void follow(Nanoseconds begin, Nanoseconds span);

  void setPointer(std::optional<Nanoseconds> time);
  [[nodiscard]] std::optional<Nanoseconds> pointer() const { return pointer_; }

 Q_SIGNALS:
  void changed();  // a cursor
  void pointerMoved();

 private:
  void keepPlace(Which which);

  std::array<std::optional<Nanoseconds>, 2> cursors_;
  std::optional<Nanoseconds> pointer_;
  bool held_ = false;
  Nanoseconds begin_ = 0, span_ = 1;  // of what is shown
  std::array<double, 2> places_{};    // in parts of the span, while they are held
};

/// Draws a CursorSet into one plot.
class CursorItem final : public QwtPlotItem {
 public:
  explicit CursorItem(const CursorSet* cursors);
  void setColors(const QColor& line, const QColor& text);
  void prepare(const ColumnGrid& grid) { grid_ = grid; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  const CursorSet* cursors_;
  QColor line_, text_;
  ColumnGrid grid_;
};

}  // namespace syncline::ui
