// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace syncline {
struct Project;
}

class QPushButton;

namespace syncline::ui {

class CycleTable;

/// Which bus cycles the slaves of a project accept, who refuses the others and why, and one of them to take.
class CycleDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit CycleDialog(const Project& project, QWidget* parent = nullptr);
  /// ns; 0 unless one was taken.
  [[nodiscard]] qint64 taken() const { return taken_; }

 private:
  void take(qint64 cycle);

  CycleTable* table_;
  QPushButton* use_;
  qint64 own_ = 0, taken_ = 0;
};

}  // namespace syncline::ui
