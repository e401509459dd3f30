// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

namespace syncline::ui {

class OpenedRecording;
class ValueLabel;

/// Stands above everything while a recording is shown: that it is one, of what, when, how long, its transport, and the
/// way back.
class RecordingBar final : public QFrame {
  Q_OBJECT

 public:
  /// Takes the transport.
  RecordingBar(OpenedRecording& recording, QWidget* transport, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();

  OpenedRecording& recording_;
  ValueLabel* text_;
};

}  // namespace syncline::ui
