// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/notice_bar.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace syncline::ui {

class StartRefusal;

/// Stands below the pages after a start that failed: why, and the ways on. Goes with the next start, or when it is
/// closed.
class StartBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit StartBar(StartRefusal& refusal, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// What is on the bus is to be looked at, beside the project.
  void scanWanted();
  /// The slave that the reason is about.
  void slaveWanted(int position);

 private:
  void refresh();

  StartRefusal& refusal_;
  QLabel* text_;
  QPushButton *slave_, *scan_;
  QToolButton* close_;
};

}  // namespace syncline::ui
