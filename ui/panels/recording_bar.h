// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/notice_bar.h"

namespace syncline::ui {

class OpenedRecording;
class ValueLabel;

/// Stands above everything while a recording is shown: that it is one, of what, when, how long, its transport, and the
/// way back.
class RecordingBar final : public NoticeBar {
  Q_OBJECT

 public:
  /// Takes the transport.
  RecordingBar(OpenedRecording& recording, QWidget* transport, QWidget* parent = nullptr);

 private:
  void refresh();

  OpenedRecording& recording_;
  ValueLabel* text_;
};

}  // namespace syncline::ui
