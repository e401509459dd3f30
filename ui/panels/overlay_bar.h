// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/notice_bar.h"

class QComboBox;
class QDoubleSpinBox;

namespace syncline::ui {

class RecordingOverlay;
class TriggerMonitor;
class ValueLabel;

/// Stands below the bar of the recording while another one lies over it: which, by what the two are aligned, by how
/// much it is moved, and how to take it away.
class OverlayBar final : public NoticeBar {
  Q_OBJECT

 public:
  OverlayBar(RecordingOverlay& overlay, const TriggerMonitor& trigger, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// It cannot be aligned so: why, a sentence.
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void align(int choice);
  void refresh();

  RecordingOverlay& overlay_;
  const TriggerMonitor& trigger_;
  ValueLabel* name_;
  QComboBox* place_;
  QDoubleSpinBox* offset_;
};

}  // namespace syncline::ui
