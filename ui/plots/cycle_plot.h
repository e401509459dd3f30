// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "trace/arrival_figures.h"
#include "ui/plots/sync0_period.h"

namespace syncline::ui {

/// One SYNC0 period of a slave to scale: SYNC0 at both ends, when its outputs came as logarithmic bars whose colour
/// fades with the age of their latest arrival, a line where they nominally come, and in front of the SYNC0 that uses
/// them the time that calculating and copying takes.
class CyclePlot final : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kBins = 400;
  struct Picture {
    Nanoseconds period = 0;                      // 0: nothing is drawn
    std::optional<Nanoseconds> calc_and_copy{};  // nothing: not known
    std::optional<Nanoseconds> nominal{};        // when outputs come by set value and delays; nothing: nobody holds it
    Nanoseconds begin = 0, end = 0;              // of the stretch that the arrivals are of
    ArrivalFigures figures{};
    bool operator==(const Picture&) const = default;
  };

  explicit CyclePlot(QWidget* parent = nullptr);
  void setPicture(Picture picture);
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Where a time since the first SYNC0 is drawn.
  [[nodiscard]] double xOf(Nanoseconds phase) const;
  /// Where bars stand, between the two SYNC0.
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] QSize sizeHint() const override { return {420, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 80}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] Sync0Period period() const;
  /// Of a bar; `most` is as high as the area.
  [[nodiscard]] double heightOf(std::uint64_t count, std::uint64_t most) const;
  void drawCounts(QPainter& painter, std::uint64_t most) const;
  void drawBars(QPainter& painter, std::uint64_t most) const;
  void drawNominal(QPainter& painter) const;

  Picture picture_;
};

}  // namespace syncline::ui
