// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QLabel;
class QProgressBar;

namespace syncline::ui {

class ScanController;

/// Progress of a scan with Cancel (Esc); opens when one starts and closes when it ends.
class ScanProgress final : public QDialog {
  Q_OBJECT

 public:
  explicit ScanProgress(ScanController& scan, QWidget* parent = nullptr);
  void reject() override;

 private:
  ScanController& scan_;
  QLabel* text_;
  QProgressBar* bar_;
};

}  // namespace syncline::ui
