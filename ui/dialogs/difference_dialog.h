// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace syncline::ui {

class RunDifference;
class Workspace;

/// Project and running machine, setting by setting; a double click goes to the field.
class DifferenceDialog final : public QDialog {
  Q_OBJECT

 public:
  DifferenceDialog(Workspace& workspace, QWidget* parent);

 Q_SIGNALS:
  void keyWanted(const QString& key);
};

}  // namespace syncline::ui
