// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

#include "support/types.h"

class QHBoxLayout;
class QToolButton;

namespace syncline::ui {

class CursorSet;
class TimeView;

class ValueLabel;

/// Window length, following, freezing, cursors: the line above the plots of the live strip.
class LiveStripToolbar final : public QWidget {
  Q_OBJECT

 public:
  LiveStripToolbar(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  /// Writes the state in words; a few times a second.
  void showState();

  /// What is followed is no machine but a moment of a recording.
  void setReplayed(bool replayed);
  /// What stands in place of the plots.
  enum class View : std::uint8_t { kNone, kFree, kDistribution, kStability, kSlaves, kCycle };
  void setWanted(View view);
  void setFoldable(bool foldable);
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void viewToggled(syncline::ui::LiveStripToolbar::View view, bool on);
  /// The distance of the cursors is to be typed.
  void distanceWanted();
  void fitRequested();
  void triggerWanted();
  void foldWanted();
  void cursorsToggled(bool on);
  void menuRequested(const QPoint& global);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addView(QHBoxLayout* layout, View view, const char* name, const QString& text, const QString& tip);
  QToolButton* addButton(QHBoxLayout* layout, const char* name, const QString& text, const QString& tip);
  void buildViews(QHBoxLayout* layout);
  void showViews();
  [[nodiscard]] int spare() const;

  TimeView* view_;
  CursorSet* cursors_;
  struct Length {
    QToolButton* button;
    Nanoseconds span;
  };
  std::vector<Length> lengths_;
  struct ViewButton {
    View view;
    QToolButton* button;
  };
  std::vector<ViewButton> view_buttons_;
  QToolButton *live_, *freeze_, *measure_, *views_, *fold_;
  bool replayed_ = false;
  bool narrow_ = false;  // the views stand in one menu
  ValueLabel *state_, *delta_;
};

}  // namespace syncline::ui
