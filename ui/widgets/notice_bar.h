// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "ui/theme/theme.h"

namespace syncline::ui {

/// A bar across the window that tells of a state as long as it lasts: filled in the colour of its tone, with a line
/// towards what it is about.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  /// `towards`: Qt::TopEdge or Qt::BottomEdge.
  NoticeBar(theme::Tone tone, Qt::Edge towards, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  theme::Tone tone_;
  Qt::Edge towards_;
};

}  // namespace syncline::ui
