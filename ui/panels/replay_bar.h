// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

#include "support/types.h"

class QAction;
class QComboBox;
class QHBoxLayout;
class QKeySequence;
class QLabel;
class QToolButton;

namespace syncline::ui {

class RecordingReplay;
class ReplaySlider;

/// The transport of a recording that is shown: play and pause, a cycle or an event further or back, speed, place, time,
/// and the way back to the whole. Stands in the bar of the recording; its actions are those of the menu, too.
class ReplayBar final : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayBar(RecordingReplay& replay, QWidget* parent = nullptr);
  /// In the order of the menu.
  [[nodiscard]] const QList<QAction*>& commands() const { return commands_; }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QAction* command(const char* name, const QString& text, const QString& tip, const char* icon,
                   const QKeySequence& keys);
  void addButton(QHBoxLayout& layout, QAction& action, const char* name);
  void refresh();
  void showMoment();
  void keepRoom();
  void fit();
  [[nodiscard]] QString text(Nanoseconds moment, bool narrow) const;
  void drawIcons();

  RecordingReplay& replay_;
  QList<QAction*> commands_;
  QAction *begin_, *last_mark_, *last_cycle_, *play_, *next_cycle_, *next_mark_, *end_, *slower_, *faster_, *whole_;
  QComboBox* speed_;
  ReplaySlider* place_;
  QLabel* time_;
  QToolButton* leave_;
  bool narrow_ = false;  // the time stands without the end
  int spare_ = 0;        // px that this saves
};

}  // namespace syncline::ui
