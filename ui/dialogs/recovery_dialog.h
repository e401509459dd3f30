// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "ui/session/recovery_file.h"

class QListWidget;
class QPushButton;

namespace syncline::ui {

class Autosave;

/// Offers the unsaved work of windows that were killed: of what it is, when it was kept, what was done last.
class RecoveryDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `lost` is not empty.
  RecoveryDialog(Autosave& autosave, std::vector<LostWork> lost, QWidget* parent);

 Q_SIGNALS:
  /// The user wants this one.
  void wanted(const syncline::ui::LostWork& work);

 private:
  void fill();
  void discard();

  Autosave& autosave_;
  std::vector<LostWork> lost_;
  QListWidget* list_;
};

}  // namespace syncline::ui
