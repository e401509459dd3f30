// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/plots/cursor_item.h"
#include "ui/plots/time_view.h"
#include "ui/session/opened_recording.h"

namespace syncline::ui {

class LegendBar;
class SeriesItem;
class TracePlot;

/// The first picture of a recording: the curves of the bus over the whole of it, while its samples are read. They are
/// drawn as the plots of the window are going to draw them, can be zoomed and moved, and say nothing else: what needs
/// all samples is not known yet.
class OpeningPicture final : public QWidget {
  Q_OBJECT

 public:
  explicit OpeningPicture(const OpenedRecording::Outline& outline, QWidget* parent = nullptr);
  ~OpeningPicture() override;

  /// What was wanted.
  void take(const std::vector<FirstPicture>& pictures);
  /// Draws what has changed, and asks for what it lacks; as the tick does.
  void refresh();
  [[nodiscard]] TimeView* timeView() { return &view_; }

 Q_SIGNALS:
  void wanted(const std::vector<syncline::ui::FirstPicture>& pictures);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Curves {
    TracePlot* plot = nullptr;
    LegendBar* legend = nullptr;
    std::vector<Signal> signals;
    std::vector<SeriesItem*> items;  // by signal
  };
  Curves& add(const QString& title, const QString& quantity, const char* name);
  void addCurve(Curves& curves, Signal signal, const QString& title, Nanoseconds cycle_time);
  void applyTheme();

  TimeView view_;
  CursorSet cursors_;
  std::vector<Curves> curves_;
  std::vector<ColumnGrid> asked_;  // by plot
  QTimer tick_;
};

}  // namespace syncline::ui
