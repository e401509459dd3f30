// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QLabel;
class QSpinBox;

namespace syncline::ui {

class Workspace;

/// How many MiB of each network's latest cycles stay in memory, and how much time that is. OK makes it so at once.
class MemoryDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit MemoryDialog(Workspace& workspace, QWidget* parent = nullptr);
  void accept() override;

 private:
  void refresh();

  Workspace& workspace_;
  QSpinBox* mib_;
  QLabel *reach_, *loss_;
};

}  // namespace syncline::ui
