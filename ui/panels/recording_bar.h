// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QLabel;

namespace syncline::ui {

class OpenedRecording;

/// Stands above everything while a recording is shown: that it is one, of what, when, how long, and the way back.
class RecordingBar final : public QFrame {
  Q_OBJECT

 public:
  explicit RecordingBar(OpenedRecording& recording, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();

  OpenedRecording& recording_;
  QLabel* text_;
};

}  // namespace syncline::ui
