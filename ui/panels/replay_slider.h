// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSlider>

#include "support/types.h"

namespace syncline::ui {

class RecordingReplay;

/// Where in the recording the moment is, with the events and notes as ticks below. A click goes there at once; the
/// wheel moves it only where it has the focus.
class ReplaySlider final : public QSlider {
  Q_OBJECT

 public:
  explicit ReplaySlider(RecordingReplay& replay, QWidget* parent = nullptr);
  /// The moment, as it is; emits nothing.
  void showMoment();

 Q_SIGNALS:
  void momentChosen(syncline::Nanoseconds moment);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  [[nodiscard]] int valueOf(Nanoseconds moment) const;
  [[nodiscard]] QRect grooveOf() const;

  RecordingReplay& replay_;
};

}  // namespace syncline::ui
