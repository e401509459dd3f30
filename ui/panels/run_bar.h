// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/notice_bar.h"

class QLabel;
class QPushButton;

namespace syncline::ui {

class RunDifference;

/// Stands above the pages while the project is not what the machine runs: what differs, and the ways to make them one.
class RunBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit RunBar(RunDifference& difference, QWidget* parent = nullptr);

 Q_SIGNALS:
  void differencesWanted();
  void restartWanted();
  void revertWanted();

 private:
  void refresh();
  QPushButton* add(const char* object_name, const QString& text, const QString& tip);

  RunDifference& difference_;
  QLabel* text_;
  QPushButton *show_, *apply_, *restart_, *revert_;
};

}  // namespace syncline::ui
